// contest.hpp: on how many objects a model wins, and how sure that count is.
//
// A count moves in steps, so that no formula for smooth numbers serves; its interval is a bootstrap's.
#pragma once

#include "results/statistics.hpp"
#include "run_grid.hpp"

#include <optional>
#include <vector>

namespace twiddle::claims
{

// One object's cells; the first is the model whose wins are counted. Not null, at least one run each.
using Contest = std::vector<const Runs *>;

// What a cell is ranked by. All rank by the final rotation.
enum class Rank { mean, best };

// The share of `contests`, of which there is at least one, that the first model wins: it ranks at or above all others.
double share_won(const std::vector<Contest> &contests, Rank rank);

// Its 95 % percentile interval from bootstrap_resamples resamples of the runs within each cell, seeded; nothing unless
// every cell has two runs. The resampled means' distances from the cell's mean are widened by sqrt(n / (n - 1)) t / z,
// with Student's t of n - 1 degrees of freedom and the normal z at 97.5 %: each cell's own percentile interval is then
// about Student's, where the plain one is too narrow for few runs (statistics.hpp). The best of a resample is taken as
// it is: it is never above the best run seen.
std::optional<results::Interval> interval_of_share_won(const std::vector<Contest> &contests, Rank rank);

} // namespace twiddle::claims
