#include "figure_data.hpp"

#include "results_text.hpp"
#include "statistics.hpp"

#include <algorithm>
#include <numeric>

namespace twiddle::results
{

namespace
{

constexpr std::size_t most_ranks = 2; // that best_runs.csv has of a cell

double mean_of(const std::vector<double> &values, std::size_t first, std::size_t end)
{
    const auto begin = values.begin();
    return mean({begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(end)});
}

// The point of the trials from `first`, counted from 0, to before `end`.
CurvePoint curve_point(const Cell &cell, std::size_t best, std::size_t first, std::size_t end)
{
    std::vector<double> of_runs_rad;
    for (const CellRun &run : cell.runs) {
        of_runs_rad.push_back(mean_of(run.trial_rotation_rad, first, end));
    }
    CurvePoint point;
    point.trial = static_cast<double>(first + 1 + end) / 2;
    point.mean_rad = mean(of_runs_rad);
    if (of_runs_rad.size() > 1) point.sd_rad = standard_deviation(of_runs_rad);
    point.best_run_rad = of_runs_rad[best];
    return point;
}

Texts names_of(const Cell &cell)
{
    return {cell.variant, cell.object, cell.model, truth_cell(cell.centre)};
}

const Texts name_columns = {"variant", "object", "model", "centre"};

} // namespace

std::vector<std::size_t> ranking(const Cell &cell)
{
    std::vector<std::size_t> order(cell.rotation_rad.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return cell.rotation_rad[a] > cell.rotation_rad[b]; });
    return order;
}

std::vector<CurvePoint> learning_curve(const Cell &cell)
{
    const std::size_t best = ranking(cell).front();
    const std::size_t trials = cell.runs.front().trial_rotation_rad.size();
    std::vector<CurvePoint> curve;
    for (std::size_t first = 0; first < trials; first += trials_a_point) {
        curve.push_back(curve_point(cell, best, first, std::min<std::size_t>(first + trials_a_point, trials)));
    }
    return curve;
}

std::string learning_curves_csv(const Sweep &sweep, const std::vector<Cell> &cells)
{
    std::vector<Texts> rows;
    for (const Cell &cell : cells) {
        for (const CurvePoint &point : learning_curve(cell)) {
            rows.push_back(
                joined(names_of(cell), {std::to_string(cell.runs.size()), full(point.trial), full(point.mean_rad),
                                        full(point.sd_rad), full(point.best_run_rad)}));
        }
    }
    return csv_text({"learning curves: each run's mean rotation in rad over " + std::to_string(trials_a_point) +
                         " trials, the last point over those that are left; mean and standard deviation (n - 1) over "
                         "the runs of a cell",
                     "trial: the mean of the point's first and last; best_run_rad: the run with the highest rotation "
                     "at the end, for which " +
                         rotation_text(sweep),
                     origin_text(sweep)},
                    joined(name_columns, {"runs", "trial", "mean_rad", "sd_rad", "best_run_rad"}), rows);
}

std::string best_runs_csv(const Sweep &sweep, const std::vector<Cell> &cells)
{
    std::vector<Texts> rows;
    for (const Cell &cell : cells) {
        const std::vector<std::size_t> order = ranking(cell);
        for (std::size_t rank = 0; rank < std::min(most_ranks, order.size()); ++rank) {
            const CellRun &run = cell.runs[order[rank]];
            rows.push_back(joined(names_of(cell), {std::to_string(rank + 1), std::to_string(run.seed), run.folder,
                                                   full(cell.rotation_rad[order[rank]])}));
        }
    }
    return csv_text({"the two best runs of each cell; rotation_rad: " + rotation_text(sweep), origin_text(sweep)},
                    joined(name_columns, {"rank", "seed", "folder", "rotation_rad"}), rows);
}

} // namespace twiddle::results
