#include "training_session.hpp"

#include "record/part_file.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace twiddle::runs
{

namespace
{

constexpr std::size_t first_trials = 100; // whose means are the run's summary
constexpr std::size_t last_trials = 500;

double mean(std::vector<double>::const_iterator begin, std::vector<double>::const_iterator end)
{
    return std::accumulate(begin, end, 0.0) / static_cast<double>(end - begin);
}

} // namespace

TrainingSession::TrainingSession(RunFolder folder, record::Run run, const std::filesystem::path &models)
    : folder_(std::move(folder)), run_(std::move(run)), training_(run_.specification, models)
{
}

TrainingSession::TrainingSession(RunFolder folder, record::Run run, const std::filesystem::path &models,
                                 const engine::AgentMaker &make_agent)
    : folder_(std::move(folder)), run_(std::move(run)), training_(run_.specification, models, make_agent)
{
}

std::uint32_t TrainingSession::trials_done() const
{
    return static_cast<std::uint32_t>(rotation_rad_.size());
}

bool TrainingSession::is_done() const
{
    return trials_done() >= run_.specification.trials;
}

const std::vector<double> &TrainingSession::rewards() const
{
    return reward_;
}

experiment::TrialRow TrainingSession::run_trial()
{
    experiment::TrialRow row = training_.run_trial();
    write_trial(*log_, row, run_.specification.number);
    take_note(row);
    return row;
}

void TrainingSession::start_anew()
{
    std::filesystem::create_directories(folder_.path);
    record::write_run(folder_.run_json(), run_); // "running" before anything of a complete run goes
    remove_results(folder_);
    log_.emplace(folder_.trials_csv(), trial_log_comments(run_.specification), trial_log_columns());
}

void TrainingSession::resume(const std::string &advice)
{
    const std::vector<RecordedTrial> recorded = read_recorded_trials(folder_.trials_csv());
    if (recorded.empty()) {
        start_anew();
        return;
    }
    for (std::size_t i = 0; i + 1 < recorded.size(); ++i) {
        const experiment::TrialRow row = training_.recall_trial(recorded[i].rotation_rad);
        require_same(row, recorded[i], advice);
        take_note(row);
        if (recorded[i].fault) ++faults_;
    }
    // The last one is simulated again: where this program or this machine gives another rotation, the run cannot go on.
    const experiment::TrialRow row = training_.run_trial();
    require_same(row, recorded.back(), advice);
    take_note(row);
    log_.emplace(folder_.trials_csv(), trial_log_columns(), recorded.back().offset);
    write_trial(*log_, row, run_.specification.number);
}

void TrainingSession::require_same(const experiment::TrialRow &row, const RecordedTrial &recorded,
                                   const std::string &advice) const
{
    if (trial_text(row, run_.specification.number) == recorded.text) return;
    throw std::runtime_error("'" + record::part_path(folder_.trials_csv()).string() +
                             "' cannot be continued, since this program gives another trial " +
                             std::to_string(row.trial) + "; " + advice);
}

void TrainingSession::take_note(const experiment::TrialRow &row)
{
    rotation_rad_.push_back(row.rotation_rad);
    reward_.push_back(row.reward);
    if (!row.fault.empty()) ++faults_;
}

record::TrainingSummary TrainingSession::summary() const
{
    record::TrainingSummary summary;
    summary.first_trials = std::min(first_trials, rotation_rad_.size());
    summary.last_trials = std::min(last_trials, rotation_rad_.size());
    const auto first_end = rotation_rad_.begin() + static_cast<std::ptrdiff_t>(summary.first_trials);
    const auto last_begin = rotation_rad_.end() - static_cast<std::ptrdiff_t>(summary.last_trials);
    summary.mean_rotation_of_first_rad = mean(rotation_rad_.begin(), first_end);
    summary.mean_rotation_of_last_rad = mean(last_begin, rotation_rad_.end());
    summary.faults = faults_;
    return summary;
}

record::TrainingSummary TrainingSession::finish()
{
    const record::TrainingSummary results = summary();
    const record::Policy policy = training_.policy(); // first, since an agent that fails now can be trained again
    log_->finish();
    record::write_policy(folder_.policy_json(), policy);
    run_.complete = true;
    run_.summary = results;
    record::write_run(folder_.run_json(), run_);
    return results;
}

} // namespace twiddle::runs
