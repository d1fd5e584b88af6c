#include "claims/claims.hpp"
#include "made_up_runs.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace
{

using namespace twiddle::claims;
using namespace twiddle::results;
using twiddle::test::runs_of;

const std::vector<std::string> nine_objects = {"small-sphere",  "small-cylinder",  "small-cube",
                                               "medium-sphere", "medium-cylinder", "medium-cube",
                                               "large-sphere",  "large-cylinder",  "large-cube"};

PaperValues paper_values()
{
    return read_paper_values(TWIDDLE_PAPER);
}

// Four runs at -spread, 0, 0, +spread around `middle`.
Runs around(double middle, double spread)
{
    return runs_of({middle - spread, middle, middle, middle + spread});
}

// All cells of the nine objects, with centre at `middle` for every model and CPG-H without.
RunGrid even_grid(double middle)
{
    RunGrid grid{nine_objects, {}};
    for (const std::string &object : nine_objects) {
        for (const char *model : {"cpg-s", "cpg-m", "cpg-c", "cpg-h"}) {
            grid.cells[{object, model, true}] = around(middle, 0.1);
        }
        grid.cells[{object, "cpg-h", false}] = around(middle, 0.1);
    }
    return grid;
}

PartResult result_of(const RunGrid &grid, const std::string &part)
{
    for (const ClaimResult &claim : test_claims(grid, paper_values())) {
        for (const PartResult &result : claim.parts) {
            if (result.part->part == part) return result;
        }
    }
    ADD_FAILURE() << "no part " << part;
    return {};
}

void set_runs(RunGrid &grid, const std::function<void(RunMeasures &, const std::string &model)> &change)
{
    for (auto &[key, runs] : grid.cells) {
        for (RunMeasures &run : runs) {
            change(run, std::get<1>(key));
        }
    }
}

// The list is whole: ten claims in order, every part once, and no text that would break claims.csv or a Markdown table.
TEST(Claims, list_is_whole)
{
    std::set<std::string> parts;
    int claim = 1;
    for (const ClaimPart &part : claim_parts()) {
        EXPECT_TRUE(part.claim == claim || part.claim == claim + 1) << part.part;
        claim = part.claim;
        EXPECT_TRUE(parts.insert(part.part).second) << part.part;
        for (const std::string text : {part.words, part.measure, part.unit}) {
            EXPECT_EQ(text.find_first_of(",|\n"), std::string::npos) << text;
        }
    }
    EXPECT_EQ(claim, 10);
    EXPECT_EQ(claims_in_words().size(), 10U);
}

// The rule of the verdict, on both sides of a bound.
TEST(Claims, verdict_follows_the_interval)
{
    Estimate estimate;
    EXPECT_EQ(verdict_of(estimate, 0, Side::above), Verdict::not_measured);
    estimate.value = 1;
    estimate.interval = Interval{0.5, 1.5};
    EXPECT_EQ(verdict_of(estimate, 0, Side::above), Verdict::supported);
    EXPECT_EQ(verdict_of(estimate, 0, Side::below), Verdict::not_supported);
    EXPECT_EQ(verdict_of(estimate, 1.2, Side::above), Verdict::undecided);
    EXPECT_EQ(verdict_of(estimate, 1.2, Side::below), Verdict::undecided);
    EXPECT_EQ(verdict_of(estimate, 2, Side::above), Verdict::not_supported);
    EXPECT_EQ(verdict_of(estimate, 2, Side::below), Verdict::supported);
    EXPECT_EQ(verdict_of(estimate, 0.5, Side::above), Verdict::undecided);
}

TEST(Claims, overall_verdict_follows_the_parts)
{
    const Verdict yes = Verdict::supported;
    const Verdict no = Verdict::not_supported;
    const Verdict open = Verdict::undecided;
    const Verdict none = Verdict::not_measured;
    EXPECT_EQ(overall_verdict({yes, yes}), yes);
    EXPECT_EQ(overall_verdict({yes, no, none}), no);
    EXPECT_EQ(overall_verdict({yes, open}), open);
    EXPECT_EQ(overall_verdict({yes, none}), open);
    EXPECT_EQ(overall_verdict({none, none}), none);
}

// The paper's own values. Expected, worked out from its printed tables: 1: 3.700 - 3.274; 2a: five objects of nine; 2b:
// all but large sphere and cylinder; 4, 5: the twelve means of the small objects sum to 51.606, of the medium 49.444,
// of the large 39.774, of the spheres 48.270, the cylinders 47.643, the cubes 44.911; 9:
// (2.863 + 1.575 + 0.800 - 0.557 - 0.471 - 1.542) / 3; 10a: from the table by another program; 10b: large cylinder,
// CPG-C against CPG-H; 10c: CPG-M against CPG-H.
TEST(Claims, papers_values_are_those_of_its_tables)
{
    const std::vector<std::pair<std::string, double>> expected = {{"1", 0.426},
                                                                  {"2a", 5.0 / 9},
                                                                  {"2b", 7.0 / 9},
                                                                  {"4a", (51.606 - 49.444) / 12},
                                                                  {"4b", (49.444 - 39.774) / 12},
                                                                  {"5a", (48.270 - 47.643) / 12},
                                                                  {"5b", (47.643 - 44.911) / 12},
                                                                  {"9", 2.668 / 3},
                                                                  {"10a", 0.474585508181},
                                                                  {"10b", 0.114},
                                                                  {"10c", 0.226}};
    const RunGrid grid = even_grid(1);
    std::size_t with_value = 0;
    for (const ClaimResult &claim : test_claims(grid, paper_values())) {
        for (const PartResult &result : claim.parts) {
            with_value += result.paper.value ? 1 : 0;
        }
    }
    EXPECT_EQ(with_value, expected.size());
    for (const auto &[part, value] : expected) {
        EXPECT_NEAR(*result_of(grid, part).paper.value, value, 1e-9) << part;
    }
}

// The paper's own interval. Expected, by hand, for CPG-M against CPG-H on the medium cube, 4.781 +- 0.035 against 4.555
// +- 0.982, four runs each: 0.226 -+ t sqrt((0.035^2 + 0.982^2) / 4) with t = 3.178 at 3.008 degrees of freedom.
// Spreads have none.
TEST(Claims, papers_interval_is_that_of_its_spread)
{
    const PartResult result = result_of(even_grid(1), "10c");
    EXPECT_NEAR(result.paper.interval->lower, 0.226 - 3.178 * 0.4913, 1e-3);
    EXPECT_EQ(result.paper_verdict, Verdict::undecided);
    EXPECT_FALSE(result_of(even_grid(1), "10a").paper.interval);
    EXPECT_FALSE(result_of(even_grid(1), "1").paper.interval);
}

// Claim 1 asks for every object: one that is worse without doubt decides against it, one in doubt leaves it open. The
// interval of a difference of two cells -0.1, 0, 0, 0.1 around their means is -+ 2.447 sqrt(2 x 0.02 / 3 / 4) = 0.141
// (Student's t, six degrees of freedom).
TEST(Claims, every_object_must_gain_by_the_centre)
{
    RunGrid grid = even_grid(2);
    for (const std::string &object : nine_objects) {
        grid.cells[{object, "cpg-h", false}] = around(1, 0.1);
    }
    PartResult result = result_of(grid, "1");
    EXPECT_EQ(result.verdict, Verdict::supported);
    EXPECT_NEAR(*result.estimate.value, 1, 1e-12);
    EXPECT_NEAR(result.estimate.interval->lower, 1 - 0.1413, 1e-4);
    EXPECT_NEAR(result.estimate.interval->upper, 1 + 0.1413, 1e-4);
    EXPECT_EQ(result.estimate.components.size(), 9U);
    EXPECT_EQ(result.estimate.runs, 72U);
    EXPECT_EQ(result.estimate.objects, 9U);

    grid.cells[{"large-cube", "cpg-h", false}] = around(1.9, 0.1);
    EXPECT_EQ(result_of(grid, "1").verdict, Verdict::undecided);
    grid.cells[{"small-cube", "cpg-h", false}] = around(3, 0.1);
    result = result_of(grid, "1");
    EXPECT_EQ(result.verdict, Verdict::not_supported);
    EXPECT_NEAR(*result.estimate.value, -1, 1e-12);
}

// Wins without doubt: on all nine objects, then on six, which is most and not nearly all.
TEST(Claims, objects_won_are_counted)
{
    RunGrid grid = even_grid(1);
    for (const std::string &object : nine_objects) {
        grid.cells[{object, "cpg-h", true}] = around(5, 0.1);
    }
    EXPECT_EQ(result_of(grid, "2a").verdict, Verdict::supported);
    EXPECT_EQ(result_of(grid, "2b").verdict, Verdict::supported);
    for (const char *object : {"small-cube", "medium-cube", "large-cube"}) {
        grid.cells[{object, "cpg-m", true}] = around(9, 0.1);
    }
    EXPECT_EQ(result_of(grid, "2a").verdict, Verdict::supported);
    const PartResult best = result_of(grid, "2b");
    EXPECT_EQ(best.verdict, Verdict::not_supported);
    EXPECT_NEAR(*best.estimate.value, 6.0 / 9, 1e-12);
    EXPECT_EQ(result_of(grid, "10c").verdict, Verdict::supported);
    EXPECT_NEAR(*result_of(grid, "10c").estimate.value, 4, 1e-12);
}

// Rotations that depend on size and shape alone: small 3, medium 2, large 2.5 rad, and cylinders 0.5 above the others.
TEST(Claims, size_and_shape_are_compared)
{
    RunGrid grid = even_grid(0);
    for (auto &[key, runs] : grid.cells) {
        const std::string &object = std::get<0>(key);
        const double of_size = object[0] == 's' ? 3 : object[0] == 'm' ? 2 : 2.5;
        runs = around(of_size + (object.find("cylinder") != std::string::npos ? 0.5 : 0), 0.1);
    }
    const std::vector<std::tuple<std::string, double, Verdict>> expected = {{"4a", 1, Verdict::supported},
                                                                            {"4b", -0.5, Verdict::not_supported},
                                                                            {"5a", -0.5, Verdict::not_supported},
                                                                            {"5b", 0.5, Verdict::supported}};
    for (const auto &[part, value, verdict] : expected) {
        const PartResult result = result_of(grid, part);
        EXPECT_NEAR(*result.estimate.value, value, 1e-12) << part;
        EXPECT_EQ(result.verdict, verdict) << part;
    }
}

// Gains by the centre of 2 rad on small, 1 on medium, 0.5 on large objects.
TEST(Claims, centre_helps_most_on_small_objects)
{
    RunGrid grid = even_grid(3);
    for (const std::string &object : nine_objects) {
        const double gain = object[0] == 's' ? 2 : object[0] == 'm' ? 1 : 0.5;
        grid.cells[{object, "cpg-h", false}] = around(3 - gain, 0.1);
    }
    const PartResult result = result_of(grid, "9");
    EXPECT_NEAR(*result.estimate.value, 1.5, 1e-12);
    EXPECT_EQ(result.verdict, Verdict::supported);
    EXPECT_EQ(result.estimate.objects, 6U);
}

// CPG-S needs a quarter of CPG-H's trials, the others twice as many: against CPG-S the claim fails by two doublings.
TEST(Claims, fastest_is_faster_than_every_single_model)
{
    RunGrid grid = even_grid(1);
    set_runs(grid, [](RunMeasures &run, const std::string &model) {
        run.log2_trials_to_80 = model == "cpg-h" ? 10 : model == "cpg-s" ? 8 : 11;
        run.mean_rotation_rad = model == "cpg-h" ? 2 : 1;
    });
    const PartResult trials = result_of(grid, "3a");
    EXPECT_NEAR(*trials.estimate.value, -2, 1e-12);
    EXPECT_EQ(trials.verdict, Verdict::not_supported);
    EXPECT_NEAR(trials.estimate.components[1].value, 1, 1e-12);
    EXPECT_EQ(result_of(grid, "3b").verdict, Verdict::supported);
}

// Fingers: CPG-H shares 0.4 : 0.6 in opposite phase, the singles turn with one finger but for CPG-M.
TEST(Claims, fingers_are_judged_on_the_small_sphere)
{
    RunGrid grid = even_grid(1);
    for (const auto &[model, share] : {std::pair("cpg-h", 0.4), {"cpg-s", 0.0}, {"cpg-m", 0.3}, {"cpg-c", 0.1}}) {
        for (RunMeasures &run : grid.cells[{"small-sphere", model, true}]) {
            run.fingers = FingerUse{share, model == std::string("cpg-h") ? 0.45 : 0.0};
        }
    }
    EXPECT_EQ(result_of(grid, "6a").verdict, Verdict::supported);
    EXPECT_EQ(result_of(grid, "6b").verdict, Verdict::supported);
    const PartResult singles = result_of(grid, "6c");
    EXPECT_EQ(singles.verdict, Verdict::not_supported);
    EXPECT_NEAR(*singles.estimate.value, 0.3, 1e-12);
    for (RunMeasures &run : grid.cells[{"small-sphere", "cpg-m", true}]) {
        run.fingers->lesser_share = 0.2;
    }
    EXPECT_EQ(result_of(grid, "6c").verdict, Verdict::supported);
    grid.cells[{"small-sphere", "cpg-m", true}][1].fingers = std::nullopt;
    const PartResult lacking = result_of(grid, "6c");
    EXPECT_EQ(lacking.verdict, Verdict::not_measured);
    EXPECT_EQ(lacking.estimate.missing, "1 of the runs lack trajectory.csv or a frequency; the first is run-2");
}

// Mixtures that move by 0.3 before trial 2,000 and by 0.1 after it, end at 0.5 : 0.3 : 0.2 in two runs and 0.2 : 0.3 :
// 0.5 in the others, with the same rotations.
TEST(Claims, mixtures_are_judged_over_the_objects)
{
    RunGrid grid = even_grid(2);
    for (const std::string &object : nine_objects) {
        Runs &runs = grid.cells[{object, "cpg-h", true}];
        for (std::size_t i = 0; i < runs.size(); ++i) {
            runs[i].final_rotation_rad = 2 + 0.01 * static_cast<double>(i);
            const Mixture last = i < 2 ? Mixture{0.5, 0.3, 0.2} : Mixture{0.2, 0.3, 0.5};
            const Mixture middle = {last[0], last[1] - 0.1, last[2] + 0.1};
            const Mixture first = {middle[0], middle[1] + 0.3, middle[2] - 0.3};
            runs[i].mixture = MixtureCourse{last, first, middle};
        }
    }
    EXPECT_NEAR(*result_of(grid, "7a").estimate.value, 0.5, 1e-12);
    EXPECT_EQ(result_of(grid, "7a").verdict, Verdict::supported);
    EXPECT_NEAR(*result_of(grid, "7b").estimate.value, 0.2, 1e-12);
    EXPECT_EQ(result_of(grid, "7b").verdict, Verdict::supported);
    EXPECT_NEAR(*result_of(grid, "7c").estimate.value, 0.02 / 2.015, 1e-12);
    EXPECT_EQ(result_of(grid, "7c").verdict, Verdict::supported);
    for (const std::string &object : nine_objects) {
        for (RunMeasures &run : grid.cells[{object, "cpg-h", true}]) {
            run.mixture->first = std::nullopt;
        }
    }
    EXPECT_EQ(result_of(grid, "7b").verdict, Verdict::not_measured);
}

// Frequencies in a range of 0.5 Hz: learned ones 0.05 Hz apart, those that are set 0.25 Hz and more away.
TEST(Claims, frequencies_are_compared_as_shares_of_the_range)
{
    RunGrid grid = even_grid(1);
    set_runs(grid, [](RunMeasures &run, const std::string &model) {
        run.frequency = Frequency{model == "cpg-c" ? 0.7 : model == "cpg-h" ? 0.75 : 1.0, 0.5};
    });
    EXPECT_NEAR(*result_of(grid, "8a").estimate.value, 0.1, 1e-9);
    EXPECT_EQ(result_of(grid, "8a").verdict, Verdict::supported);
    EXPECT_NEAR(*result_of(grid, "8b").estimate.value, 0.6, 1e-9);
    EXPECT_EQ(result_of(grid, "8b").verdict, Verdict::not_supported);
}

// Spread: CPG-H's runs lie three times as far apart as a single model's: (3 - 1) / (3 + 1).
TEST(Claims, spread_is_compared_with_every_single_model)
{
    RunGrid grid = even_grid(1);
    for (const std::string &object : nine_objects) {
        grid.cells[{object, "cpg-h", true}] = around(1, 0.3);
    }
    const PartResult result = result_of(grid, "10a");
    EXPECT_NEAR(*result.estimate.value, 0.5, 1e-9);
    EXPECT_EQ(result.verdict, Verdict::supported);
}

// Cells that the sweep lacks: claims about them are not measured, the others rest on the objects that are there.
TEST(Claims, missing_cells_are_said)
{
    RunGrid grid{{"small-sphere"}, {}};
    grid.cells[{"small-sphere", "cpg-h", true}] = around(2, 0.1);
    grid.cells[{"small-sphere", "cpg-h", false}] = around(1, 0.1);
    EXPECT_EQ(result_of(grid, "1").verdict, Verdict::supported);
    EXPECT_EQ(result_of(grid, "1").estimate.objects, 1U);
    for (const char *part : {"2a", "2b", "3a", "4a", "5b", "9", "10a", "10b", "10c"}) {
        const PartResult result = result_of(grid, part);
        EXPECT_EQ(result.verdict, Verdict::not_measured) << part;
        EXPECT_EQ(result.estimate.missing, "the sweep has none of the cells") << part;
    }
    grid.cells[{"small-sphere", "cpg-h", false}] = runs_of({1});
    EXPECT_EQ(result_of(grid, "1").verdict, Verdict::not_measured);
    EXPECT_EQ(result_of(grid, "1").estimate.missing, "too few runs a cell for an interval");
}

} // namespace
