// The Bullet hand against the public model's frames: where its links stand, how many there are, how far its joints go.
#include "csv_frames.hpp"
#include "fixtures.hpp"

#include "sim/object.hpp"
#include "sim/world.hpp"

#include "setups.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>

namespace twiddle
{
namespace
{

using sim::ArticulatedHand;
using sim::HandHold;

constexpr double deg = M_PI / 180;
constexpr double tolerance_m = 1e-9; // of positions; of the rotations' elements as well

// The palm frame's published pose in the `hand` frame.
const std::array<double, 3> p_hand_palm_m = {-0.0577, -0.0056, 0.0137};
const std::array<double, 3> rpy_hand_palm_rad = {-90 * deg, -15 * deg, 180 * deg};

test::Matrix4 matrix_of(const btTransform &X)
{
    test::Matrix4 matrix{};
    for (int row = 0; row < 3; ++row) {
        matrix[row][3] = X.getOrigin()[row];
        for (int column = 0; column < 3; ++column)
            matrix[row][column] = X.getBasis()[row][column];
    }
    matrix[3][3] = 1;
    return matrix;
}

double largest_difference(const test::Matrix4 &a, const test::Matrix4 &b)
{
    double largest = 0;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column)
            largest = std::max(largest, std::abs(a[row][column] - b[row][column]));
    }
    return largest;
}

using Posture = std::map<std::string, double>; // joint -> angle in rad

// Frame `name`_0 .. `name`_`last` of a finger multiplied out, in the `hand` frame; index 4 is the fingertip.
test::Matrix4 listed_frame(const std::vector<test::Frame> &frames, const std::string &joint, const Posture &posture)
{
    const std::string finger = joint.substr(0, joint.find('_'));
    test::Matrix4 X = test::transform({0, 0, 0}, {0, 0, 0});
    for (const char *part : {"_0", "_1", "_2", "_3", "_tip"}) {
        const test::Frame &frame = test::frame_of(frames, finger + part);
        X = test::product(X, test::transform(frame.xyz_m, frame.rpy_rad));
        const auto angle = posture.find(frame.joint);
        if (angle != posture.end()) X = test::product(X, test::turn(angle->second));
        if (frame.joint == joint) break;
    }
    return X;
}

// Angles of all joints of `hand` when its moving joints are at `angle_rad`; joints in `held_rad` stay there.
Posture posture_of(const ArticulatedHand &hand, const std::vector<double> &angle_rad, const Posture &held_rad)
{
    Posture posture = held_rad;
    std::size_t next = 0;
    for (const sim::ArticulatedLink &link : hand.links()) {
        if (link.moves) posture[hand.model().links[link.model_link].joint] = angle_rad.at(next++);
    }
    return posture;
}

// The largest difference over links and fingertips between Bullet and the list of frames, at 200 random postures.
double largest_error(ArticulatedHand &hand, const Posture &held_rad)
{
    constexpr unsigned seed = 1;
    std::printf("seed %u\n", seed);
    std::mt19937_64 random(seed);
    const auto frames = test::read_frames();
    const test::Matrix4 X_hand_palm = test::transform(p_hand_palm_m, rpy_hand_palm_rad);
    double largest = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const std::vector<double> angle_rad = sim::random_posture(hand, random);
        hand.set_posture(angle_rad);
        const Posture posture = posture_of(hand, angle_rad, held_rad);
        for (int i = 0; i < static_cast<int>(hand.links().size()); ++i) {
            const std::string &joint = hand.model().links[hand.links()[i].model_link].joint;
            const test::Matrix4 actual = test::product(X_hand_palm, matrix_of(hand.X_palm_link(i)));
            largest = std::max(largest, largest_difference(actual, listed_frame(frames, joint, posture)));
        }
        for (const auto &[finger, tip] :
             {std::pair{sim::Finger::index, "index_tip"}, {sim::Finger::thumb, "thumb_tip"}}) {
            btTransform X_palm_tip = btTransform::getIdentity();
            X_palm_tip.setOrigin(hand.p_palm_tip_m(finger));
            const test::Matrix4 actual = test::product(X_hand_palm, matrix_of(X_palm_tip));
            const test::Matrix4 expected = listed_frame(frames, tip, posture);
            for (int row = 0; row < 3; ++row)
                largest = std::max(largest, std::abs(actual[row][3] - expected[row][3]));
        }
    }
    std::printf("largest difference %.1e m\n", largest);
    return largest;
}

