// A run folder and the hand's URDF are enough to draw a run: forward kinematics of the test's own, from their texts.
#include "../csv_frames.hpp"
#include "../scratch_folder.hpp"
#include "program.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using namespace twiddle::test;

struct UrdfJoint {
    std::string parent;
    std::string child;
    Matrix4 origin{};
};

std::array<double, 3> three_numbers(const std::string &text)
{
    std::array<double, 3> numbers{};
    std::istringstream(text) >> numbers[0] >> numbers[1] >> numbers[2];
    return numbers;
}

std::string found(const std::string &text, const std::string &pattern)
{
    std::smatch match;
    return std::regex_search(text, match, std::regex(pattern)) ? match[1].str() : "";
}

// The parts of `text` from `begin` to `end`, both included.
std::vector<std::string> parts_of(const std::string &text, const std::string &begin, const std::string &end)
{
    std::vector<std::string> parts;
    for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1)) {
        parts.push_back(text.substr(at, text.find(end, at) + end.size() - at));
    }
    return parts;
}

class Urdf
{
  public:
    Urdf() : text_(text_of(TWIDDLE_MODELS "/icub_right_hand.urdf"))
    {
        for (const std::string &joint : parts_of(text_, "<joint ", "</joint>")) {
            joints_[found(joint, "joint name=\"([^\"]*)\"")] = {
                found(joint, "parent link=\"([^\"]*)\""), found(joint, "child link=\"([^\"]*)\""),
                transform(three_numbers(found(joint, "xyz=\"([^\"]*)\" rpy")),
                          three_numbers(found(joint, "rpy=\"([^\"]*)\"")))};
        }
    }

    // The fingertip in the palm frame, m: the centre of the last capsule's end.
    std::array<double, 3> tip_m(const std::string &finger, const std::map<std::string, double> &angle_rad) const
    {
        Matrix4 X = transform({0, 0, 0}, {0, 0, 0});
        for (int i = 0; i < 4; ++i) {
            const std::string name = finger + "_" + std::to_string(i);
            X = product(X, product(joints_.at(name).origin, turn(angle_rad.at(name))));
        }
        const std::string last = joints_.at(finger + "_3").child;
        const std::size_t collision = text_.find("<collision>", text_.find("<link name=\"" + last + "\""));
        const double length_m = std::stod(found(text_.substr(collision, 200), "length=\"([^\"]*)\""));
        const Matrix4 &palm = joints_.at("palm_frame").origin;
        std::array<double, 3> in_palm{};
        for (int axis = 0; axis < 3; ++axis) {
            for (int k = 0; k < 3; ++k) {
                in_palm[axis] += palm[k][axis] * (X[k][3] + X[k][0] * length_m - palm[k][3]);
            }
        }
        return in_palm;
    }

  private:
    std::string text_;
    std::map<std::string, UrdfJoint> joints_;
};

// A trajectory's file: facts of its head, and rows by column name.
struct TrajectoryFile {
    std::map<std::string, std::string> facts;
    std::vector<std::map<std::string, double>> rows;
};

std::vector<std::string> cells_of(const std::string &line)
{
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) {
        cells.push_back(cell);
    }
    return cells;
}

TrajectoryFile read_trajectory(const std::filesystem::path &path)
{
    TrajectoryFile file;
    std::vector<std::string> names;
    std::istringstream stream(text_of(path));
    for (std::string line; std::getline(stream, line);) {
        const std::size_t colon = line.find(": ");
        if (line[0] == '#') {
            if (colon != std::string::npos) file.facts[line.substr(2, colon - 2)] = line.substr(colon + 2);
        } else if (names.empty()) {
            names = cells_of(line);
        } else {
            const std::vector<std::string> cells = cells_of(line);
            std::map<std::string, double> row;
            for (std::size_t i = 0; i < names.size(); ++i) {
                row[names[i]] = std::stod(cells.at(i));
            }
            file.rows.push_back(row);
        }
    }
    return file;
}

double off_mm(const std::map<std::string, double> &row, const std::string &finger, const std::array<double, 3> &tip_m)
{
    return 1000 * std::hypot(row.at(finger + "_x_m") - tip_m[0], row.at(finger + "_y_m") - tip_m[1],
                             row.at(finger + "_z_m") - tip_m[2]);
}

// Expected: the file's fingertips within 0.05 mm, from its angles, wherever the distal joints are held.
TEST(Trajectory, fingertips_follow_from_urdf_and_angles)
{
    const Urdf urdf;
    const ScratchFolder folder;
    for (const std::string set : {"", "--set hand.index_distal_deg=20 --set hand.thumb_distal_deg=0"}) {
        const std::string run = (folder.path() / (set.empty() ? "default" : "bent")).string();
        ASSERT_EQ(run_twiddle("train --object small-cube --model cpg-h --trials 3 --set object.hinge_x_m=0.2 " + set +
                              " --out " + run)
                      .status,
                  0);
        ASSERT_EQ(run_twiddle("replay " + run).status, 0);
        const TrajectoryFile file = read_trajectory(run + "/trajectory.csv");
        const auto degrees = [&](const char *fact) { return std::stod(file.facts.at(fact)) * M_PI / 180; };
        ASSERT_EQ(file.rows.size(), 300U);
        if (!set.empty()) {
            EXPECT_EQ(file.facts.at("index_distal_deg"), "20");
        }
        for (const auto &row : file.rows) {
            const std::map<std::string, double> angle_rad = {
                {"index_0", row.at("actual_aai_rad")},    {"index_1", row.at("actual_fei_rad")},
                {"index_2", degrees("index_distal_deg")}, {"index_3", degrees("index_distal_deg")},
                {"thumb_0", row.at("actual_ot_rad")},     {"thumb_1", row.at("actual_fet_rad")},
                {"thumb_2", degrees("thumb_distal_deg")}, {"thumb_3", degrees("thumb_distal_deg")}};
            for (const char *finger : {"index", "thumb"}) {
                EXPECT_LT(off_mm(row, finger, urdf.tip_m(finger, angle_rad)), 0.05) << finger << " " << row.at("step");
            }
        }
    }
}

// Expected: the settings that were asked for stand in the head, the hinge among them.
TEST(Trajectory, head_says_what_is_fixed)
{
    const ScratchFolder folder;
    const std::string run = (folder.path() / "run").string();
    ASSERT_EQ(run_twiddle("train --object large-cylinder --model cpg-s --trials 2 --set object.hinge_x_m=0.2 "
                          "--set object.hinge_y_m=0.015 --set object.counted_direction=1 "
                          "--set hand.index_distal_deg=7 --set hand.thumb_distal_deg=5 --set hand.other_fingers_deg=15 "
                          "--set object.rounding_m=0.001 --out " +
                          run)
                  .status,
              0);
    ASSERT_EQ(run_twiddle("replay " + run).status, 0);
    const auto facts = read_trajectory(run + "/trajectory.csv").facts;
    const std::map<std::string, std::string> expected = {{"object_hinge_x_m", "0.2"},   {"object_hinge_y_m", "0.015"},
                                                         {"counted_direction", "1"},    {"index_distal_deg", "7"},
                                                         {"thumb_distal_deg", "5"},     {"other_fingers_deg", "15"},
                                                         {"object_rounding_m", "0.001"}};
    for (const auto &[name, value] : expected) {
        EXPECT_EQ(facts.at(name), value) << name;
    }
}

} // namespace
