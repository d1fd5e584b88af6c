// joint_numbers.hpp: a hand's joints between the world and the controller, in the order of sim/joints.hpp.
#pragma once

#include "sim/world.hpp"

#include <twiddle/convert.h>
#include <twiddle/limits.h>

#include <array>

namespace twiddle::experiment
{

// Angles or torques as the controller's functions take them.
using JointNumbers = std::array<twd_num, TWD_MAX_JOINTS>;

// What the controller reads of a hand.
struct JointReadings {
    JointNumbers angle_rad{};
    std::array<twd_rate, TWD_MAX_JOINTS> velocity_rad_s{};
};

inline JointReadings read_joints(const sim::World &world)
{
    const sim::JointVector angles_rad = world.angles_rad();
    const sim::JointVector velocities_rad_s = world.velocities_rad_s();
    JointReadings readings;
    for (std::size_t i = 0; i < sim::joint_count; ++i) {
        readings.angle_rad[i] = twd_num_from_double(angles_rad[i]);
        readings.velocity_rad_s[i] = twd_rate_from_double(velocities_rad_s[i]);
    }
    return readings;
}

inline sim::JointVector joint_vector(const JointNumbers &numbers)
{
    sim::JointVector vector{};
    for (std::size_t i = 0; i < sim::joint_count; ++i) {
        vector[i] = twd_num_to_double(numbers[i]);
    }
    return vector;
}

} // namespace twiddle::experiment
