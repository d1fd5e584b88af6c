// joints.hpp: the four controlled joints, in the order of every joint array of this project.
#pragma once

#include <array>
#include <cstddef>

namespace twiddle
{

constexpr std::size_t joint_count = 4;

enum Joint : std::size_t { fei = 0, aai = 1, fet = 2, ot = 3 };

// One value a controlled joint.
using JointVector = std::array<double, joint_count>;

// The joints' names in files (column names, settings) and in the URDF.
constexpr std::array<const char *, joint_count> joint_names = {"fei", "aai", "fet", "ot"};
constexpr std::array<const char *, joint_count> joint_urdf_names = {"index_1", "index_0", "thumb_1", "thumb_0"};

} // namespace twiddle
