// trial_log.hpp: trials.csv, one row a trial, and an unfinished one to go on from.
#pragma once

#include "experiment/training.hpp"
#include "record/csv.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace twiddle::runs
{

// The head of trials.csv.
std::vector<std::string> trial_log_comments(const record::RunSpecification &specification);
const std::vector<std::string> &trial_log_columns();

// Append a trial of a run of number type `number`, and a comment below it if it had a fault.
void write_trial(record::CsvWriter &writer, const experiment::TrialRow &row, const std::string &number);

// The row's text in trials.csv.
std::string trial_text(const experiment::TrialRow &row, const std::string &number);

// A trial of an unfinished log.
struct RecordedTrial {
    double rotation_rad = 0;
    std::string text;          // the row
    std::uintmax_t offset = 0; // of the row's first byte
    bool fault = false;
};

// The trials in `path`.part, none if there is no such file. Throws std::runtime_error that names the file if it is
// no log of trials.
std::vector<RecordedTrial> read_recorded_trials(const std::filesystem::path &path);

} // namespace twiddle::runs
