// statistics.hpp: what is said about a handful of runs: mean, spread, how sure the mean is, and whether
// two groups differ.
//
// Values are plain numbers; each result has the unit of its input, p-values have none. Every input must be finite.
#pragma once

#include <cstddef>
#include <vector>

namespace twiddle::results
{

// At least one value.
double mean(const std::vector<double> &values);

// Of a sample, with n - 1; at least two values.
double standard_deviation(const std::vector<double> &values);

// The value below which `share`, 0 to 1, of the sorted values lies, on the straight line between two of them. At
// least one value.
double quantile_of_sorted(const std::vector<double> &sorted, double share);

struct Interval {
    double lower = 0;
    double upper = 0;
};

constexpr std::size_t bootstrap_resamples = 10'000;

// The 95 % percentile bootstrap interval of the mean (Efron and Tibshirani, "An Introduction to the Bootstrap", 1993,
// ch. 13): the 2.5 % and 97.5 % quantiles of the means of `bootstrap_resamples` resamples. At least two values; the
// same values in the same order give the same interval. It is too narrow for few values: for four of a normal
// distribution it covers the mean in 81 of 100 samples (|t| of 3 degrees of freedom is below 1.96 sqrt(3 / 4); measured
// over 2,000 samples, 80.6 %).
Interval bootstrap_interval_of_mean(const std::vector<double> &values);

// Values of one quantity under two conditions in one cell, in no pairs; at least one of each, two for an interval.
struct CellChange {
    std::vector<double> changed;
    std::vector<double> base;
};

// The mean over the cells, at least one, of the difference of each cell's means, changed less base.
double mean_difference(const std::vector<CellChange> &cells);

// Its 95 % percentile bootstrap interval: each resample draws anew within every group of every cell. Too narrow for few
// values, as above: groups of n give it sqrt((n - 1) / n) of the standard error, 0.89 for five.
Interval bootstrap_interval_of_mean_difference(const std::vector<CellChange> &cells);

// The p-values after Holm's step-down correction (Scandinavian Journal of Statistics 6, 1979), in the order given: the
// i-th smallest of m times m + 1 - i, never below a smaller one's, at most 1.
std::vector<double> holm_corrected(const std::vector<double> &p_values);

} // namespace twiddle::results
