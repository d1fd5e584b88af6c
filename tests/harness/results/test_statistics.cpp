#include "results/mann_whitney.hpp"
#include "results/statistics.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <random>
#include <utility>

namespace
{

using namespace twiddle::results;
using Values = std::vector<double>;

Values normal_values(std::size_t count, double mean, double sd, unsigned seed)
{
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal(mean, sd);
    Values values(count);
    std::generate(values.begin(), values.end(), [&] { return normal(generator); });
    return values;
}

// Two groups without ties whose U is `u`: of b = 1, 2, ..., some values of a lie above all, one above the rest of u,
// others below all.
std::pair<Values, Values> groups_with_u(std::size_t a_size, std::size_t b_size, std::size_t u)
{
    Values a;
    Values b;
    for (std::size_t i = 0; i < b_size; ++i) {
        b.push_back(static_cast<double>(i + 1));
    }
    for (std::size_t i = 0; i < a_size; ++i) {
        const std::size_t below = std::min(b_size, u);
        u -= below;
        a.push_back(static_cast<double>(below) + 0.5 + 0.001 * static_cast<double>(i));
    }
    return {a, b};
}

// Mean and standard deviation. Expected: GSL's.
TEST(Statistics, mean_and_spread_are_those_of_gsl)
{
    for (const std::size_t count : {2U, 4U, 20U, 1000U}) {
        const Values values = normal_values(count, 5, 2, static_cast<unsigned>(count));
        EXPECT_NEAR(mean(values), gsl_stats_mean(values.data(), 1, count), 1e-12);
        EXPECT_NEAR(standard_deviation(values), gsl_stats_sd(values.data(), 1, count), 1e-12);
    }
}

// Of a large normal sample, the interval is the normal theory's. Expected: mean +- 1.96 standard errors; a quantile of
// 10,000 resamples is known to sqrt(0.025 0.975 / 10000) / 0.0584 = 0.027 standard errors, of which four are allowed.
TEST(Statistics, bootstrap_of_a_large_sample_is_the_normal_theorys)
{
    const Values values = normal_values(2000, 3, 1.5, 7);
    const double error = gsl_stats_sd(values.data(), 1, values.size()) / std::sqrt(2000.0);
    const double middle = gsl_stats_mean(values.data(), 1, values.size());
    const double half = gsl_cdf_ugaussian_Pinv(0.975) * error;
    const Interval interval = bootstrap_interval_of_mean(values);
    EXPECT_NEAR(interval.lower, middle - half, 0.11 * error);
    EXPECT_NEAR(interval.upper, middle + half, 0.11 * error);
}

// Of four values, the interval's ends are those of all 256 resamples, which the test makes. The values' means are far
// enough apart that no end lies near a step of the distribution.
TEST(Statistics, bootstrap_of_four_values_is_that_of_all_resamples)
{
    const Values values = {5, 6, 7, 8};
    Values means;
    for (std::size_t i = 0; i < 256; ++i) {
        means.push_back((values[i % 4] + values[i / 4 % 4] + values[i / 16 % 4] + values[i / 64]) / 4);
    }
    std::sort(means.begin(), means.end());
    const Interval interval = bootstrap_interval_of_mean(values);
    EXPECT_EQ(interval.lower, gsl_stats_quantile_from_sorted_data(means.data(), 1, means.size(), 0.025));
    EXPECT_EQ(interval.upper, gsl_stats_quantile_from_sorted_data(means.data(), 1, means.size(), 0.975));
    const Interval again = bootstrap_interval_of_mean(values);
    EXPECT_EQ(again.lower, interval.lower);
    EXPECT_EQ(again.upper, interval.upper);
}

// Equal values have an interval without width.
TEST(Statistics, bootstrap_of_equal_values_has_no_width)
{
    const Interval interval = bootstrap_interval_of_mean({2, 2, 2});
    EXPECT_EQ(interval.lower, 2);
    EXPECT_EQ(interval.upper, 2);
}

// Of n cells with 0 and 4 changed and 0 and 0 before, each cell's resampled difference is 0, 2 or 4 with 1/4, 1/2, 1/4.
// Expected, by hand: for one and two cells the ends have more than 2.5 % each, (1/4)^n, and are the interval's; for
// three they have 1.6 %, and the next values, 2/3 from the ends, have 11 % with them.
TEST(Statistics, bootstrap_of_differences_is_that_of_all_resamples)
{
    const std::vector<Values> expected = {{0, 4}, {0, 4}, {2.0 / 3, 10.0 / 3}};
    for (std::size_t cells = 1; cells <= expected.size(); ++cells) {
        const std::vector<CellChange> risen(cells, {{0, 4}, {0, 0}});
        const std::vector<CellChange> fallen(cells, {{0, 0}, {0, 4}});
        EXPECT_EQ(mean_difference(risen), 2);
        EXPECT_EQ(mean_difference(fallen), -2);
        const Interval up = bootstrap_interval_of_mean_difference(risen);
        EXPECT_NEAR(up.lower, expected[cells - 1][0], 1e-12) << cells;
        EXPECT_NEAR(up.upper, expected[cells - 1][1], 1e-12) << cells;
        const Interval down = bootstrap_interval_of_mean_difference(fallen);
        EXPECT_NEAR(down.lower, -expected[cells - 1][1], 1e-12) << cells;
        EXPECT_NEAR(down.upper, -expected[cells - 1][0], 1e-12) << cells;
    }
    EXPECT_EQ(mean_difference({{{1, 3}, {0}}, {{5}, {4, 8}}}), 0.5); // (2 - 1) / 2
}

// Of large normal samples, the interval is the normal theory's. Expected: the difference +- 1.96 standard errors, of
// which one end is known to 0.027 and 0.11 is allowed, as above; the cells' errors add in squares.
TEST(Statistics, bootstrap_of_large_differences_is_the_normal_theorys)
{
    const std::vector<CellChange> cells = {{normal_values(500, 3, 1.5, 7), normal_values(700, 2, 1, 8)},
                                           {normal_values(600, 9, 2.5, 9), normal_values(400, 9, 3, 10)}};
    double variance = 0;
    for (const CellChange &cell : cells) {
        for (const Values &values : {cell.changed, cell.base}) {
            variance += gsl_stats_variance(values.data(), 1, values.size()) / static_cast<double>(values.size()) / 4;
        }
    }
    const double error = std::sqrt(variance);
    const double half = gsl_cdf_ugaussian_Pinv(0.975) * error;
    const Interval interval = bootstrap_interval_of_mean_difference(cells);
    EXPECT_NEAR(interval.lower, mean_difference(cells) - half, 0.11 * error);
    EXPECT_NEAR(interval.upper, mean_difference(cells) + half, 0.11 * error);
}

// Holm's correction. Expected, by hand: 4 x 0.005, 3 x 0.01, 2 x 0.03, and 0.06 again for 0.04; never above 1.
TEST(Statistics, holm_is_the_step_down_by_hand)
{
    const Values corrected = holm_corrected({0.01, 0.04, 0.03, 0.005});
    const Values expected = {0.03, 0.06, 0.06, 0.02};
    ASSERT_EQ(corrected.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(corrected[i], expected[i], 1e-15) << i;
    }
    EXPECT_EQ(holm_corrected({0.5, 0.9, 0.7}), (Values{1, 1, 1}));
    EXPECT_EQ(holm_corrected({0.25}), Values{0.25});
    EXPECT_TRUE(holm_corrected({}).empty());
}

// The exact p. Expected: from every way to choose which of the values 0, 1, ... are a's, twice the share of those with
// U at least as far out, at most 1.
TEST(MannWhitney, exact_p_is_that_of_all_arrangements)
{
    for (std::size_t a_size = 1; a_size <= 6; ++a_size) {
        for (std::size_t b_size = 1; b_size <= 6; ++b_size) {
            std::vector<double> count(a_size * b_size + 1, 0);
            double arrangements = 0;
            for (unsigned chosen = 0; chosen < 1U << (a_size + b_size); ++chosen) {
                const std::bitset<12> of_a(chosen);
                if (of_a.count() != a_size) continue;
                std::size_t u = 0;
                std::size_t of_b_below = 0;
                for (std::size_t value = 0; value < a_size + b_size; ++value) {
                    if (of_a[value]) u += of_b_below;
                    if (!of_a[value]) ++of_b_below;
                }
                ++count[u];
                ++arrangements;
            }
            for (std::size_t u = 0; u < count.size(); ++u) {
                double lower = 0;
                double upper = 0;
                for (std::size_t other = 0; other < count.size(); ++other) {
                    if (other <= u) lower += count[other];
                    if (other >= u) upper += count[other];
                }
                const auto [a, b] = groups_with_u(a_size, b_size, u);
                const MannWhitney test = mann_whitney(a, b);
                EXPECT_TRUE(test.exact);
                EXPECT_EQ(test.u, static_cast<double>(u));
                EXPECT_NEAR(test.p, std::min(1.0, 2 * std::min(lower, upper) / arrangements), 1e-12)
                    << a_size << " against " << b_size << ", U " << u;
            }
        }
    }
}

// Expected: the two-sided 5 % critical values of the published tables (the largest U that is significant).
TEST(MannWhitney, critical_values_are_the_tables)
{
    const std::vector<std::array<std::size_t, 3>> table = {{4, 4, 0},    {5, 5, 2},    {6, 6, 5},    {7, 7, 8},
                                                           {8, 8, 13},   {9, 9, 17},   {10, 10, 23}, {12, 12, 37},
                                                           {15, 15, 64}, {20, 20, 127}};
    for (const auto &[a_size, b_size, critical] : table) {
        const auto [a, b] = groups_with_u(a_size, b_size, critical);
        const auto [next_a, next_b] = groups_with_u(a_size, b_size, critical + 1);
        EXPECT_LE(mann_whitney(a, b).p, 0.05) << a_size;
        EXPECT_GT(mann_whitney(next_a, next_b).p, 0.05) << a_size;
    }
}

// Expected: Hollander and Wolfe, "Nonparametric Statistical Methods", the permeability of human membranes: U = 35,
// one-sided p 0.1272.
TEST(MannWhitney, permeability_example_of_hollander_and_wolfe)
{
    const MannWhitney test =
        mann_whitney({0.80, 0.83, 1.89, 1.04, 1.45, 1.38, 1.91, 1.64, 0.73, 1.46}, {1.15, 0.88, 0.90, 0.74, 1.21});
    EXPECT_EQ(test.u, 35);
    EXPECT_NEAR(test.p, 2 * 0.1272, 2 * 0.00005);
}

// Four against four. Expected: 2 of 70 arrangements, in either direction.
TEST(MannWhitney, four_against_four_is_at_best_one_in_35)
{
    EXPECT_NEAR(smallest_mann_whitney_p(4, 4), 2.0 / 70, 1e-15);
    EXPECT_NEAR(mann_whitney({1, 2, 3, 4}, {5, 6, 7, 8}).p, 2.0 / 70, 1e-15);
    EXPECT_NEAR(mann_whitney({5, 6, 7, 8}, {1, 2, 3, 4}).p, 2.0 / 70, 1e-15);
}

// With ties. Expected, by hand, with GSL's normal distribution: a = 1 2 2 3, b = 2 4 4 5 6 has
// U = 0 + 1/2 + 1/2 + 1 = 2, ties of three and two, variance 20 / 12 (10 - (24 + 6) / 72), and a distance
// of 10 - 2 - 1/2.
TEST(MannWhitney, ties_are_corrected_for)
{
    const MannWhitney test = mann_whitney({1, 2, 2, 3}, {2, 4, 4, 5, 6});
    EXPECT_FALSE(test.exact);
    EXPECT_EQ(test.u, 2);
    const double variance = 20.0 / 12 * (10 - 30.0 / 72);
    EXPECT_NEAR(test.p, 2 * gsl_cdf_ugaussian_Q(7.5 / std::sqrt(variance)), 1e-12);
    EXPECT_EQ(mann_whitney({3, 3}, {3, 3, 3}).p, 1);
}

// Just above the size of exact tests the approximation takes over smoothly. Expected: within 0.002 of the exact p of
// one value fewer a group, at the same standardised distance.
TEST(MannWhitney, large_groups_are_approximated)
{
    const Values a = normal_values(exact_group_size + 1, 0, 1, 3);
    const Values b = normal_values(exact_group_size + 1, 0.6, 1, 4);
    const MannWhitney test = mann_whitney(a, b);
    EXPECT_FALSE(test.exact);
    const double size = static_cast<double>(exact_group_size);
    const auto spread = [](double n) { return std::sqrt(n * n * (2 * n + 1) / 12); };
    const double distance = std::abs(test.u - (size + 1) * (size + 1) / 2) * spread(size) / spread(size + 1);
    const auto [nearest_a, nearest_b] = groups_with_u(
        exact_group_size, exact_group_size, static_cast<std::size_t>(std::lround(size * size / 2 - distance)));
    const MannWhitney exact = mann_whitney(nearest_a, nearest_b);
    EXPECT_TRUE(exact.exact);
    EXPECT_NEAR(test.p, exact.p, 0.002);
}

} // namespace
