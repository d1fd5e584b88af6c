// figure_data.hpp: the numbers of a sweep's figures that its runs' files do not hold as they are, since the figures'
// scripts compute nothing.
#pragma once

#include "sweep_results.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace twiddle::results
{

// Trials that make one point of a learning curve; the last point has what is left.
constexpr std::uint32_t trials_a_point = 50;

// A point of a learning curve. A run counts with its mean rotation over the point's trials.
struct CurvePoint {
    double trial = 0; // mean of the point's first and last trial
    double mean_rad = 0;
    std::optional<double> sd_rad; // of the runs, with n - 1; nothing for a single run
    double best_run_rad = 0;      // of the run that is the cell's best by its last trials
};

// The learning curve of a cell, in the order of the trials.
std::vector<CurvePoint> learning_curve(const Cell &cell);

// The cell's runs by the mean rotation over their last trials, the highest first, as indices; of equal ones the
// earlier listed first.
std::vector<std::size_t> ranking(const Cell &cell);

// The text of learning_curves.csv: a row a point, cell by cell.
std::string learning_curves_csv(const Sweep &sweep, const std::vector<Cell> &cells);

// The text of best_runs.csv: the two best runs of each cell, and their folders.
std::string best_runs_csv(const Sweep &sweep, const std::vector<Cell> &cells);

} // namespace twiddle::results
