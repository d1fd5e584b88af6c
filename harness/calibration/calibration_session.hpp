// calibration_session.hpp: a calibration from its first point to its set-up; one that was interrupted goes on.
//
// A new start asks the search for the same points again, takes their rotations from candidates.csv, and trains
// what is missing.
#pragma once

#include "candidate_log.hpp"
#include "plan.hpp"
#include "record/run_json.hpp"
#include "results/paper_distance.hpp"

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace twiddle::calibration
{

class CalibrationSession
{
  public:
    // `common` gives hand, stepper and number type of all runs. Throws std::runtime_error if the folder is of
    // another calibration.
    CalibrationSession(calibration::CalibrationPlan plan, results::PaperValues paper, record::RunSpecification common,
                       std::filesystem::path models, std::filesystem::path folder, std::size_t jobs);

    // Search, train the finalists in full, and write each as setup-RANK.toml. False if Ctrl-C came in between.
    bool run();

  private:
    // The plan's settings at `values`.
    record::RunSpecification specification_at(const std::vector<nlohmann::json> &values,
                                              const calibration::Effort &effort) const;

    // The candidate of a point, from the file or from runs; appended to candidates_. False after Ctrl-C.
    bool judge(const std::string &stage, std::size_t place, const calibration::Point &point,
               const calibration::Effort &effort);
    // The error beyond which a point of `stage` is of no use: it would be neither a parent nor a finalist, nor
    // the best of these.
    double error_limit(const std::string &stage) const;
    // Train object by object until the error, which only grows, is beyond the limit. False after Ctrl-C.
    bool train(Candidate &candidate, const calibration::Effort &effort) const;
    // The mean rotations of `count` cells from `first` on; empty after Ctrl-C.
    std::vector<double> train_cells(const record::RunSpecification &common, std::size_t first, std::size_t count,
                                    std::size_t seeds) const;
    // Over the trained cells, the first ones; error_rad is a lower bound if there are more.
    results::PaperDistance distance(const std::vector<double> &mean_rad) const;

    void write_setups() const;
    void write_setup(const Candidate &candidate, const std::filesystem::path &path) const;

    void report(bool trained);

    calibration::CalibrationPlan plan_;
    results::PaperValues paper_;
    record::RunSpecification common_;
    std::filesystem::path models_;
    std::filesystem::path folder_;
    std::size_t jobs_;
    std::vector<results::Cell> cells_; // what is trained for a point, without its rotations
    CandidateLog log_;
    std::vector<Candidate> candidates_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::chrono::steady_clock::time_point last_report_ = start_;
};

} // namespace twiddle::calibration
