#include "results/figure_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using namespace twiddle::results;

// `trials` rotations: `first_rad` in the first 50, `later_rad` after.
std::vector<double> rotations(std::size_t trials, double first_rad, double later_rad)
{
    std::vector<double> rotation_rad(trials, later_rad);
    std::fill(rotation_rad.begin(), rotation_rad.begin() + 50, first_rad);
    return rotation_rad;
}

// Three runs of 70 trials; the second is the best at the end, and the worst at the start.
Cell three_runs()
{
    Cell cell{"", "small-sphere", "cpg-h", true, {4, 6, 5}, {}};
    cell.runs = {{"small-sphere/cpg-h/seed-1", 1, rotations(70, 1, 4)},
                 {"small-sphere/cpg-h/seed-2", 2, rotations(70, 0, 6)},
                 {"small-sphere/cpg-h/seed-3", 3, rotations(70, 2, 5)}};
    return cell;
}

Sweep some_sweep(std::uint32_t trials)
{
    Sweep sweep;
    sweep.name = "mine";
    sweep.version = "made-up 0.0";
    sweep.trials = trials;
    return sweep;
}

// The lines of a CSV below its `#` lines.
std::vector<std::string> table_of(const std::string &csv)
{
    std::vector<std::string> lines;
    std::istringstream text(csv);
    for (std::string line; std::getline(text, line);) {
        if (line[0] != '#') lines.push_back(line);
    }
    return lines;
}

// Expected, by hand: the first 50 trials, 1 to 50, have their middle at 25.5 and the runs' means 1, 0, 2; trials 51 to
// 70 at 60.5 and 4, 6, 5; the standard deviation of three numbers one apart is 1.
TEST(FigureData, points_are_means_over_50_trials)
{
    const std::vector<CurvePoint> curve = learning_curve(three_runs());
    ASSERT_EQ(curve.size(), 2U);
    EXPECT_DOUBLE_EQ(curve[0].trial, 25.5);
    EXPECT_DOUBLE_EQ(curve[0].mean_rad, 1);
    EXPECT_DOUBLE_EQ(curve[0].sd_rad.value(), 1);
    EXPECT_DOUBLE_EQ(curve[0].best_run_rad, 0);
    EXPECT_DOUBLE_EQ(curve[1].trial, 60.5);
    EXPECT_DOUBLE_EQ(curve[1].mean_rad, 5);
    EXPECT_DOUBLE_EQ(curve[1].sd_rad.value(), 1);
    EXPECT_DOUBLE_EQ(curve[1].best_run_rad, 6);
}

// Within a point, trials count alike: of 0, 1, ..., 49 the mean is 24.5.
TEST(FigureData, point_is_the_mean_of_its_trials)
{
    Cell cell{"", "small-sphere", "cpg-h", true, {49}, {}};
    cell.runs = {{"small-sphere/cpg-h/seed-1", 1, {}}};
    for (int trial = 0; trial < 100; ++trial) {
        cell.runs[0].trial_rotation_rad.push_back(trial);
    }
    const std::vector<CurvePoint> curve = learning_curve(cell);
    ASSERT_EQ(curve.size(), 2U);
    EXPECT_DOUBLE_EQ(curve[0].mean_rad, 24.5);
    EXPECT_DOUBLE_EQ(curve[1].mean_rad, 74.5);
    EXPECT_FALSE(curve[0].sd_rad.has_value()) << "a single run has no spread";
}

// Runs of fewer than 50 trials have one point, at the middle of all.
TEST(FigureData, short_runs_have_one_point)
{
    Cell cell{"", "small-sphere", "cpg-h", true, {2}, {}};
    cell.runs = {{"small-sphere/cpg-h/seed-1", 1, {1, 2, 3}}};
    const std::vector<CurvePoint> curve = learning_curve(cell);
    ASSERT_EQ(curve.size(), 1U);
    EXPECT_DOUBLE_EQ(curve[0].trial, 2);
    EXPECT_DOUBLE_EQ(curve[0].mean_rad, 2);
}

// The highest rotation at the end comes first; of equal ones the one that is listed first.
TEST(FigureData, ranking_is_by_the_end)
{
    EXPECT_EQ(ranking(three_runs()), (std::vector<std::size_t>{1, 2, 0}));
    Cell equal = three_runs();
    equal.rotation_rad = {3, 3, 3};
    EXPECT_EQ(ranking(equal), (std::vector<std::size_t>{0, 1, 2}));
}

// The tables have a row a point, and a row for each of a cell's two best runs; what is not there is empty.
TEST(FigureData, tables_have_a_row_a_point_and_a_row_a_run)
{
    Cell lone{"slippery", "large-cube", "cpg-c", false, {7}, {}};
    lone.runs = {{"slippery/large-cube/cpg-c-no-centre/seed-1", 1, rotations(70, 7, 7)}};
    const std::vector<Cell> cells = {three_runs(), lone};
    EXPECT_EQ(table_of(learning_curves_csv(some_sweep(70), cells)),
              (std::vector<std::string>{
                  "variant,object,model,centre,runs,trial,mean_rad,sd_rad,best_run_rad",
                  ",small-sphere,cpg-h,true,3,25.5,1,1,0", ",small-sphere,cpg-h,true,3,60.5,5,1,6",
                  "slippery,large-cube,cpg-c,false,1,25.5,7,,7", "slippery,large-cube,cpg-c,false,1,60.5,7,,7"}));
    EXPECT_EQ(table_of(best_runs_csv(some_sweep(70), cells)),
              (std::vector<std::string>{"variant,object,model,centre,rank,seed,folder,rotation_rad",
                                        ",small-sphere,cpg-h,true,1,2,small-sphere/cpg-h/seed-2,6",
                                        ",small-sphere,cpg-h,true,2,3,small-sphere/cpg-h/seed-3,5",
                                        "slippery,large-cube,cpg-c,false,1,1,"
                                        "slippery/large-cube/cpg-c-no-centre/seed-1,7"}));
    EXPECT_NE(best_runs_csv(some_sweep(70), cells).find("over all 70 trials"), std::string::npos);
}

} // namespace
