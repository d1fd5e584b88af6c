// library_numbers.hpp: numbers of the C library and the doubles that they stand for, one way and back.
#pragma once

#include "agent.hpp"

#include <twiddle/convert.h>
#include <twiddle/limits.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace twiddle::engine::TWD_BUILD_NAMESPACE
{

static_assert(joint_count <= TWD_MAX_JOINTS, "the library is built for fewer joints than the hand has");

// Angles or torques as the controller's functions take them, in the order of settings/joints.hpp.
using JointNumbers = std::array<twd_num, joint_count>;

// JointReadings in numbers of the library.
struct LibraryReadings {
    JointNumbers angle_rad;
    std::array<twd_rate, joint_count> velocity_rad_s;
};

inline LibraryReadings library_readings(const JointReadings &readings)
{
    LibraryReadings numbers;
    for (std::size_t i = 0; i < joint_count; ++i) {
        numbers.angle_rad[i] = twd_num_from_double(readings.angle_rad[i]);
        numbers.velocity_rad_s[i] = twd_rate_from_double(readings.velocity_rad_s[i]);
    }
    return numbers;
}

inline JointVector joint_vector(const JointNumbers &numbers)
{
    JointVector vector;
    for (std::size_t i = 0; i < joint_count; ++i) {
        vector[i] = twd_num_to_double(numbers[i]);
    }
    return vector;
}

inline std::vector<twd_num> library_numbers(const std::vector<double> &values)
{
    std::vector<twd_num> numbers(values.size());
    std::transform(values.begin(), values.end(), numbers.begin(), twd_num_from_double);
    return numbers;
}

// `to_double` is of the numbers' type: twd_num_to_double, twd_wide_to_double.
template <class Number, class ToDouble>
std::vector<double> doubles_of(const Number *numbers, std::size_t count, ToDouble to_double)
{
    std::vector<double> values(count);
    std::transform(numbers, numbers + count, values.begin(), to_double);
    return values;
}

} // namespace twiddle::engine::TWD_BUILD_NAMESPACE
