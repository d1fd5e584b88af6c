// training_session.hpp: a training run from start, or from where it was interrupted, to its files.
#pragma once

#include "experiment/training.hpp"
#include "record/csv.hpp"
#include "record/progress.hpp"
#include "record/run_json.hpp"
#include "run_folder.hpp"
#include "trial_log.hpp"

#include <filesystem>
#include <vector>

namespace twiddle::cli
{

class TrainingSession
{
  public:
    // Throws std::runtime_error, with the folder untouched, if the run's settings are refused.
    TrainingSession(RunFolder folder, record::Run run, const std::filesystem::path &models);

    // Train to the end, or until Ctrl-C. With `resume`, go on with the folder's unfinished log. Returns the exit status.
    int run(bool resume);

  private:
    record::CsvWriter start_anew();
    // Learn again what the unfinished log holds, check that it is the same, and open the log to go on.
    record::CsvWriter recall();
    void require_same(const experiment::TrialRow &row, const RecordedTrial &recorded) const;

    void take_note(const experiment::TrialRow &row);
    int stop(int signal) const;
    // Write the results and say them on standard output.
    void finish(record::CsvWriter &log);

    RunFolder folder_;
    record::Run run_;
    experiment::Training training_;
    std::vector<double> rotation_rad_; // of all trials so far
    std::vector<double> reward_;
    std::size_t faults_ = 0;
};

} // namespace twiddle::cli
