#include "claims/cell_measures.hpp"
#include "claims/contest.hpp"
#include "made_up_runs.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_statistics_double.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

using namespace twiddle::claims;
using namespace twiddle::results;
using twiddle::test::runs_of;
using Values = std::vector<double>;

double rotation(const RunMeasures &run)
{
    return run.final_rotation_rad;
}

double variance_of_mean(const Values &values)
{
    return gsl_stats_variance(values.data(), 1, values.size()) / static_cast<double>(values.size());
}

// The interval of one cell's mean. Expected: Student's, with GSL's quantile.
TEST(Contrast, interval_of_one_mean_is_students)
{
    const Values values = {5, 6, 7.5, 9};
    const Runs runs = runs_of(values);
    Contrast contrast("", mean_of(rotation), 1);
    contrast.add(1, {&runs});
    const double half = gsl_cdf_tdist_Pinv(0.975, 3) * std::sqrt(variance_of_mean(values));
    EXPECT_NEAR(contrast.value(), 6.875, 1e-12);
    EXPECT_NEAR(contrast.interval()->lower, 6.875 - half, 1e-9);
    EXPECT_NEAR(contrast.interval()->upper, 6.875 + half, 1e-9);
}

// The interval of a weighted difference of two cells. Expected: Welch's, from its textbook formula.
TEST(Contrast, interval_of_a_difference_is_welchs)
{
    const Values a = {5, 6, 7.5, 9};
    const Values b = {1, 1.5, 4};
    const Runs runs_a = runs_of(a);
    const Runs runs_b = runs_of(b);
    Contrast contrast("", difference_of_means(rotation), 1);
    contrast.add(0.5, {&runs_a, &runs_b});
    const double va = variance_of_mean(a);
    const double vb = variance_of_mean(b);
    const double freedom = (va + vb) * (va + vb) / (va * va / 3 + vb * vb / 2);
    const double half = 0.5 * gsl_cdf_tdist_Pinv(0.975, freedom) * std::sqrt(va + vb);
    const double middle = 0.5 * (6.875 - 6.5 / 3);
    EXPECT_NEAR(contrast.value(), middle, 1e-12);
    EXPECT_NEAR(contrast.interval()->lower, middle - half, 1e-9);
    EXPECT_NEAR(contrast.interval()->upper, middle + half, 1e-9);
}

// A cell that stands in two terms varies once. Expected: (a - b) + (b - c) is a - c, with the same interval.
TEST(Contrast, cell_in_two_terms_counts_once)
{
    const Runs a = runs_of({5, 6, 7.5, 9});
    const Runs b = runs_of({1, 20, -40});
    const Runs c = runs_of({1, 1.5, 4});
    Contrast by_way_of_b("", difference_of_means(rotation), 1);
    by_way_of_b.add(1, {&a, &b});
    by_way_of_b.add(1, {&b, &c});
    Contrast direct("", difference_of_means(rotation), 1);
    direct.add(1, {&a, &c});
    EXPECT_EQ(by_way_of_b.cells().size(), 3U);
    EXPECT_NEAR(by_way_of_b.value(), direct.value(), 1e-12);
    EXPECT_NEAR(by_way_of_b.interval()->lower, direct.interval()->lower, 1e-9);
    EXPECT_NEAR(by_way_of_b.interval()->upper, direct.interval()->upper, 1e-9);
}

// Equal runs have an interval without width; a single run has none.
TEST(Contrast, interval_without_spread_or_without_runs)
{
    const Runs equal = runs_of({2, 2, 2});
    Contrast contrast("", mean_of(rotation), 1);
    contrast.add(1, {&equal});
    EXPECT_EQ(contrast.interval()->lower, 2);
    EXPECT_EQ(contrast.interval()->upper, 2);
    const Runs lone = runs_of({2});
    Contrast of_one("", mean_of(rotation), 1);
    of_one.add(1, {&lone});
    EXPECT_TRUE(of_one.has_runs(0));
    EXPECT_FALSE(of_one.interval());
}

// How often the interval of `measure`, averaged over three pairs of cells with `runs` normal values
// each, holds `truth`.
double coverage(const CellMeasure &measure, std::size_t fewest, std::size_t runs, const std::array<double, 6> &sd,
                double truth)
{
    constexpr int samples = 2000;
    std::mt19937 generator(11);
    int held = 0;
    for (int sample = 0; sample < samples; ++sample) {
        std::vector<Runs> cells;
        for (const double spread : sd) {
            std::normal_distribution<double> normal(0, spread);
            Values values(runs);
            std::generate(values.begin(), values.end(), [&] { return normal(generator); });
            cells.push_back(runs_of(values));
        }
        Contrast contrast("", measure, fewest);
        for (std::size_t i = 0; i < cells.size(); i += 2) {
            contrast.add(1.0 / 3, {&cells[i], &cells[i + 1]});
        }
        const Interval interval = *contrast.interval();
        held += interval.lower <= truth && truth <= interval.upper ? 1 : 0;
    }
    return static_cast<double>(held) / samples;
}

