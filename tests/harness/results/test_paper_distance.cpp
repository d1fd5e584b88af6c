#include "results/paper_distance.hpp"
#include "results/paper_distance_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace twiddle::results;

// All of ours a factor e^0.5 above: an error of 0.5, and none once ours are divided by it.
TEST(PaperDistance, a_common_factor_is_an_error_in_rad_and_none_when_scaled)
{
    const double factor = std::exp(0.5);
    const PaperDistance distance = distance_from_paper({{2 * factor, 2}, {5 * factor, 5}});
    EXPECT_EQ(distance.pairs, 2U);
    EXPECT_NEAR(distance.error_rad, 0.5, 1e-12);
    EXPECT_NEAR(distance.scale, std::exp(-0.5), 1e-12);
    EXPECT_NEAR(distance.error_scaled, 0, 1e-7);
}

// Twice and half of the paper's: logarithms of +ln 2 and -ln 2, which no factor brings nearer.
TEST(PaperDistance, opposite_factors_are_not_scaled_away)
{
    const PaperDistance distance = distance_from_paper({{4, 2}, {1, 2}});
    EXPECT_NEAR(distance.error_rad, std::log(2), 1e-12);
    EXPECT_NEAR(distance.scale, 1, 1e-12);
    EXPECT_NEAR(distance.error_scaled, std::log(2), 1e-12);
}

TEST(PaperDistance, no_rotation_and_a_turn_backwards_count_as_the_least_rotation)
{
    const double expected = std::log(2 / least_rotation_rad);
    EXPECT_NEAR(distance_from_paper({{0, 2}}).error_rad, expected, 1e-12);
    EXPECT_NEAR(distance_from_paper({{-3, 2}}).error_rad, expected, 1e-12);
}

TEST(PaperDistance, pairs_are_the_cells_that_the_paper_has_of_the_objects)
{
    PaperValues paper;
    paper.reward[{"small-sphere", true}] = "5.692";
    paper.reward[{"small-sphere", false}] = "2.829";
    paper.with_centre[{"small-sphere", "cpg-h"}] = {"5.686", "0.063", "5.773"};
    paper.with_centre[{"large-cube", "cpg-h"}] = {"3.318", "0.186", "3.529"};
    const std::vector<Cell> cells = {{"", "small-sphere", "cpg-h", true, {4, 6}, {}},
                                     {"", "small-sphere", "cpg-h", false, {3}, {}},
                                     {"", "small-sphere", "cpg-c", false, {1}, {}},
                                     {"slippery", "small-sphere", "cpg-h", true, {9}, {}},
                                     {"", "large-cube", "cpg-h", true, {2}, {}}};
    const std::vector<PaperPair> pairs = paper_pairs(cells, paper, {"small-sphere"});
    ASSERT_EQ(pairs.size(), 2U);
    EXPECT_DOUBLE_EQ(pairs[0].ours_rad, 5);
    EXPECT_DOUBLE_EQ(pairs[0].paper, 5.686);
    EXPECT_DOUBLE_EQ(pairs[1].ours_rad, 3);
    EXPECT_DOUBLE_EQ(pairs[1].paper, 2.829);
}

// The calibration's object is on the paper's value, the held-out one a factor e above: errors 0, 1, and
// sqrt(1/2) over both.
TEST(PaperDistance, held_out_objects_are_judged_apart)
{
    PaperValues paper;
    paper.objects = {"small-sphere", "large-cube", "medium-cube"};
    paper.with_centre[{"small-sphere", "cpg-h"}] = {"2", "", ""};
    paper.with_centre[{"large-cube", "cpg-h"}] = {"1", "", ""};
    const std::vector<Cell> cells = {{"", "small-sphere", "cpg-h", true, {2}, {}},
                                     {"", "large-cube", "cpg-h", true, {std::exp(1.0)}, {}}};
    const std::vector<DistanceRow> rows = distance_table(cells, paper, {"small-sphere"});
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].objects, "calibration");
    EXPECT_NEAR(rows[0].distance.error_rad, 0, 1e-12);
    EXPECT_EQ(rows[1].objects, "held-out");
    EXPECT_NEAR(rows[1].distance.error_rad, 1, 1e-12);
    EXPECT_EQ(rows[2].objects, "all");
    EXPECT_NEAR(rows[2].distance.error_rad, std::sqrt(0.5), 1e-12);
}

} // namespace