// Expected: the products of the public model's transforms, multiplied out here.
TEST(Kinematics, all_20_links_of_the_full_hand_stand_where_the_listed_frames_put_them)
{
    ArticulatedHand hand(sim::icub_hand(), sim::default_setup().hand, HandHold::full);
    EXPECT_LE(largest_error(hand, {}), tolerance_m);
}

// Expected: the same, with the distal joints at the 20 deg at which set-up mid-b holds them.
TEST(Kinematics, links_of_the_welded_hand_stand_where_the_listed_frames_put_them)
{
    ArticulatedHand hand(sim::icub_hand(), test::load_setup("mid-b").hand, HandHold::welded);
    const Posture held_rad = {
        {"index_2", 20 * deg}, {"index_3", 20 * deg}, {"thumb_2", 20 * deg}, {"thumb_3", 20 * deg}};
    EXPECT_LE(largest_error(hand, held_rad), tolerance_m);
}

// Expected: 20 links on the palm, 19 of them movable (Ciancio et al. 2011: 21 links, 19 degrees of freedom; the middle
// finger's first joint is locked).
TEST(Kinematics, full_hand_has_21_links_with_the_palm_and_19_degrees_of_freedom)
{
    const ArticulatedHand hand(sim::icub_hand(), sim::default_setup().hand, HandHold::full);
    EXPECT_EQ(hand.body().getNumLinks() + 1, 21);
    EXPECT_EQ(hand.body().getNumDofs(), 19);
    EXPECT_TRUE(hand.body().hasFixedBase());
}

// Expected: four links of index and thumb each, and the paper's four controlled joints; the held joints are rigid, so
// that Bullet sees no more than two links a finger.
TEST(Kinematics, welded_hand_has_two_fingers_and_4_degrees_of_freedom)
{
    const ArticulatedHand hand(sim::icub_hand(), sim::default_setup().hand, HandHold::welded);
    EXPECT_EQ(hand.links().size(), 8U);
    EXPECT_EQ(hand.body().getNumLinks(), 4);
    EXPECT_EQ(hand.body().getNumDofs(), 4);
    std::map<std::string, int> bullet_link_of;
    for (const sim::ArticulatedLink &link : hand.links()) {
        if (link.moves) bullet_link_of[hand.model().links[link.model_link].joint] = link.body_link;
    }
    EXPECT_EQ(bullet_link_of.size(), joint_count);
    for (std::size_t j = 0; j < joint_count; ++j)
        EXPECT_EQ(hand.controlled()[j], bullet_link_of.at(joint_urdf_names[j])) << joint_names[j];
}

// The paper's joint ranges, in the order of sim/joints.hpp.
constexpr JointVector paper_lower_rad = {0, -15 * deg, 0, 0};
constexpr JointVector paper_upper_rad = {90 * deg, 15 * deg, 90 * deg, 130 * deg};

// No joint passes its stop by more, nor rests further from it. The solver ends at velocity changes of 3e-5 rad/s, which
// in a substep of 2 ms is 6e-8 rad.
constexpr double stop_tolerance_rad = 1e-6;
constexpr double rest_tolerance_rad_s = 1e-4;

double beyond_stops_rad(const sim::World &world)
{
    const JointVector angle_rad = world.angles_rad();
    double furthest_rad = 0;
    for (std::size_t j = 0; j < joint_count; ++j) {
        furthest_rad = std::max({furthest_rad, paper_lower_rad[j] - angle_rad[j], angle_rad[j] - paper_upper_rad[j]});
    }
    return furthest_rad;
}

// A world whose object stands behind the wrist, where no finger reaches it.
std::unique_ptr<sim::World> world_without_contact(sim::Stepper stepper, HandHold hold)
{
    return sim::make_world(stepper, sim::icub_hand(), sim::read_object(TWIDDLE_MODELS, "small-sphere"),
                           sim::default_setup({{"object.hinge_x_m", "-0.2"}}), hold);
}

class Stops : public testing::TestWithParam<std::pair<sim::Stepper, HandHold>>
{
  protected:
    std::unique_ptr<sim::World> world_ = world_without_contact(GetParam().first, GetParam().second);
};