// Of 2,000 samples, the 95 % interval of means must hold the true value in 95 %, to three standard errors of that share
// (1.5 %) and another 1 % because Welch's degrees of freedom are estimated.
TEST(Contrast, interval_of_means_of_four_runs_covers_the_truth)
{
    EXPECT_NEAR(coverage(difference_of_means(rotation), 1, 4, {1, 1, 1, 1, 1, 1}, 0), 0.95, 0.025);
    EXPECT_NEAR(coverage(difference_of_means(rotation), 1, 4, {3, 0.1, 1, 0.5, 0.2, 2}, 0), 0.95, 0.025);
}

// A jackknife of so few runs overstates the variance of their spread: the interval may be too wide, not too narrow.
TEST(Contrast, interval_of_spreads_of_four_runs_is_on_the_safe_side)
{
    EXPECT_GE(coverage(relative_spread, 2, 4, {2, 2, 1, 1, 3, 3}, 0), 0.95 - 0.015);
}

// Nine objects on each of which the first model's resample, of 1 and 3, loses against 2 and 2 with probability 1/4, by
// mean (1) and by best (1). Expected: the quantiles of the binomial distribution, from GSL.
TEST(Contest, interval_is_that_of_the_binomial)
{
    const Runs first = runs_of({1, 3});
    const Runs second = runs_of({2, 2});
    const std::vector<Contest> contests(9, {&first, &second});
    unsigned lower = 0;
    unsigned upper = 0;
    while (gsl_cdf_binomial_P(lower, 0.75, 9) < 0.025) {
        ++lower;
    }
    while (gsl_cdf_binomial_P(upper, 0.75, 9) < 0.975) {
        ++upper;
    }
    for (const Rank rank : {Rank::mean, Rank::best}) {
        EXPECT_EQ(share_won(contests, rank), 1);
        const Interval interval = *interval_of_share_won(contests, rank);
        EXPECT_NEAR(interval.lower, lower / 9.0, 1e-12);
        EXPECT_NEAR(interval.upper, upper / 9.0, 1e-12);
    }
}

// A mean is ranked by the mean and a best run by the best; cells far apart leave no doubt; one run a cell
// leaves no interval.
TEST(Contest, wins_are_counted_by_rank)
{
    const Runs steady = runs_of({5, 5.1});
    const Runs daring = runs_of({0, 9});
    const Runs weak = runs_of({-50, -51});
    const Runs lone = runs_of({7});
    const std::vector<Contest> contests = {{&daring, &steady}, {&steady, &weak}};
    EXPECT_EQ(share_won(contests, Rank::mean), 0.5);
    EXPECT_EQ(share_won(contests, Rank::best), 1);
    EXPECT_EQ(interval_of_share_won({{&steady, &weak}}, Rank::mean)->lower, 1);
    EXPECT_FALSE(interval_of_share_won({{&steady, &lone}}, Rank::mean));
}

// Measures of spread and of mixtures, by hand: sd of 1, 3 is sqrt 2, of 0, 6 is sqrt 18: (1 - 3) / (1 + 3). Pairs of
// runs at distances 1, 1/2, 1/2 that differ by 3, 1, 2 rad: (3 + 1/2 + 1) / 2 = 2.25, over a mean of 8/3.
TEST(CellMeasures, by_hand)
{
    const Runs narrow = runs_of({1, 3});
    const Runs wide = runs_of({0, 6});
    const Runs equal = runs_of({4, 4});
    EXPECT_NEAR(relative_spread({&narrow, &wide}), -0.5, 1e-12);
    EXPECT_EQ(relative_spread({&equal, &equal}), 0);

    Runs mixed = runs_of({1, 4, 3});
    const std::array<Mixture, 3> mixtures = {Mixture{1, 0, 0}, Mixture{0, 1, 0}, Mixture{0.5, 0.5, 0}};
    for (std::size_t i = 0; i < 3; ++i) {
        mixed[i].mixture = MixtureCourse{mixtures[i], std::nullopt, std::nullopt};
    }
    EXPECT_NEAR(score_difference_by_mixture({&mixed}), 2.25 / (8.0 / 3), 1e-12);

    Runs a = runs_of({0, 0});
    Runs b = runs_of({0});
    a[0].frequency = Frequency{0.5, 0.5};
    a[1].frequency = Frequency{1.0, 0.5};
    b[0].frequency = Frequency{0.6, 0.5};
    EXPECT_NEAR(frequency_difference({&a, &b}), (0.1 + 0.4) / 2 / 0.5, 1e-12);
}

} // namespace
