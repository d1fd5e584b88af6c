#include "training_session.hpp"

#include "record/part_file.hpp"
#include "stop_request.hpp"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <unistd.h>

namespace twiddle::cli
{

namespace
{

constexpr std::size_t first_trials = 100; // whose means are printed at the end
constexpr std::size_t last_trials = 500;

double seconds_since(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double mean(std::vector<double>::const_iterator begin, std::vector<double>::const_iterator end)
{
    return std::accumulate(begin, end, 0.0) / static_cast<double>(end - begin);
}

} // namespace

TrainingSession::TrainingSession(RunFolder folder, record::Run run, const std::filesystem::path &models)
    : folder_(std::move(folder)), run_(std::move(run)), training_(run_.specification, models)
{
}

int TrainingSession::run(bool resume)
{
    catch_stop_signals();
    record::CsvWriter log = resume ? recall() : start_anew();
    const std::uint32_t trials = run_.specification.trials;
    const auto already_done = static_cast<std::uint32_t>(rotation_rad_.size());
    record::Progress progress(std::cerr, ::isatty(STDERR_FILENO) == 1, trials, already_done);
    for (const double reward : reward_) {
        progress.recall(reward);
    }
    const auto start = std::chrono::steady_clock::now();
    for (std::uint32_t done = already_done; done < trials; ++done) {
        const experiment::TrialRow row = training_.run_trial();
        write_trial(log, row);
        take_note(row);
        progress.update(row.reward, seconds_since(start));
        if (!row.fault.empty()) {
            progress.end_line();
            std::cerr << "twiddle: trial " << row.trial << ": " << row.fault << '\n';
        }
        if (stop_signal() != 0 && done + 1 < trials) {
            progress.end_line();
            return stop(stop_signal());
        }
    }
    finish(log);
    return 0;
}

record::CsvWriter TrainingSession::start_anew()
{
    std::filesystem::create_directories(folder_.path);
    record::write_run(folder_.run_json(), run_); // "running" before anything of a complete run goes
    remove_results(folder_);
    return record::CsvWriter(folder_.trials_csv(), trial_log_comments(run_.specification), trial_log_columns());
}

record::CsvWriter TrainingSession::recall()
{
    const std::vector<RecordedTrial> recorded = read_recorded_trials(folder_.trials_csv());
    if (recorded.empty()) return start_anew();

    for (std::size_t i = 0; i + 1 < recorded.size(); ++i) {
        const experiment::TrialRow row = training_.recall_trial(recorded[i].rotation_rad);
        require_same(row, recorded[i]);
        take_note(row);
        if (recorded[i].fault) ++faults_;
    }
    // The last one is simulated again: where this program or this machine gives another rotation, the run cannot go on.
    const experiment::TrialRow row = training_.run_trial();
    require_same(row, recorded.back());
    take_note(row);
    record::CsvWriter log(folder_.trials_csv(), trial_log_columns(), recorded.back().offset);
    write_trial(log, row);
    return log;
}

void TrainingSession::require_same(const experiment::TrialRow &row, const RecordedTrial &recorded) const
{
    if (trial_text(row) == recorded.text) return;
    throw std::runtime_error("'" + record::part_path(folder_.trials_csv()).string() +
                             "' cannot be continued, since this program gives another trial " +
                             std::to_string(row.trial) + "; train again without --resume");
}

void TrainingSession::take_note(const experiment::TrialRow &row)
{
    rotation_rad_.push_back(row.rotation_rad);
    reward_.push_back(static_cast<double>(row.reward));
    if (!row.fault.empty()) ++faults_;
}

int TrainingSession::stop(int signal) const
{
    std::cerr << "twiddle: stopped after trial " << rotation_rad_.size() << " of " << run_.specification.trials
              << "; the same command with --resume goes on\n";
    return 128 + signal; // as a shell reports it
}

void TrainingSession::finish(record::CsvWriter &log)
{
    const std::size_t first = std::min(first_trials, rotation_rad_.size());
    const std::size_t last = std::min(last_trials, rotation_rad_.size());
    const double first_rad = mean(rotation_rad_.begin(), rotation_rad_.begin() + static_cast<std::ptrdiff_t>(first));
    const double last_rad = mean(rotation_rad_.end() - static_cast<std::ptrdiff_t>(last), rotation_rad_.end());

    log.finish();
    record::write_policy(folder_.policy_json(), training_.policy());
    run_.complete = true;
    run_.summary = {{"first_trials", first},
                    {"mean_rotation_of_first_rad", first_rad},
                    {"last_trials", last},
                    {"mean_rotation_of_last_rad", last_rad},
                    {"faults", faults_}};
    record::write_run(folder_.run_json(), run_);

    std::cout << "mean rotation of the first " << first << " trials: " << first_rad << " rad\n"
              << "mean rotation of the last " << last << " trials: " << last_rad << " rad\n";
    if (faults_ > 0) std::cout << "trials with a fault, counted as 0 rad: " << faults_ << '\n';
    std::cout << "run.json, trials.csv and policy.json are in " << folder_.path.string() << '\n';
}

} // namespace twiddle::cli
