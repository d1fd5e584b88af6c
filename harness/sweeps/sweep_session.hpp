// sweep_session.hpp: the runs of a sweep that are not complete yet, each to its files.
#pragma once

#include "record/progress.hpp"
#include "sweep_manifest.hpp"
#include "worker_pool.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace twiddle::sweeps
{

// What became of the chosen runs.
struct SweepOutcome {
    std::size_t complete = 0;
    std::size_t kept = 0; // of them, complete before
    std::size_t failed = 0;
    std::string first_failure; // the run's folder and what went wrong
};

// Trains runs of a plan in folders below the sweep's, side by side.
class SweepSession
{
  public:
    // `command_of` gives the command for a run's run.json.
    SweepSession(const SweepPlan &plan, std::filesystem::path folder, std::filesystem::path models,
                 std::function<std::string(std::size_t index)> command_of);

    // Those of the runs `chosen` by their index that are not complete.
    std::vector<std::size_t> missing(const std::vector<std::size_t> &chosen) const;

    // Train the runs `chosen` by their index, `jobs` at a time: a complete one is kept, an unfinished one goes
    // on, one that fails leaves the others alone. After Ctrl-C, the runs stop after their current trial. Reports
    // on standard error.
    SweepOutcome run(const std::vector<std::size_t> &chosen, std::size_t jobs);

  private:
    // How far one run is.
    struct RunState {
        std::uint32_t trials_done = 0;
        std::uint32_t trials_recalled = 0; // of them, made by an earlier start
        bool failed = false;
    };

    bool is_complete(std::size_t index) const;
    // The run's training and the replay of its policy, in a worker of its own.
    TaskEnd train(std::size_t index, const Reporter &report) const;
    void note_end(std::size_t index, TaskEnd end, const std::string &sentence);
    record::SweepState state(const std::vector<std::size_t> &chosen, double elapsed_s) const;

    const SweepPlan &plan_;
    std::filesystem::path folder_;
    std::filesystem::path models_;
    std::function<std::string(std::size_t index)> command_of_;
    std::vector<RunState> states_; // of all runs of the plan
    SweepOutcome outcome_;
};

} // namespace twiddle::sweeps
