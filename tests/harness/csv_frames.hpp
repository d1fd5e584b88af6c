// csv_frames.hpp: the hand's joint frames as the public model lists them (data/icub_right_hand.csv), and rigid
// transforms of their own, so that tests of the hand share no mathematics with the code under test.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace twiddle::test
{

using Matrix4 = std::array<std::array<double, 4>, 4>;

// One line of the file.
struct Frame {
    std::string joint, type, parent, child;
    std::array<double, 3> xyz_m{}, rpy_rad{};
    double lower_rad = 0, upper_rad = 0;
};

// All lines, in the file's order.
std::vector<Frame> read_frames();

const Frame &frame_of(const std::vector<Frame> &frames, const std::string &joint);

Matrix4 product(const Matrix4 &a, const Matrix4 &b);

// The transform of a URDF origin: translation, then roll, pitch and yaw about the fixed x, y and z axes.
Matrix4 transform(const std::array<double, 3> &xyz, const std::array<double, 3> &rpy);

// A turn about z.
Matrix4 turn(double angle_rad);

} // namespace twiddle::test