// Expected: the paper's ranges; 1 N m for 1 s on one joint at a time, and the other three must keep within theirs, too.
TEST_P(Stops, a_joint_driven_hard_into_its_stop_stays_there)
{
    sim::World &world = *world_;
    double furthest_rad = 0;
    for (std::size_t driven = 0; driven < joint_count; ++driven) {
        for (const double torque_nm : {1.0, -1.0}) {
            world.reset();
            JointVector drive_nm{};
            drive_nm[driven] = torque_nm;
            for (int substep = 0; substep < 100 * world.substeps_per_step(); ++substep) {
                world.substep(drive_nm);
                furthest_rad = std::max(furthest_rad, beyond_stops_rad(world));
            }
            const double stop_rad = torque_nm > 0 ? paper_upper_rad[driven] : paper_lower_rad[driven];
            EXPECT_NEAR(world.angles_rad()[driven], stop_rad, stop_tolerance_rad)
                << joint_names[driven] << " at " << torque_nm << " N m";
            EXPECT_NEAR(world.velocities_rad_s()[driven], 0, rest_tolerance_rad_s);
            EXPECT_EQ(world.object_rotation_rad(), 0) << "a finger reached the object";
        }
    }
    std::printf("furthest beyond a stop: %.1e rad\n", furthest_rad);
    EXPECT_LE(furthest_rad, stop_tolerance_rad);
}

// Drives all joints by random torques up to the limit, each held for 1 to 20 substeps; returns how far a joint
// passed its stop.
double random_drive_beyond_stops_rad(sim::World &world, int changes)
{
    constexpr unsigned seed = 2;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> torque_nm(-1, 1);
    std::uniform_int_distribution<int> substeps(1, 20);
    double furthest_rad = 0;
    for (int change = 0; change < changes; ++change) {
        JointVector drive_nm{};
        for (double &drive : drive_nm)
            drive = torque_nm(random);
        for (int left = substeps(random); left > 0; --left) {
            world.substep(drive_nm);
            furthest_rad = std::max(furthest_rad, beyond_stops_rad(world));
        }
    }
    std::printf("seed %u, furthest beyond a stop: %.1e rad\n", seed, furthest_rad);
    return furthest_rad;
}

// Expected: the paper's ranges, whatever the speed and the place from which a joint comes.
TEST_P(Stops, random_torques_never_drive_a_joint_past_its_stop)
{
    sim::World &world = *world_;
    EXPECT_LE(random_drive_beyond_stops_rad(world, 100), stop_tolerance_rad);
}

// Expected: the same where the object pushes back.
TEST(Kinematics, random_torques_against_the_object_never_drive_a_joint_past_its_stop)
{
    for (const sim::Stepper stepper : {sim::Stepper::reference, sim::Stepper::fast}) {
        const auto world = sim::make_world(stepper, sim::icub_hand(), sim::read_object(TWIDDLE_MODELS, "small-sphere"),
                                           sim::default_setup(), HandHold::welded);
        EXPECT_LE(random_drive_beyond_stops_rad(*world, 1000), stop_tolerance_rad);
    }
}

// With the held joints on motors, which contacts can move within a substep, a stop gives a little. Expected: the
// paper's ranges, within a hundredth of a radian.
TEST(Kinematics, random_torques_on_the_full_hand_against_the_object_pass_a_stop_by_little)
{
    const auto world =
        sim::make_world(sim::Stepper::reference, sim::icub_hand(), sim::read_object(TWIDDLE_MODELS, "small-sphere"),
                        sim::default_setup(), HandHold::full);
    EXPECT_LE(random_drive_beyond_stops_rad(*world, 1000), 0.01);
}

// Expected: the same motion, bit by bit, as under the limit of 1 N m.
TEST_P(Stops, torques_beyond_the_limit_act_as_the_limit)
{
    sim::World &limited = *world_;
    const auto other = world_without_contact(GetParam().first, GetParam().second);
    sim::World &excessive = *other;
    for (int substep = 0; substep < 100; ++substep) {
        const double sign = substep / 10 % 2 == 0 ? 1 : -1;
        limited.substep({sign, -sign, sign, sign});
        excessive.substep({2 * sign, -1e3 * sign, 1.001 * sign, INFINITY * sign});
        ASSERT_EQ(limited.angles_rad(), excessive.angles_rad()) << "substep " << substep;
        ASSERT_EQ(limited.velocities_rad_s(), excessive.velocities_rad_s()) << "substep " << substep;
    }
}

INSTANTIATE_TEST_SUITE_P(Kinematics, Stops,
                         testing::Values(std::pair(sim::Stepper::reference, HandHold::welded),
                                         std::pair(sim::Stepper::reference, HandHold::full),
                                         std::pair(sim::Stepper::fast, HandHold::welded)),
                         [](const auto &world) {
                             if (world.param.first == sim::Stepper::fast) return "fast_stepper";
                             return world.param.second == HandHold::full ? "full" : "welded";
                         });

} // namespace
} // namespace twiddle
