#include "csv_frames.hpp"

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace twiddle::test
{
namespace
{

double number(const std::string &text)
{
    return text.empty() ? 0 : std::stod(text);
}

Matrix4 turn_about(int axis, double angle_rad)
{
    Matrix4 matrix{};
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    matrix[axis][axis] = matrix[3][3] = 1;
    matrix[a][a] = matrix[b][b] = std::cos(angle_rad);
    matrix[b][a] = std::sin(angle_rad);
    matrix[a][b] = -std::sin(angle_rad);
    return matrix;
}

} // namespace

std::vector<Frame> read_frames()
{
    std::ifstream file(std::string(TWIDDLE_TEST_DATA) + "/icub_right_hand.csv");
    std::vector<Frame> frames;
    bool header = true;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        if (std::exchange(header, false)) continue;
        std::vector<std::string> cells;
        std::istringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');)
            cells.push_back(cell);
        cells.resize(15);
        Frame frame{cells[0], cells[1], cells[2], cells[3], {}, {}, number(cells[13]), number(cells[14])};
        for (int i = 0; i < 3; ++i) {
            frame.xyz_m[i] = number(cells[4 + i]);
            frame.rpy_rad[i] = number(cells[7 + i]);
        }
        frames.push_back(frame);
    }
    if (frames.size() != 25) throw std::runtime_error("icub_right_hand.csv does not list 25 frames");
    return frames;
}

const Frame &frame_of(const std::vector<Frame> &frames, const std::string &joint)
{
    for (const auto &frame : frames) {
        if (frame.joint == joint) return frame;
    }
    throw std::out_of_range(joint);
}

Matrix4 product(const Matrix4 &a, const Matrix4 &b)
{
    Matrix4 c{};
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            for (int k = 0; k < 4; ++k)
                c[row][column] += a[row][k] * b[k][column];
        }
    }
    return c;
}

Matrix4 transform(const std::array<double, 3> &xyz, const std::array<double, 3> &rpy)
{
    Matrix4 matrix = product(turn_about(2, rpy[2]), product(turn_about(1, rpy[1]), turn_about(0, rpy[0])));
    for (int i = 0; i < 3; ++i)
        matrix[i][3] = xyz[i];
    return matrix;
}

Matrix4 turn(double angle_rad)
{
    return turn_about(2, angle_rad);
}

} // namespace twiddle::test
