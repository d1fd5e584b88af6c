#include "calibration_session.hpp"

#include "experiment/training.hpp"
#include "record/part_file.hpp"
#include "results/table_text.hpp"
#include "runs/stop_request.hpp"
#include "sim/hand_model.hpp"
#include "sweeps/worker_pool.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace twiddle::calibration
{

namespace
{

using Clock = std::chrono::steady_clock;

constexpr double report_interval_s = 10;
constexpr const char *screening = "screening";
constexpr const char *finals = "finals";

// What the paper's tables have of each object.
const std::vector<std::pair<std::string, bool>> models_and_centre = {
    {"cpg-s", true}, {"cpg-m", true}, {"cpg-c", true}, {"cpg-h", true}, {"cpg-h", false}};

std::vector<results::Cell> cells_of(const std::vector<std::string> &objects)
{
    std::vector<results::Cell> cells;
    for (const std::string &object : objects) {
        for (const auto &[model, centre] : models_and_centre) {
            cells.push_back({"", object, model, centre, {}, {}});
        }
    }
    return cells;
}

// The mean rotation at the end of a run; not a number after a fault. Nothing of it is kept.
sweeps::TaskEnd train_run(const record::RunSpecification &specification, const std::filesystem::path &models,
                          const sweeps::Reporter &report)
{
    experiment::Training training(specification, models);
    // As many as count in a sweep; of a short run its last tenth.
    const std::uint32_t last = std::clamp(specification.trials / 10, 1U, results::most_last_trials);
    double sum_rad = 0;
    for (std::uint32_t trial = 1; trial <= specification.trials; ++trial) {
        if (runs::stop_signal() != 0) return sweeps::TaskEnd::stopped;
        const experiment::TrialRow row = training.run_trial();
        if (!row.fault.empty()) sum_rad = std::numeric_limits<double>::quiet_NaN();
        if (trial + last > specification.trials || std::isnan(sum_rad)) sum_rad += row.rotation_rad;
    }
    sweeps::TaskReport result;
    result.result = sum_rad / last;
    report(result);
    return sweeps::TaskEnd::complete;
}

} // namespace

CalibrationSession::CalibrationSession(calibration::CalibrationPlan plan, results::PaperValues paper,
                                       record::RunSpecification common, std::filesystem::path models,
                                       std::filesystem::path folder, std::size_t jobs)
    : plan_(std::move(plan)), paper_(std::move(paper)), common_(std::move(common)), models_(std::move(models)),
      folder_(std::move(folder)), jobs_(jobs), cells_(cells_of(plan_.objects)),
      log_(folder_ / "candidates.csv", plan_, cells_)
{
}

bool CalibrationSession::run()
{
    const sim::HandModel hand = sim::read_hand_model(models_ / "icub_right_hand.urdf");
    std::vector<sim::ObjectSpec> objects;
    for (const std::string &name : sim::object_names(models_)) {
        objects.push_back(sim::read_object(models_, name));
    }
    calibration::Search search(plan_.search, plan_.variables, [&](const calibration::Point &point) {
        const auto settings = calibration::with_values(plan_.setup.settings, plan_.variables,
                                                       calibration::values_at(plan_.variables, point));
        calibration::Reach reach(hand, settings::setup_from_settings(settings, plan_.name, plan_.name));
        return reach.fits(objects, plan_.reach);
    });
    while (!search.is_done()) {
        const std::size_t place = candidates_.size();
        if (!judge(screening, place, search.next(), plan_.screening)) return false;
        search.tell(candidates_.back().distance.error_rad);
    }
    const std::vector<std::size_t> ranking = search.ranking();
    for (std::size_t i = 0; i < std::min(plan_.finalists, ranking.size()); ++i) {
        if (!judge(finals, ranking[i], search.point(ranking[i]), plan_.finals)) return false;
    }
    write_setups();
    return true;
}

record::RunSpecification CalibrationSession::specification_at(const std::vector<nlohmann::json> &values,
                                                              const calibration::Effort &effort) const
{
    record::RunSpecification specification = common_;
    specification.trials = effort.trials;
    specification.setup = plan_.name;
    specification.settings = calibration::with_values(plan_.setup.settings, plan_.variables, values);
    return specification;
}

bool CalibrationSession::judge(const std::string &stage, std::size_t place, const calibration::Point &point,
                               const calibration::Effort &effort)
{
    Candidate candidate;
    candidate.stage = stage;
    candidate.place = place;
    candidate.values = calibration::values_at(plan_.variables, point);
    const std::vector<double> *known = log_.known(candidate, candidates_.size());
    if (known != nullptr) {
        candidate.mean_rad = *known;
    } else if (!train(candidate, effort)) {
        return false;
    }
    candidate.distance = distance(candidate.mean_rad);
    candidates_.push_back(candidate);
    if (known == nullptr) log_.write(candidates_);
    report(known == nullptr);
    return true;
}

double CalibrationSession::error_limit(const std::string &stage) const
{
    const std::size_t kept = stage == finals ? 1 : std::max(plan_.finalists, plan_.search.parents);
    std::vector<double> errors;
    for (const Candidate &candidate : candidates_) {
        if (candidate.stage == stage) errors.push_back(candidate.distance.error_rad);
    }
    if (errors.size() < kept) return std::numeric_limits<double>::infinity();
    std::sort(errors.begin(), errors.end());
    return errors[kept - 1];
}

bool CalibrationSession::train(Candidate &candidate, const calibration::Effort &effort) const
{
    const double limit = error_limit(candidate.stage);
    const std::size_t cells_of_object = models_and_centre.size();
    for (std::size_t first = 0; first < cells_.size(); first += cells_of_object) {
        const std::vector<double> mean_rad =
            train_cells(specification_at(candidate.values, effort), first, cells_of_object, effort.seeds);
        if (mean_rad.empty()) return false;
        candidate.mean_rad.insert(candidate.mean_rad.end(), mean_rad.begin(), mean_rad.end());
        if (distance(candidate.mean_rad).error_rad > limit) break;
    }
    return true;
}

std::vector<double> CalibrationSession::train_cells(const record::RunSpecification &common, std::size_t first,
                                                    std::size_t count, std::size_t seeds) const
{
    std::vector<std::size_t> tasks(count * seeds);
    std::iota(tasks.begin(), tasks.end(), std::size_t{0});
    const sweeps::Work work = [&](std::size_t task, const sweeps::Reporter &report) {
        record::RunSpecification specification = common;
        const results::Cell &cell = cells_[first + task / seeds];
        specification.object = cell.object;
        specification.model = cell.model;
        specification.centre = cell.centre;
        specification.seed = task % seeds + 1;
        return train_run(specification, models_, report);
    };
    bool stopped = false;
    std::string failure;
    std::vector<double> result_rad(tasks.size());
    sweeps::PoolListener listener;
    listener.report = [&](std::size_t task, const sweeps::TaskReport &report) { result_rad[task] = report.result; };
    listener.end = [&](std::size_t, sweeps::TaskEnd end, const std::string &sentence) {
        stopped = stopped || end == sweeps::TaskEnd::stopped;
        if (end == sweeps::TaskEnd::failed && failure.empty()) failure = sentence;
    };
    listener.tick = [] {};
    sweeps::do_tasks(tasks, jobs_, work, listener);
    if (!failure.empty()) throw std::runtime_error(failure);
    if (stopped || runs::stop_signal() != 0) return {};
    std::vector<double> mean_rad(count, 0.0);
    for (const std::size_t task : tasks) { // in their order, so that no sum depends on who was first
        mean_rad[task / seeds] += result_rad[task] / static_cast<double>(seeds);
    }
    return mean_rad;
}

results::PaperDistance CalibrationSession::distance(const std::vector<double> &mean_rad) const
{
    std::vector<results::Cell> cells(cells_.begin(), cells_.begin() + static_cast<std::ptrdiff_t>(mean_rad.size()));
    for (std::size_t i = 0; i < cells.size(); ++i) {
        cells[i].rotation_rad = {mean_rad[i]};
    }
    const bool faulty =
        std::any_of(mean_rad.begin(), mean_rad.end(), [](double value) { return !std::isfinite(value); });
    results::PaperDistance distance = results::distance_from_paper(results::paper_pairs(cells, paper_, plan_.objects));
    // Cells that were not trained can only add to the sum of squares.
    distance.error_rad *= std::sqrt(static_cast<double>(cells.size()) / static_cast<double>(cells_.size()));
    if (faulty) distance.error_rad = distance.error_scaled = std::numeric_limits<double>::infinity();
    return distance;
}

void CalibrationSession::write_setups() const
{
    std::vector<const Candidate *> finalists;
    for (const Candidate &candidate : candidates_) {
        if (candidate.stage == finals) finalists.push_back(&candidate);
    }
    std::stable_sort(finalists.begin(), finalists.end(), [](const Candidate *a, const Candidate *b) {
        return a->distance.error_rad < b->distance.error_rad;
    });
    for (std::size_t rank = 0; rank < finalists.size(); ++rank) {
        write_setup(*finalists[rank], folder_ / ("setup-" + std::to_string(rank + 1) + ".toml"));
    }
}

void CalibrationSession::write_setup(const Candidate &candidate, const std::filesystem::path &path) const
{
    const results::PaperDistance &distance = candidate.distance;
    const std::vector<std::string> comments = {
        "Found by `twiddle calibrate` with the plan " + plan_.name + ": point " + std::to_string(candidate.place) +
            " of " + std::to_string(plan_.search.random + plan_.search.refined) + ".",
        "Root mean square of ln(ours / paper) over " + std::to_string(distance.pairs) + " of " +
            std::to_string(cells_.size()) + " cells: " + (distance.pairs < cells_.size() ? "at least " : "") +
            results::fixed(distance.error_rad, 3) + " in rad; " + results::fixed(distance.error_scaled, 3) +
            " over these with one factor of " + results::fixed(distance.scale, 3) + "."};
    record::write_file(path,
                       calibration::setup_text(plan_.setup.settings, plan_.variables, candidate.values, comments));
    for (const std::string &comment : comments) {
        std::cout << comment << '\n';
    }
    std::cout << path.string() << '\n';
}

void CalibrationSession::report(bool trained)
{
    const Clock::time_point now = Clock::now();
    const bool due = std::chrono::duration<double>(now - last_report_).count() >= report_interval_s;
    if (!trained || !due) return;
    last_report_ = now;
    double best = std::numeric_limits<double>::infinity();
    const std::string &stage = candidates_.back().stage;
    std::size_t done = 0;
    for (const Candidate &candidate : candidates_) {
        if (candidate.stage != stage) continue;
        ++done;
        best = std::min(best, candidate.distance.error_rad);
    }
    const std::size_t all = stage == screening ? plan_.search.random + plan_.search.refined : plan_.finalists;
    std::cerr << stage << ": " << done << " of " << all << " set-ups, least error " << results::fixed(best, 3)
              << ", after " << std::lround(std::chrono::duration<double>(now - start_).count()) << " s\n";
}

} // namespace twiddle::calibration
