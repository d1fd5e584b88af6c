#include "estimate.hpp"

#include <algorithm>
#include <set>

namespace twiddle::claims
{

namespace
{

using CellSet = std::set<const Runs *>;

void count_basis(const RunGrid &grid, const CellSet &cells, Estimate &estimate)
{
    std::set<std::string> objects;
    for (const auto &[key, runs] : grid.cells) {
        if (cells.count(&runs) == 0) continue;
        objects.insert(std::get<0>(key));
        estimate.runs += runs.size();
    }
    estimate.objects = objects.size();
}

// Which of the runs lack what is needed, in words; empty if none does.
std::string sentence_of_unmet(const RunGrid &grid, const CellSet &cells, const Need &need)
{
    std::size_t unmet = 0;
    std::string first;
    for (const auto &[key, runs] : grid.cells) {
        if (cells.count(&runs) == 0) continue;
        for (const RunMeasures &run : runs) {
            if (need.is_met(run)) continue;
            if (unmet == 0) first = run.folder;
            ++unmet;
        }
    }
    if (unmet == 0) return "";
    return std::to_string(unmet) + " of the runs lack " + need.what + "; the first is " + first;
}

double farther(double a, double b, Side side)
{
    return side == Side::above ? std::min(a, b) : std::max(a, b);
}

void take_farthest(Estimate &estimate, Side side)
{
    const std::vector<Component> &components = estimate.components;
    estimate.value = components.front().value;
    estimate.interval = components.front().interval;
    for (const Component &component : components) {
        estimate.value = farther(*estimate.value, component.value, side);
        if (!component.interval) estimate.interval = std::nullopt;
        if (!estimate.interval) continue;
        estimate.interval->lower = farther(estimate.interval->lower, component.interval->lower, side);
        estimate.interval->upper = farther(estimate.interval->upper, component.interval->upper, side);
    }
    if (!estimate.interval) estimate.missing = "too few runs a cell for an interval";
}

} // namespace

Estimate estimate_of_all(const RunGrid &grid, const std::vector<Contrast> &contrasts, Side side, const Need &need)
{
    Estimate estimate;
    CellSet cells;
    for (const Contrast &contrast : contrasts) {
        cells.insert(contrast.cells().begin(), contrast.cells().end());
    }
    if (cells.empty()) {
        estimate.missing = "the sweep has none of the cells";
        return estimate;
    }
    count_basis(grid, cells, estimate);
    estimate.missing = sentence_of_unmet(grid, cells, need);
    if (!estimate.missing.empty()) return estimate;
    for (const Contrast &contrast : contrasts) {
        if (contrast.empty()) continue;
        if (!contrast.has_runs(0)) {
            estimate.components.clear();
            estimate.missing = "too few runs a cell";
            return estimate;
        }
        estimate.components.push_back({contrast.name(), contrast.value(), contrast.interval()});
    }
    take_farthest(estimate, side);
    return estimate;
}

Estimate estimate_of_share_won(const RunGrid &grid, const std::vector<Contest> &contests, Rank rank)
{
    Estimate estimate;
    if (contests.empty()) {
        estimate.missing = "the sweep has none of the cells";
        return estimate;
    }
    CellSet cells;
    for (const Contest &contest : contests) {
        cells.insert(contest.begin(), contest.end());
    }
    count_basis(grid, cells, estimate);
    estimate.value = share_won(contests, rank);
    estimate.interval = interval_of_share_won(contests, rank);
    if (!estimate.interval) estimate.missing = "too few runs a cell for an interval";
    return estimate;
}

} // namespace twiddle::claims
