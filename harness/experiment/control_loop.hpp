// control_loop.hpp: the C library's controller in this process, moving a world.
#pragma once

#include "joint_numbers.hpp"
#include "models.hpp"
#include "sim/world.hpp"

#include <twiddle/controller.h>

#include <string>
#include <vector>

namespace twiddle::experiment
{

// One value in [0, 1] a parameter of the model (model.h).
using Parameters = std::vector<twd_num>;

// What a controller asked for in a control step.
struct StepCommands {
    sim::JointVector desired_rad{};
    sim::JointVector torque_nm{}; // of the last substep
};

class ControlLoop
{
  public:
    // Throws std::runtime_error, which names the set-up `setup_name`, for a configuration that the controller refuses.
    ControlLoop(const twd_controller_config &config, const std::string &setup_name);

    // Start a trial. Throws std::invalid_argument if the controller refuses the parameters.
    void start(const Parameters &parameters);

    // The mixture of CPGs that the last parameters chose.
    ExpertWeights weights() const;

    // Move `world` through one control step of `substeps` substeps.
    StepCommands advance(sim::World &world, int substeps);

  private:
    twd_controller controller_{};
};

inline StepCommands ControlLoop::advance(sim::World &world, int substeps)
{
    JointNumbers desired_rad{};
    StepCommands commands;
    twd_controller_tick(&controller_, desired_rad.data());
    for (int substep = 0; substep < substeps; ++substep) {
        const JointReadings readings = read_joints(world);
        JointNumbers torque_nm{};
        twd_controller_torque(&controller_, desired_rad.data(), readings.angle_rad.data(),
                              readings.velocity_rad_s.data(), torque_nm.data());
        commands.torque_nm = joint_vector(torque_nm);
        world.substep(commands.torque_nm);
    }
    commands.desired_rad = joint_vector(desired_rad);
    return commands;
}

} // namespace twiddle::experiment
