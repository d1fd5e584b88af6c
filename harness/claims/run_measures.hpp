// run_measures.hpp: what one run of a sweep says to the paper's claims, from the files in its folder.
#pragma once

#include "learning_course.hpp"
#include "results/sweep_results.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace twiddle::claims
{

// Of the learned policy without noise, from trajectory.csv.
struct FingerUse {
    double lesser_share = 0;          // of the forward turning, 0 to 0.5 (finger_use.hpp)
    double aai_ot_distance_turns = 0; // in phase, between the desired angles of AAI and OT, 0 to 0.5
};

// The frequency of a run's pattern generators, and the range from which CPG-C and CPG-H learn it.
struct Frequency {
    double value_hz = 0;
    double range_hz = 0; // its width
};

struct RunMeasures {
    std::string folder;                   // relative to the sweep's
    double final_rotation_rad = 0;        // mean over the last trials, as in the tables
    double mean_rotation_rad = 0;         // over all trials: the area under the learning curve, per trial
    double log2_trials_to_80 = 0;         // of the trials until the curve is at 80 % of final_rotation_rad
    std::optional<MixtureCourse> mixture; // of CPG-H with weights in its trials.csv
    std::optional<Frequency> frequency;   // learned (policy.json), or set (run.json) for lone CPG-M and CPG-S
    std::optional<FingerUse> fingers;     // of the small sphere's runs with trajectory.csv and a known frequency
};

// The object for which alone the paper reports what the fingers do.
constexpr const char *finger_object = "small-sphere";

// Read the measures of `run` of the sweep in `folder`, which is complete. What needs a file or a column that the run
// does not have stays empty. Throws std::runtime_error with one sentence that names a file that is there and malformed.
RunMeasures read_run_measures(const std::filesystem::path &folder, const results::Sweep &sweep,
                              const results::SweepRun &run);

} // namespace twiddle::claims
