#include "claim_measures.hpp"

#include "cell_measures.hpp"

#include <algorithm>
#include <array>

namespace twiddle::claims
{

namespace
{

using Cells = std::vector<const Runs *>;
using Names = std::vector<std::string>;

const Names singles = {"cpg-s", "cpg-m", "cpg-c"};
const Names models = {"cpg-s", "cpg-m", "cpg-c", "cpg-h"};
const Names sizes = {"small", "medium", "large"};
const Names shapes = {"sphere", "cylinder", "cube"};

// --- what a run yields, and what it must have for it ---

double rotation(const RunMeasures &run)
{
    return run.final_rotation_rad;
}

double area(const RunMeasures &run)
{
    return run.mean_rotation_rad;
}

double doublings(const RunMeasures &run)
{
    return run.log2_trials_to_80;
}

double lesser_share(const RunMeasures &run)
{
    return run.fingers->lesser_share;
}

double sideways_phase(const RunMeasures &run)
{
    return run.fingers->aai_ot_distance_turns;
}

double lesser_weight(const RunMeasures &run)
{
    const Mixture &last = run.mixture->last;
    return 1 - *std::max_element(last.begin(), last.end());
}

double settling(const RunMeasures &run)
{
    const MixtureCourse &course = *run.mixture;
    return mixture_distance(*course.first, *course.middle) - mixture_distance(*course.middle, course.last);
}

const Need nothing = {[](const RunMeasures &) { return true; }, ""};
const Need a_frequency = {[](const RunMeasures &run) { return run.frequency.has_value(); },
                          "a frequency (policy.json or the settings of the oscillators)"};
const Need a_trajectory = {[](const RunMeasures &run) { return run.fingers.has_value(); },
                           "trajectory.csv or a frequency"};
const Need a_mixture = {[](const RunMeasures &run) { return run.mixture.has_value(); },
                        "the columns s_c s_m s_s in trials.csv"};
const Need a_course = {[](const RunMeasures &run) { return run.mixture && run.mixture->first.has_value(); },
                       "3000 trials with the columns s_c s_m s_s"};

// --- which cells are compared ---

// All of the cells, or none if one is missing.
Cells all_or_none(Cells cells)
{
    if (std::find(cells.begin(), cells.end(), nullptr) != cells.end()) cells.clear();
    return cells;
}

// Mean over the groups that are whole.
Contrast mean_over(const std::string &name, const CellMeasure &measure, std::size_t fewest_runs,
                   const std::vector<Cells> &groups)
{
    Contrast contrast(name, measure, fewest_runs);
    const auto whole = groups.size() - static_cast<std::size_t>(std::count(groups.begin(), groups.end(), Cells{}));
    for (const Cells &cells : groups) {
        if (!cells.empty()) contrast.add(1 / static_cast<double>(whole), cells);
    }
    return contrast;
}

Cells centre_pair(const RunGrid &grid, const std::string &object)
{
    return all_or_none({grid.find(object, "cpg-h", true), grid.find(object, "cpg-h", false)});
}

Cells model_pair(const RunGrid &grid, const std::string &object, const std::string &a, const std::string &b)
{
    return all_or_none({grid.find(object, a), grid.find(object, b)});
}

// The cells of two models on each object.
std::vector<Cells> model_pairs(const RunGrid &grid, const std::string &a, const std::string &b)
{
    std::vector<Cells> pairs;
    for (const std::string &object : grid.objects) {
        pairs.push_back(model_pair(grid, object, a, b));
    }
    return pairs;
}

std::vector<Cells> cells_of_h(const RunGrid &grid)
{
    std::vector<Cells> cells;
    for (const std::string &object : grid.objects) {
        cells.push_back(all_or_none({grid.find(object, "cpg-h")}));
    }
    return cells;
}

// --- estimates that several parts share ---

std::vector<Contest> contests(const RunGrid &grid)
{
    std::vector<Contest> contests;
    for (const std::string &object : grid.objects) {
        Cells cells = all_or_none({grid.find(object, "cpg-h"), grid.find(object, "cpg-s"), grid.find(object, "cpg-m"),
                                   grid.find(object, "cpg-c")});
        if (!cells.empty()) contests.push_back(std::move(cells));
    }
    return contests;
}

Estimate estimate_of_one(const RunGrid &grid, const Contrast &contrast, const Need &need)
{
    return estimate_of_all(grid, {contrast}, Side::above, need); // one lies farthest from either side
}

// The first object's rotation minus the second's, by `kind` the sizes or shapes that they share.
template <class ObjectPair>
Estimate object_step(const RunGrid &grid, const Names &shared, const ObjectPair &object_pair)
{
    std::vector<Cells> pairs;
    for (const std::string &kind : shared) {
        for (const std::string &model : models) {
            const auto [first, second] = object_pair(kind);
            pairs.push_back(all_or_none({grid.find(first, model), grid.find(second, model)}));
        }
    }
    return estimate_of_one(grid, mean_over("", difference_of_means(rotation), 1, pairs), nothing);
}

Estimate size_step(const RunGrid &grid, const std::string &smaller, const std::string &larger)
{
    return object_step(
        grid, shapes, [&](const std::string &shape) { return std::pair(smaller + "-" + shape, larger + "-" + shape); });
}

Estimate shape_step(const RunGrid &grid, const std::string &first, const std::string &second)
{
    return object_step(grid, sizes,
                       [&](const std::string &size) { return std::pair(size + "-" + first, size + "-" + second); });
}

Estimate mean_of_h(const RunGrid &grid, const CellMeasure &measure, std::size_t fewest_runs, const Need &need)
{
    return estimate_of_one(grid, mean_over("", measure, fewest_runs, cells_of_h(grid)), need);
}

// The lead of `model` in mean rotation over every other model on `objects`.
Estimate lead(const RunGrid &grid, const std::string &model, const Names &objects)
{
    std::vector<Contrast> leads;
    for (const std::string &object : objects) {
        for (const std::string &other : models) {
            if (other == model) continue;
            leads.push_back(mean_over(object + " against " + other, difference_of_means(rotation), 1,
                                      {model_pair(grid, object, model, other)}));
        }
    }
    return estimate_of_all(grid, leads, Side::above, nothing);
}

Contrast frequency_contrast(const RunGrid &grid, const std::string &a, const std::string &b)
{
    return mean_over(a + " and " + b, frequency_difference, 1, model_pairs(grid, a, b));
}

} // namespace

Estimate centre_gain(const RunGrid &grid)
{
    std::vector<Contrast> gains;
    for (const std::string &object : grid.objects) {
        gains.push_back(mean_over(object, difference_of_means(rotation), 1, {centre_pair(grid, object)}));
    }
    return estimate_of_all(grid, gains, Side::above, nothing);
}

Estimate objects_won_by_mean(const RunGrid &grid)
{
    return estimate_of_share_won(grid, contests(grid), Rank::mean);
}

Estimate objects_won_by_best(const RunGrid &grid)
{
    return estimate_of_share_won(grid, contests(grid), Rank::best);
}

Estimate doublings_faster(const RunGrid &grid)
{
    std::vector<Contrast> contrasts;
    for (const std::string &single : singles) {
        contrasts.push_back(
            mean_over("against " + single, difference_of_means(doublings), 1, model_pairs(grid, single, "cpg-h")));
    }
    return estimate_of_all(grid, contrasts, Side::above, nothing);
}

Estimate area_gain(const RunGrid &grid)
{
    std::vector<Contrast> contrasts;
    for (const std::string &single : singles) {
        contrasts.push_back(
            mean_over("against " + single, difference_of_means(area), 1, model_pairs(grid, "cpg-h", single)));
    }
    return estimate_of_all(grid, contrasts, Side::above, nothing);
}

Estimate small_over_medium(const RunGrid &grid)
{
    return size_step(grid, "small", "medium");
}

Estimate medium_over_large(const RunGrid &grid)
{
    return size_step(grid, "medium", "large");
}

Estimate sphere_over_cylinder(const RunGrid &grid)
{
    return shape_step(grid, "sphere", "cylinder");
}

Estimate cylinder_over_cube(const RunGrid &grid)
{
    return shape_step(grid, "cylinder", "cube");
}

Estimate lesser_share_of_h(const RunGrid &grid)
{
    return estimate_of_one(grid,
                           mean_over("", mean_of(lesser_share), 1, {all_or_none({grid.find(finger_object, "cpg-h")})}),
                           a_trajectory);
}

Estimate sideways_phase_of_h(const RunGrid &grid)
{
    return estimate_of_one(
        grid, mean_over("", mean_of(sideways_phase), 1, {all_or_none({grid.find(finger_object, "cpg-h")})}),
        a_trajectory);
}

Estimate lesser_share_of_singles(const RunGrid &grid)
{
    std::vector<Contrast> contrasts;
    for (const std::string &single : singles) {
        contrasts.push_back(
            mean_over(single, mean_of(lesser_share), 1, {all_or_none({grid.find(finger_object, single)})}));
    }
    return estimate_of_all(grid, contrasts, Side::below, a_trajectory);
}

Estimate weight_of_lesser(const RunGrid &grid)
{
    return mean_of_h(grid, mean_of(lesser_weight), 1, a_mixture);
}

Estimate mixture_settling(const RunGrid &grid)
{
    return mean_of_h(grid, mean_of(settling), 1, a_course);
}

Estimate score_difference_of_mixtures(const RunGrid &grid)
{
    return mean_of_h(grid, score_difference_by_mixture, 2, a_mixture);
}

Estimate frequency_difference_learned(const RunGrid &grid)
{
    return estimate_of_one(grid, frequency_contrast(grid, "cpg-c", "cpg-h"), a_frequency);
}

Estimate frequency_difference_set(const RunGrid &grid)
{
    std::vector<Contrast> contrasts;
    for (const char *learns : {"cpg-c", "cpg-h"}) {
        for (const char *is_set : {"cpg-m", "cpg-s"}) {
            contrasts.push_back(frequency_contrast(grid, learns, is_set));
        }
    }
    return estimate_of_all(grid, contrasts, Side::below, a_frequency);
}

Estimate centre_gain_small_over_large(const RunGrid &grid)
{
    Contrast contrast("", difference_of_means(rotation), 1);
    for (const auto &[size, sign] : {std::pair("small-", 1.0), std::pair("large-", -1.0)}) {
        std::vector<Cells> pairs;
        for (const std::string &shape : shapes) {
            Cells pair = centre_pair(grid, size + shape);
            if (!pair.empty()) pairs.push_back(std::move(pair));
        }
        if (pairs.empty()) return estimate_of_all(grid, {}, Side::above, nothing);
        for (const Cells &pair : pairs) {
            contrast.add(sign / static_cast<double>(pairs.size()), pair);
        }
    }
    return estimate_of_one(grid, contrast, nothing);
}

Estimate spread_of_h(const RunGrid &grid)
{
    std::vector<Cells> pairs;
    for (const std::string &single : singles) {
        const std::vector<Cells> of_single = model_pairs(grid, "cpg-h", single);
        pairs.insert(pairs.end(), of_single.begin(), of_single.end());
    }
    return estimate_of_one(grid, mean_over("", relative_spread, 2, pairs), nothing);
}

Estimate lead_of_c_on_large(const RunGrid &grid)
{
    return lead(grid, "cpg-c", {"large-sphere", "large-cylinder", "large-cube"});
}

Estimate lead_of_m_on_medium_cube(const RunGrid &grid)
{
    return lead(grid, "cpg-m", {"medium-cube"});
}

} // namespace twiddle::claims
