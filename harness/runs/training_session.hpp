// training_session.hpp: a training run from start, or from where it was interrupted, to its files. Who runs it reports
// its progress and decides when to stop.
#pragma once

#include "experiment/training.hpp"
#include "record/csv.hpp"
#include "record/run_json.hpp"
#include "run_folder.hpp"
#include "trial_log.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace twiddle::runs
{

// Call start_anew() or resume(), then run_trial() until is_done(), then finish(). All throw std::runtime_error with one
// sentence; the folder then holds a run that can be resumed, as it does when the program ends in between.
class TrainingSession
{
  public:
    // With an agent in this process, or one that `make_agent` makes. Throws with the folder untouched if the run's
    // settings are refused, or the agent cannot be made.
    TrainingSession(RunFolder folder, record::Run run, const std::filesystem::path &models);
    TrainingSession(RunFolder folder, record::Run run, const std::filesystem::path &models,
                    const engine::AgentMaker &make_agent);

    // Start from the first trial; what the folder holds of an earlier start goes.
    void start_anew();

    // Go on with the folder's unfinished log: learn again what it holds, and check that it is the same. `advice` ends
    // the sentence if it is not; the log then stays as it is.
    void resume(const std::string &advice);

    std::uint32_t trials_done() const;
    bool is_done() const;
    const std::vector<double> &rewards() const; // of all trials so far

    // One more trial, learned from and logged.
    experiment::TrialRow run_trial();

    // Write the results.
    record::TrainingSummary finish();

  private:
    void require_same(const experiment::TrialRow &row, const RecordedTrial &recorded, const std::string &advice) const;
    void take_note(const experiment::TrialRow &row);
    record::TrainingSummary summary() const;

    RunFolder folder_;
    record::Run run_;
    experiment::Training training_;
    std::optional<record::CsvWriter> log_; // open after the start
    std::vector<double> rotation_rad_;     // of all trials so far
    std::vector<double> reward_;
    std::size_t faults_ = 0;
};

} // namespace twiddle::runs
