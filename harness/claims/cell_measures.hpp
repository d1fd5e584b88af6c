// cell_measures.hpp: numbers of one cell of runs or of two, as contrasts sum them up (contrast.hpp).
#pragma once

#include "contrast.hpp"

namespace twiddle::claims
{

// What one run yields, in the unit of its field.
using RunNumber = double (*)(const RunMeasures &run);

// Mean over the runs of one cell.
CellMeasure mean_of(RunNumber number);

// Mean over the runs of the first of two cells minus that of the second.
CellMeasure difference_of_means(RunNumber number);

// Of two cells, (a - b) / (a + b) with their standard deviations of the final rotation, -1 to 1; 0 where neither
// spreads. Unlike the ratio's logarithm, of which it is a bounded increasing function, one cell that hardly spreads
// does not outweigh all others. Two runs a cell.
double relative_spread(const std::vector<const Runs *> &cells);

// Of two cells, the mean over pairs of their runs of |f_a - f_b| / range, of their frequencies.
double frequency_difference(const std::vector<const Runs *> &cells);

// Of one cell, the sum over pairs of runs of d |difference of final rotations| / sum of d, over the magnitude of the
// cell's mean, with d the distance of the pair's last mixtures; 0 where no two mixtures differ. Two runs.
double score_difference_by_mixture(const std::vector<const Runs *> &cells);

} // namespace twiddle::claims
