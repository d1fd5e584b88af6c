// trajectory.hpp: one trial seen step by step, and the object's outline to draw beside it.
#pragma once

#include "record/csv.hpp"
#include "sim/world.hpp"
#include "trial.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace twiddle::experiment
{

// The state at the end of one control step.
struct TrajectoryRow {
    StepSample sample;
    sim::Observation observation;
};

struct Trajectory {
    TrialResult result;
    std::vector<TrajectoryRow> rows; // one a control step, fewer after a fault
    double min_finger_clearance_m = 0;
};

// Run one trial and keep all of it.
Trajectory record_trajectory(TrialRunner &runner, const engine::Parameters &parameters);

// Write trajectory.csv under `comments`.
void write_trajectory(const std::filesystem::path &path, const Trajectory &trajectory,
                      const std::vector<std::string> &comments);

} // namespace twiddle::experiment
