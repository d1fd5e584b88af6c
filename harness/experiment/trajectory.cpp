#include "trajectory.hpp"

#include <algorithm>
#include <limits>

namespace twiddle::experiment
{

namespace
{

std::vector<std::string> trajectory_columns()
{
    std::vector<std::string> columns = {"step", "time_s"};
    for (const std::string joint : joint_names) {
        columns.insert(columns.end(),
                       {"desired_" + joint + "_rad", "actual_" + joint + "_rad", "torque_" + joint + "_nm"});
    }
    columns.insert(columns.end(), {"index_x_m", "index_y_m", "index_z_m", "thumb_x_m", "thumb_y_m", "thumb_z_m",
                                   "object_rad", "index_contact_n", "thumb_contact_n", "finger_clearance_m"});
    return columns;
}

record::CsvRow csv_row(const TrajectoryRow &row)
{
    const sim::Observation &seen = row.observation;
    record::CsvRow csv;
    csv.cell(static_cast<std::uint64_t>(row.sample.step)).cell(row.sample.step * control_step_s);
    for (std::size_t i = 0; i < joint_count; ++i) {
        csv.cell(row.sample.desired_rad[i]).cell(seen.angle_rad[i]).cell(row.sample.torque_nm[i]);
    }
    for (const btVector3 &tip_m : {seen.p_palm_index_tip_m, seen.p_palm_thumb_tip_m}) {
        csv.cell(tip_m.x()).cell(tip_m.y()).cell(tip_m.z());
    }
    csv.cell(seen.object_rad).cell(seen.index_contact_n).cell(seen.thumb_contact_n).cell(seen.finger_clearance_m);
    return csv;
}

} // namespace

Trajectory record_trajectory(TrialRunner &runner, const engine::Parameters &parameters)
{
    Trajectory trajectory;
    trajectory.rows.reserve(trial_steps);
    trajectory.min_finger_clearance_m = std::numeric_limits<double>::max();
    trajectory.result = runner.run_observed(parameters, [&](const StepSample &sample, const sim::World &world) {
        trajectory.rows.push_back({sample, world.observe()});
        trajectory.min_finger_clearance_m =
            std::min(trajectory.min_finger_clearance_m, trajectory.rows.back().observation.finger_clearance_m);
    });
    return trajectory;
}

void write_trajectory(const std::filesystem::path &path, const Trajectory &trajectory,
                      const std::vector<std::string> &comments)
{
    record::CsvWriter writer(path, comments, trajectory_columns());
    for (const TrajectoryRow &row : trajectory.rows) {
        writer.write(csv_row(row));
    }
    writer.finish();
}

} // namespace twiddle::experiment
