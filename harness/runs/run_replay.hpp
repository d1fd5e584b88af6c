// run_replay.hpp: a trained run's learned policy without noise, one trial seen step by step, and its files.
#pragma once

#include "experiment/trajectory.hpp"
#include "record/run_json.hpp"
#include "run_folder.hpp"

#include <filesystem>

namespace twiddle::runs
{

// The trial of the policy in `folder`, whose run is `specification`; a fault of the simulation is in its result. Throws
// UsageError if there is no policy yet, std::runtime_error with one sentence if it is none of the run's model.
experiment::Trajectory replay_policy(const RunFolder &folder, const record::RunSpecification &specification,
                                     const std::filesystem::path &models);

// Write the trial to `path` and the object's outline beside it (outline_beside).
void write_replay(const std::filesystem::path &path, const record::RunSpecification &specification,
                  const experiment::Trajectory &trajectory, const std::filesystem::path &models);

// The entry `replay` of run.json: rotation_rad and min_finger_clearance_m, or the sentence of a fault.
record::ReplaySummary replay_entry(const experiment::Trajectory &trajectory);

// Replay the complete run in `folder` into its trajectory.csv and object_outline.csv, and enter it in its run.json.
// After a fault the trajectory ends with the last step before it. Throws std::runtime_error with one sentence; the
// run's training stays as it is.
void add_replay_to(const RunFolder &folder, const std::filesystem::path &models);

} // namespace twiddle::runs
