#include "sweep_session.hpp"

#include "runs/folder_lock.hpp"
#include "runs/run_folder.hpp"
#include "runs/run_replay.hpp"
#include "runs/stop_request.hpp"
#include "runs/training_session.hpp"
#include "runs/usage_error.hpp"
#include "sweep_folder.hpp"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <iterator>
#include <utility>

#include <unistd.h>

namespace twiddle::sweeps
{

namespace
{

using Clock = std::chrono::steady_clock;

constexpr double report_interval_s = 0.1;

double seconds_since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// The end of a sentence about a run's folder that cannot be gone on with.
std::string advice_for(const runs::RunFolder &folder)
{
    return "remove '" + folder.path.string() + "' to train this run again";
}

// Whether nothing is missing of what a complete training has written.
bool is_trained(const std::optional<record::Run> &run, const runs::RunFolder &folder)
{
    return run && run->complete && std::filesystem::exists(folder.trials_csv()) &&
           std::filesystem::exists(folder.policy_json());
}

// Whether there is nothing left to do for a run: it is trained, and its policy replayed.
bool has_results(const std::optional<record::Run> &run, const runs::RunFolder &folder)
{
    return is_trained(run, folder) && run->replay && std::filesystem::exists(folder.trajectory_csv()) &&
           std::filesystem::exists(runs::outline_beside(folder.trajectory_csv()));
}

// Run the session's trials to the end, or until Ctrl-C, or until nobody listens. Returns whether the end was reached.
bool run_trials(runs::TrainingSession &session, const Reporter &report)
{
    const std::uint32_t recalled = session.trials_done();
    Clock::time_point last_report = Clock::now();
    if (!report({recalled, recalled, {}})) return false;
    while (!session.is_done()) {
        session.run_trial();
        if (runs::stop_signal() != 0 && !session.is_done()) return false;
        if (seconds_since(last_report) < report_interval_s) continue;
        if (!report({session.trials_done(), recalled, {}})) return false;
        last_report = Clock::now();
    }
    return true;
}

} // namespace

SweepSession::SweepSession(const SweepPlan &plan, std::filesystem::path folder, std::filesystem::path models,
                           std::function<std::string(std::size_t index)> command_of)
    : plan_(plan), folder_(std::move(folder)), models_(std::move(models)), command_of_(std::move(command_of)),
      states_(plan.runs.size())
{
}

std::vector<std::size_t> SweepSession::missing(const std::vector<std::size_t> &chosen) const
{
    std::vector<std::size_t> missing;
    std::copy_if(chosen.begin(), chosen.end(), std::back_inserter(missing),
                 [this](std::size_t index) { return !is_complete(index); });
    return missing;
}

SweepOutcome SweepSession::run(const std::vector<std::size_t> &chosen, std::size_t jobs)
{
    runs::catch_stop_signals();
    std::vector<std::size_t> to_do;
    for (const std::size_t index : chosen) {
        if (is_complete(index)) {
            states_[index].trials_done = states_[index].trials_recalled = plan_.common.trials;
            ++outcome_.complete;
            ++outcome_.kept;
        } else {
            to_do.push_back(index);
        }
    }
    record::SweepProgress progress(std::cerr, ::isatty(STDERR_FILENO) == 1);
    const Clock::time_point start = Clock::now();
    PoolListener listener;
    listener.report = [&](std::size_t index, const TaskReport &report) {
        states_[index].trials_done = report.trials_done;
        states_[index].trials_recalled = report.trials_recalled;
    };
    listener.end = [&](std::size_t index, TaskEnd end, const std::string &sentence) { note_end(index, end, sentence); };
    listener.tick = [&] {
        const double elapsed_s = seconds_since(start);
        progress.update(state(chosen, elapsed_s), elapsed_s);
    };
    do_tasks(
        to_do, jobs, [&](std::size_t index, const Reporter &report) { return train(index, report); }, listener);
    progress.end_line();
    return outcome_;
}

bool SweepSession::is_complete(std::size_t index) const
{
    const PlannedRun &planned = plan_.runs[index];
    const runs::RunFolder folder{folder_ / planned.folder};
    try {
        return has_results(runs::claim(folder, planned.specification, ""), folder);
    } catch (const runs::UsageError &) {
        return false; // said by train()
    }
}

TaskEnd SweepSession::train(std::size_t index, const Reporter &report) const
{
    const PlannedRun &planned = plan_.runs[index];
    const runs::RunFolder folder{folder_ / planned.folder};
    make_folder(folder.path);
    const runs::FolderLock lock(folder.path);
    const std::optional<record::Run> earlier = runs::claim(folder, planned.specification, advice_for(folder));
    const std::uint32_t trials = plan_.common.trials;
    if (is_trained(earlier, folder)) {
        // Another process may have completed it in the meantime, or been stopped before the replay.
        if (!has_results(earlier, folder)) runs::add_replay_to(folder, models_);
        report({trials, trials, {}});
        return TaskEnd::complete;
    }
    record::Run run;
    run.specification = planned.specification;
    run.command = command_of_(index);
    runs::TrainingSession session(folder, run, models_);
    if (earlier) {
        session.resume(advice_for(folder));
    } else {
        session.start_anew();
    }
    const std::uint32_t recalled = session.trials_done();
    if (!run_trials(session, report)) return TaskEnd::stopped;
    session.finish();
    runs::add_replay_to(folder, models_);
    report({trials, recalled, {}});
    return TaskEnd::complete;
}

void SweepSession::note_end(std::size_t index, TaskEnd end, const std::string &sentence)
{
    if (end == TaskEnd::complete) ++outcome_.complete;
    if (end != TaskEnd::failed) return;
    states_[index].failed = true;
    ++outcome_.failed;
    if (outcome_.failed == 1) outcome_.first_failure = plan_.runs[index].folder + ": " + sentence;
}

record::SweepState SweepSession::state(const std::vector<std::size_t> &chosen, double elapsed_s) const
{
    record::SweepState state;
    state.runs = chosen.size();
    state.runs_done = outcome_.complete;
    state.failed = outcome_.failed;
    std::uint64_t made = 0; // by this start
    for (const std::size_t index : chosen) {
        const RunState &run = states_[index];
        state.trials_done += run.trials_done;
        if (!run.failed) state.trials_left += plan_.common.trials - run.trials_done;
        made += run.trials_done - run.trials_recalled;
    }
    if (elapsed_s > 0) state.trials_per_s = static_cast<double>(made) / elapsed_s;
    return state;
}

} // namespace twiddle::sweeps
