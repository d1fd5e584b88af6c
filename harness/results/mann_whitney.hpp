// mann_whitney.hpp: the Mann-Whitney U test: do the values of one group tend to lie above those of another?
//
// It asks nothing of the values' distribution, but few values bound its p from below: four against four
// give 2/70 at best.
#pragma once

#include <cstddef>
#include <vector>

namespace twiddle::results
{

struct MannWhitney {
    double u = 0;      // pairs (a, b) with a > b, a tie counting one half
    double p = 1;      // two-sided
    bool exact = true; // from all arrangements of the ranks; otherwise from the normal approximation
};

// Groups up to this size, without a tie between any two values, are tested exactly.
constexpr std::size_t exact_group_size = 25;

// Test `a` against `b`, each of at least one finite value. Two-sided: twice the smaller tail, at most 1. The normal
// approximation is corrected for ties and for continuity; where all values are equal, p = 1. (Mann and Whitney, Annals
// of Mathematical Statistics 18, 1947; Lehmann, "Nonparametrics", 1975, ch. 1.)
MannWhitney mann_whitney(const std::vector<double> &a, const std::vector<double> &b);

// The smallest p that exact tests of groups of these sizes, at most exact_group_size each, can give: all of one above
// all of the other.
double smallest_mann_whitney_p(std::size_t a, std::size_t b);

} // namespace twiddle::results
