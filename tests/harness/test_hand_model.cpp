// The hand's URDF against the public model's frames and closed forms, and how unfit URDFs are refused.
#include "csv_frames.hpp"
#include "scratch_folder.hpp"

#include "settings/text_file.hpp"
#include "sim/hand_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

namespace twiddle
{
namespace
{

using sim::HandLink;
using sim::HandModel;

const std::string urdf = std::string(TWIDDLE_MODELS) + "/icub_right_hand.urdf";
const std::vector<std::string> fingers = {"thumb", "index", "middle", "ring", "little"};
constexpr double deg = M_PI / 180;

HandModel hand()
{
    return sim::read_hand_model(urdf);
}

using Posture = std::map<std::string, double>; // joint -> angle in rad; others are at 0

double angle_of(const Posture &posture, const std::string &joint)
{
    const auto found = posture.find(joint);
    return found == posture.end() ? 0 : found->second;
}

// The frame of the link that `joint` moves, in the `hand` frame, from the model.
btTransform forward(const HandModel &model, const std::string &joint, const Posture &posture)
{
    btTransform X = btTransform::getIdentity();
    for (int index = model.link_of_joint(joint); index >= 0; index = model.links[index].parent) {
        const HandLink &link = model.links[index];
        const btQuaternion turned(btVector3(0, 0, 1), angle_of(posture, link.joint));
        X = link.X_parent_joint * btTransform(turned) * X;
    }
    return X;
}

// The same from the list of frames.
test::Matrix4 forward(const std::vector<test::Frame> &frames, const std::string &finger, int last,
                      const Posture &posture)
{
    test::Matrix4 X = test::transform({0, 0, 0}, {0, 0, 0});
    for (int i = 0; i <= last; ++i) {
        const auto &frame = test::frame_of(frames, finger + "_" + std::to_string(i));
        X = test::product(X, test::transform(frame.xyz_m, frame.rpy_rad));
        X = test::product(X, test::turn(angle_of(posture, frame.joint)));
    }
    return X;
}

btVector3 tip_mm(const std::string &finger, const Posture &posture)
{
    const HandModel model = hand();
    const std::string joint = finger + "_3";
    const double length_m = model.links[model.link_of_joint(joint)].capsule.length_m;
    return forward(model, joint, posture) * btVector3(length_m, 0, 0) * 1000;
}

void expect_near(const btVector3 &actual, const btVector3 &expected, double tolerance)
{
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(actual[i], expected[i], tolerance) << "axis " << i;
}

// Expected: Ciancio et al. 2011; 21 links with the palm, 20 joints less the middle finger's locked one.
TEST(hand_model, has_21_links_and_19_degrees_of_freedom)
{
    const HandModel model = hand();
    EXPECT_EQ(model.name, "icub_right_hand");
    EXPECT_EQ(model.root, "hand");
    EXPECT_EQ(model.link_count(), 21);
    EXPECT_EQ(model.dof_count(), 19);
    EXPECT_FALSE(model.links[model.link_of_joint("middle_0")].revolute);
    EXPECT_THROW(model.link_of_joint("index_tip"), std::out_of_range);
}

// The links' order is that of hand_model.hpp: thumb, index, middle, ring, little, each from the palm outwards.
TEST(hand_model, lists_parents_before_children_finger_by_finger)
{
    const HandModel model = hand();
    for (int i = 0; i < 20; ++i) {
        EXPECT_EQ(model.links[i].joint, fingers[i / 4] + "_" + std::to_string(i % 4));
        EXPECT_EQ(model.links[i].name, "hand_" + model.links[i].joint);
        EXPECT_EQ(model.links[i].parent, i % 4 == 0 ? -1 : i - 1);
    }
}

// Expected: product of the public model's transforms (data/icub_right_hand.csv), multiplied out here.
TEST(hand_model, forward_kinematics_equals_the_product_of_the_listed_frames)
{
    const HandModel model = hand();
    const auto frames = test::read_frames();
    constexpr unsigned seed = 1;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> angle(-M_PI, M_PI);
    for (int trial = 0; trial < 200; ++trial) {
        Posture posture;
        for (const auto &link : model.links) {
            if (link.revolute) posture[link.joint] = angle(random);
        }
        for (const auto &finger : fingers) {
            for (int last = 0; last < 4; ++last) {
                const btTransform actual = forward(model, finger + "_" + std::to_string(last), posture);
                const test::Matrix4 expected = forward(frames, finger, last, posture);
                for (int row = 0; row < 3; ++row) {
                    ASSERT_NEAR(actual.getOrigin()[row], expected[row][3], 1e-12)
                        << "seed " << seed << ", trial " << trial;
                    for (int column = 0; column < 3; ++column) {
                        ASSERT_NEAR(actual.getBasis()[row][column], expected[row][column], 1e-12)
                            << finger << "_" << last << ", seed " << seed << ", trial " << trial;
                    }
                }
            }
        }
    }
}

// Expected: the public model's ranges, and the paper's for index_0 and thumb_0 (-15..15 and 0..130 deg).
TEST(hand_model, joint_ranges_are_the_public_models_and_the_papers)
{
    const HandModel model = hand();
    for (const auto &frame : test::read_frames()) {
        if (frame.type != "revolute" || frame.joint == "middle_0") continue;
        const HandLink &link = model.links[model.link_of_joint(frame.joint)];
        double lower = frame.lower_rad;
        double upper = frame.upper_rad;
        if (frame.joint == "index_0") lower = -15 * deg, upper = 15 * deg;
        if (frame.joint == "thumb_0") upper = 130 * deg;
        EXPECT_TRUE(link.revolute) << frame.joint;
        EXPECT_NEAR(link.lower_rad, lower, 1e-15) << frame.joint;
        EXPECT_NEAR(link.upper_rad, upper, 1e-15) << frame.joint;
    }
}

// Expected: a capsule as long as the x offset of the next frame in the list, the tip's included, of radius 6.5 mm.
TEST(hand_model, capsules_reach_to_the_next_joint)
{
    const HandModel model = hand();
    const auto frames = test::read_frames();
    for (const auto &finger : fingers) {
        for (int i = 0; i < 4; ++i) {
            const HandLink &link = model.links[model.link_of_joint(finger + "_" + std::to_string(i))];
            const auto &next = test::frame_of(frames, finger + (i == 3 ? "_tip" : "_" + std::to_string(i + 1)));
            EXPECT_DOUBLE_EQ(link.capsule.length_m, next.xyz_m[0]) << link.name;
            EXPECT_DOUBLE_EQ(link.capsule.radius_m, 0.0065) << link.name;
        }
    }
}

// Expected: a solid capsule at 1500 kg/m3, summed over thin discs along its axis.
TEST(hand_model, masses_and_inertias_are_those_of_solid_capsules)
{
    constexpr double density = 1500;
    constexpr int discs = 20000;
    for (const auto &link : hand().links) {
        const double r = link.capsule.radius_m;
        const double half_m = link.capsule.length_m / 2 + r;
        double mass = 0, along = 0, across = 0;
        for (int i = 0; i < discs; ++i) {
            const double step = 2 * half_m / discs;
            const double x = -half_m + (i + 0.5) * step;
            const double beyond = std::max(0.0, std::abs(x) - link.capsule.length_m / 2);
            const double disc_r2 = r * r - beyond * beyond;
            const double disc = density * M_PI * disc_r2 * step;
            mass += disc;
            along += disc * disc_r2 / 2;
            across += disc * (disc_r2 / 4 + x * x);
        }
        EXPECT_NEAR(link.mass_kg / mass, 1, 1e-7) << link.name;
        EXPECT_NEAR(link.inertia_kg_m2[0][0] / along, 1, 1e-7) << link.name;
        EXPECT_NEAR(link.inertia_kg_m2[1][1] / across, 1, 1e-7) << link.name;
        EXPECT_NEAR(link.inertia_kg_m2[2][2] / across, 1, 1e-7) << link.name;
        expect_near(link.p_link_com_m, btVector3(link.capsule.length_m / 2, 0, 0), 1e-15);
        EXPECT_GE(link.mass_kg, 0.00465) << link.name; // 4.7 to 6.9 g, rounded
        EXPECT_LE(link.mass_kg, 0.00695) << link.name;
    }
}

// Expected: positions measured on the public model, to 0.1 mm.
TEST(hand_model, fingertips_are_where_the_public_model_has_them)
{
    expect_near(tip_mm("index", {}), btVector3(-128.3, 4.8, 63.8), 0.1);
    expect_near(tip_mm("thumb", {}), btVector3(-52.9, -5.5, 102.6), 0.1);
    expect_near(tip_mm("index", {{"index_1", 45 * deg}}), btVector3(-111.4, -40.7, 53.8), 0.1);
    expect_near(tip_mm("index", {{"index_1", 90 * deg}}), btVector3(-68.6, -59.3, 37.2), 0.1);
    expect_near(tip_mm("thumb", {{"thumb_0", 90 * deg}}), btVector3(-37.6, -89.9, 16.3), 0.1);
}

// Expected: the palm frame's published pose, xyz -57.7 -5.6 13.7 mm and rpy -90 -15 180 deg.
TEST(hand_model, palm_frame_has_its_pose)
{
    const btTransform X = hand().X_hand_palm;
    const test::Matrix4 expected = test::transform({-0.0577, -0.0056, 0.0137}, {-90 * deg, -15 * deg, 180 * deg});
    for (int row = 0; row < 3; ++row) {
        EXPECT_NEAR(X.getOrigin()[row], expected[row][3], 1e-15);
        for (int column = 0; column < 3; ++column)
            EXPECT_NEAR(X.getBasis()[row][column], expected[row][column], 1e-15);
    }
}

// Expected: the cosine and the sine of 15 deg and nothing else, since trials repeat to the last bit.
TEST(hand_model, palm_frame_is_exact_where_its_angles_are_right)
{
    const btMatrix3x3 R = hand().X_hand_palm.getBasis();
    const double c = std::cos(M_PI / 12);
    const double s = std::sin(M_PI / 12);
    const std::array<std::array<double, 3>, 3> expected = {{{-c, -s, 0}, {0, 0, -1}, {s, -c, 0}}};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            EXPECT_EQ(R[row][column], expected[row][column]) << row << ", " << column;
    }
}

// The frame is no body: a link without mass would stop a simulation.
TEST(hand_model, palm_frame_is_no_link)
{
    for (const auto &link : hand().links)
        EXPECT_NE(link.name, "palm");
}

// Expected: the straight middle finger lies along palm +x, the little finger's knuckle is on the +y side of the
// index's, and flexion carries a fingertip towards +z.
TEST(hand_model, palm_frame_is_distal_ulnar_and_out_of_the_palm)
{
    const HandModel model = hand();
    const btTransform X_palm_hand = model.X_hand_palm.inverse();
    const btVector3 distal = X_palm_hand.getBasis() * forward(model, "middle_3", {}).getBasis().getColumn(0);
    expect_near(distal, btVector3(1, 0, 0), 1e-6);
    const auto knuckle = [&](const char *joint) { return X_palm_hand * forward(model, joint, {}).getOrigin(); };
    EXPECT_GT(knuckle("little_0").y() - knuckle("index_0").y(), 0.045);
    const btVector3 straight = X_palm_hand * (tip_mm("index", {}) / 1000);
    const btVector3 flexed = X_palm_hand * (tip_mm("index", {{"index_1", 90 * deg}}) / 1000);
    EXPECT_GT(flexed.z() - straight.z(), 0.05);
}

// A hand URDF with `text` in place of `part`, refused in one sentence that names file and reason.
struct Fault {
    const char *name, *part, *text, *reason;
};

void PrintTo(const Fault &fault, std::ostream *stream)
{
    *stream << fault.name;
}

class HandModelFault : public testing::TestWithParam<Fault>
{
};

TEST_P(HandModelFault, is_refused_in_one_sentence)
{
    const auto [name, part, text, reason] = GetParam();
    std::string source = settings::read_text_file(urdf);
    const auto at = source.find(part);
    ASSERT_NE(at, std::string::npos) << name;
    source.replace(at, std::string(part).size(), text);
    const test::ScratchFolder folder;
    const auto path = folder.write("hand.urdf", source);
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    const std::string error = test::error_of([&] { sim::read_hand_model(path); });
    EXPECT_EQ(testing::internal::GetCapturedStderr() + testing::internal::GetCapturedStdout(), "");
    EXPECT_TRUE(test::is_one_sentence_with(error, {path.string() + ":", reason})) << error;
}

INSTANTIATE_TEST_SUITE_P(
    hand_model, HandModelFault,
    testing::Values(
        Fault{"unclosed", "</robot>", "", "no valid URDF"}, Fault{"no_robot", "<robot", "<robotic", "no valid URDF"},
        Fault{"prismatic", "name=\"thumb_0\" type=\"revolute\"", "name=\"thumb_0\" type=\"prismatic\"",
              "neither revolute"},
        Fault{"ring", "<parent link=\"hand\"/>", "<parent link=\"hand_thumb_3\"/>", "no tree"},
        Fault{"self_parent", "<parent link=\"hand_thumb_0\"/>", "<parent link=\"hand_thumb_1\"/>", "no tree"},
        Fault{"unknown_parent", "<parent link=\"hand_thumb_0\"/>", "<parent link=\"wrist\"/>", "no valid URDF"},
        Fault{"two_parents", "<child link=\"hand_thumb_1\"/>", "<child link=\"hand_thumb_2\"/>", "no valid URDF"},
        Fault{"other_axis", "<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 1 0\"/>", "z axis"},
        Fault{"axis_in_words", "<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 0 one\"/>", "no valid URDF"},
        Fault{"no_range", "lower=\"0\" upper=\"2.26", "lower=\"3\" upper=\"2.26", "lower must be below upper"},
        Fault{"no_palm_frame", "<link name=\"palm\"/>",
              "<link name=\"palm\"><inertial><mass value=\"1\"/>"
              "<inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial></link>",
              "expected a capsule"},
        Fault{"moving_palm_frame", "name=\"palm_frame\" type=\"fixed\"", "name=\"palm_frame\" type=\"floating\"",
              "not fixed"},
        Fault{"no_mass", "<mass value=\"0.005926496731\"/>", "<mass value=\"0\"/>", "mass"},
        Fault{"inertia", "<inertia ixx=\"1.179069224e-07\"", "<inertia ixx=\"-1\"", "moment of inertia"},
        Fault{"one_sphere",
              "    <collision>\n      <origin xyz=\"0 0 0\"/>\n      <geometry><sphere radius=\"0.0065\"/></geometry>\n"
              "    </collision>\n",
              "", "expected a capsule"},
        Fault{"upright_cylinder", "<collision>\n      <origin xyz=\"0.01055 0 0\" rpy=\"0 1.5707963267948966 0\"/>",
              "<collision>\n      <origin xyz=\"0.01055 0 0\"/>", "expected a capsule"},
        Fault{"two_radii", "<collision>\n      <origin xyz=\"0 0 0\"/>\n      <geometry><sphere radius=\"0.0065\"",
              "<collision>\n      <origin xyz=\"0 0 0\"/>\n      <geometry><sphere radius=\"0.0066\"",
              "different radii"}),
    [](const auto &fault) { return std::string(fault.param.name); });

// A robot without links has no root.
TEST(hand_model, a_hand_without_a_root_is_refused)
{
    const test::ScratchFolder folder;
    const auto path = folder.write("hand.urdf", "<robot name=\"r\"></robot>");
    const std::string error = test::error_of([&] { sim::read_hand_model(path); });
    EXPECT_TRUE(test::is_one_sentence_with(error, {path.string(), "no valid URDF"})) << error;
}

// Expected: a hand whose frame of all positions is missing is refused, and the sentence says what is missing.
TEST(hand_model, a_hand_without_the_palm_frame_is_refused)
{
    const test::ScratchFolder folder;
    const auto path = folder.write("hand.urdf", R"(<robot name="r"><link name="wrist"/></robot>)");
    const std::string error = test::error_of([&] { sim::read_hand_model(path); });
    EXPECT_TRUE(test::is_one_sentence_with(error, {path.string(), "wrist", "palm frame"})) << error;
}

// A link without <inertial> cannot be simulated; expected: the sentence names the link.
TEST(hand_model, a_link_without_inertial_is_refused)
{
    const test::ScratchFolder folder;
    const auto path = folder.write("hand.urdf", R"(<robot name="r"><link name="palm"/><link name="finger"/>
        <joint name="j" type="fixed"><parent link="palm"/><child link="finger"/></joint></robot>)");
    const std::string error = test::error_of([&] { sim::read_hand_model(path); });
    EXPECT_TRUE(test::is_one_sentence_with(error, {path.string(), "finger", "inertial"})) << error;
}

TEST(hand_model, a_missing_file_is_named)
{
    const std::string error = test::error_of([] { sim::read_hand_model("/nowhere/hand.urdf"); });
    EXPECT_TRUE(test::is_one_sentence_with(error, {"/nowhere/hand.urdf", "no such file"})) << error;
}

} // namespace
} // namespace twiddle
