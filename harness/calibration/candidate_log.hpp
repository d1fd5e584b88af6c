// candidate_log.hpp: candidates.csv of a calibration: every point that was tried, its settings, and what
// its runs came to.
//
// The file is written anew after each point, under another name until it is whole, so that a calibration
// can go on from it.
#pragma once

#include "plan.hpp"
#include "results/paper_distance.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace twiddle::calibration
{

// A point that was tried.
struct Candidate {
    std::string stage;                  // "screening" or "finals"
    std::size_t place = 0;              // in the search, from 0
    std::vector<nlohmann::json> values; // of the plan's variables
    std::vector<double> mean_rad;       // one a trained cell; not a number after a fault
    results::PaperDistance distance;
};

class CandidateLog
{
  public:
    // Read what an earlier start wrote to `path`, if anything; `cells` are the cells that are trained for a point, in
    // order. Throws std::runtime_error if the file is of another calibration.
    CandidateLog(std::filesystem::path path, const calibration::CalibrationPlan &plan,
                 const std::vector<results::Cell> &cells);

    // The mean rotations that an earlier start found for the same stage, place and values; null if it did not come so
    // far. Throws std::runtime_error if it tried other points.
    const std::vector<double> *known(const Candidate &candidate, std::size_t tried) const;

    // Write all of `candidates`.
    void write(const std::vector<Candidate> &candidates) const;

  private:
    void read_row(const std::vector<std::string> &row);
    std::size_t first_mean() const;
    [[noreturn]] void refuse() const;

    std::filesystem::path path_;
    std::vector<std::string> comments_;
    std::vector<std::string> columns_;
    std::size_t variables_;
    std::size_t cells_;
    std::map<std::string, std::vector<double>> known_; // mean_rad by the row's first columns
};

} // namespace twiddle::calibration
