// Joint frames and capsules of a finger. Expected: where Bullet puts its links.
#include "finger_fixtures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace twiddle::sim
{
namespace
{

const btVector3 p_palm_centre_m(0.040, 0.001, 0.054);
constexpr double beyond_rad = 1; // how far random angles go past the stops

class fast_stepper_kinematics : public testing::TestWithParam<FingerCase>
{
  protected:
    fast_stepper_kinematics()
        : finger_(setup_with_distal(std::get<0>(GetParam()), std::get<1>(GetParam())), std::get<2>(GetParam())),
          kinematics_(finger_.hand, finger_.link[0], finger_.link[1], p_palm_centre_m)
    {
    }

    // The links that joint 0 or 1 carries, as places in the hand's links().
    std::vector<int> links_of(int joint) const
    {
        std::vector<int> links;
        for (int i = 0; i < static_cast<int>(finger_.hand.links().size()); i++)
            if (finger_.hand.links()[i].body_link == finger_.link[joint]) links.push_back(i);
        return links;
    }

    BulletFinger finger_;
    const FingerKinematics kinematics_;
};

// How far a point is from a capsule's centre line.
double distance_m(const btVector3 &p_m, const std::array<btVector3, 2> &line_m)
{
    const btVector3 along = line_m[1] - line_m[0];
    const double share = along.dot(p_m - line_m[0]) / along.length2();
    return (p_m - line_m[0].lerp(line_m[1], std::clamp(share, 0.0, 1.0))).length();
}

// Expected: the capsules of Bullet's hand, less the object's centre; at 1,000 random postures. Both ends of each link
// lie on one of the finger's capsules of the same radius, and a capsule may be of several links in line; all of them
// together are as long as the links, so that there is none too many.
TEST_P(fast_stepper_kinematics, capsules_stand_where_bullets_links_are)
{
    constexpr unsigned seed = 21;
    std::mt19937_64 random(seed);
    double largest_m = 0;
    for (int i = 0; i < 1000; i++) {
        const FingerVector angle_rad = finger_.random_angles(random, beyond_rad);
        finger_.set_angles(angle_rad);
        const std::array<Frame, 2> frames = kinematics_.frames(sines_cosines(angle_rad));
        for (int joint = 0; joint < 2; joint++) {
            const CarriedCapsules &carried = kinematics_.carried(joint);
            double excess_m = 0;
            for (const LinkCapsule &capsule : carried.capsules)
                excess_m += (carried.points_m[capsule.end] - carried.points_m[capsule.start]).length();
            for (const int link : links_of(joint)) {
                const auto ends_m = finger_.hand.p_palm_capsule_m(link);
                excess_m -= (ends_m[1] - ends_m[0]).length();
                double nearest_m = std::numeric_limits<double>::infinity();
                for (const LinkCapsule &capsule : carried.capsules) {
                    if (capsule.radius_m != finger_.hand.capsule(link).radius_m) continue;
                    const std::array<btVector3, 2> line_m = {frames[joint].point(carried.points_m[capsule.start]),
                                                             frames[joint].point(carried.points_m[capsule.end])};
                    const double off_m = std::max(distance_m(ends_m[0] - p_palm_centre_m, line_m),
                                                  distance_m(ends_m[1] - p_palm_centre_m, line_m));
                    nearest_m = std::min(nearest_m, off_m);
                }
                largest_m = std::max(largest_m, nearest_m);
            }
            largest_m = std::max(largest_m, std::abs(excess_m));
        }
    }
    std::printf("seed %u: largest distance %.1e m\n", seed, largest_m);
    EXPECT_LE(largest_m, 1e-12);
}

// No point that a joint moves is farther from its axis than the reach says, however the finger is bent, and some point
// comes near it. Expected: the ends of Bullet's links, from the axes of the joints' frames.
TEST_P(fast_stepper_kinematics, reaches_hold_whatever_a_joint_moves)
{
    constexpr unsigned seed = 24;
    constexpr double rounding_m = 1e-12;
    std::mt19937_64 random(seed);
    std::array<double, 2> farthest_m{};
    for (int i = 0; i < 1000; i++) {
        const FingerVector angle_rad = finger_.random_angles(random, beyond_rad);
        finger_.set_angles(angle_rad);
        const std::array<Frame, 2> frames = kinematics_.frames(sines_cosines(angle_rad));
        for (int joint = 0; joint < 2; joint++) {
            for (int carrier = joint; carrier < 2; carrier++) {
                for (const int link : links_of(carrier)) {
                    for (const btVector3 &end_m : finger_.hand.p_palm_capsule_m(link)) {
                        const btVector3 arm_m = end_m - p_palm_centre_m - frames[joint].origin_m;
                        farthest_m[joint] = std::max(farthest_m[joint], frames[joint].z.cross(arm_m).length());
                    }
                }
            }
        }
    }
    for (int joint = 0; joint < 2; joint++) {
        EXPECT_LE(farthest_m[joint], kinematics_.reach_m(joint) + rounding_m) << "joint " << joint;
        EXPECT_GE(farthest_m[joint], 0.8 * kinematics_.reach_m(joint)) << "joint " << joint;
    }
}

// Both fingers in lanes. Expected: the frames of each finger alone.
TEST_P(fast_stepper_kinematics, lanes_have_the_frames_of_each_finger)
{
    constexpr unsigned seed = 25;
    const Finger finger = std::get<2>(GetParam());
    BulletFinger other(setup_with_distal(std::get<0>(GetParam()), std::get<1>(GetParam())),
                       finger == Finger::index ? Finger::thumb : Finger::index);
    const FingerKinematics other_kinematics(other.hand, other.link[0], other.link[1], p_palm_centre_m);
    const PairKinematics both({kinematics_, other_kinematics});
    std::mt19937_64 random(seed);
    double largest = 0;
    for (int i = 0; i < 1000; i++) {
        const FingerVector one_rad = finger_.random_angles(random, beyond_rad);
        const FingerVector other_rad = other.random_angles(random, beyond_rad);
        const PairFrame frames = both.second_frames(
            {sine_cosine(Pair{one_rad[0], other_rad[0]}), sine_cosine(Pair{one_rad[1], other_rad[1]})});
        const std::array<Frame, 2> expected = {kinematics_.frames(sines_cosines(one_rad))[1],
                                               other_kinematics.frames(sines_cosines(other_rad))[1]};
        for (int f = 0; f < 2; f++) {
            for (const auto &[lanes, vector] :
                 {std::pair(frames.origin_m, expected[f].origin_m), std::pair(frames.x, expected[f].x),
                  std::pair(frames.y, expected[f].y), std::pair(frames.z, expected[f].z)})
                largest = std::max(largest, (bullet_vector(lane(lanes, f)) - vector).length());
        }
    }
    std::printf("seed %u: largest difference %.1e\n", seed, largest);
    EXPECT_LE(largest, 1e-14);
}

// The velocity of a point of the finger is the sum of the joints' cross products with its arm. Expected: Bullet's links
// at angles a little before and after.
TEST_P(fast_stepper_kinematics, axes_and_arms_give_the_velocities_of_points)
{
    constexpr unsigned seed = 22;
    constexpr double h_rad = 1e-5;
    std::mt19937_64 random(seed);
    double largest_m = 0;
    for (int i = 0; i < 200; i++) {
        const FingerVector angle_rad = finger_.random_angles(random, beyond_rad);
        const double share = std::uniform_real_distribution<double>(0, 1)(random);
        for (int carrier = 0; carrier < 2; carrier++) {
            for (const int link : links_of(carrier)) {
                const auto point_m = [&](const FingerVector &at_rad) {
                    finger_.set_angles(at_rad);
                    const auto ends_m = finger_.hand.p_palm_capsule_m(link);
                    return ends_m[0] + share * (ends_m[1] - ends_m[0]);
                };
                const std::array<Frame, 2> frames = kinematics_.frames(sines_cosines(angle_rad));
                const btVector3 p_m = point_m(angle_rad) - p_palm_centre_m;
                for (int joint = 0; joint < 2; joint++) {
                    const btVector3 moves = joint <= carrier ? frames[joint].z.cross(p_m - frames[joint].origin_m)
                                                             : btVector3(0, 0, 0); // a joint further out
                    FingerVector before_rad = angle_rad, after_rad = angle_rad;
                    before_rad[joint] -= h_rad;
                    after_rad[joint] += h_rad;
                    const btVector3 expected = (point_m(after_rad) - point_m(before_rad)) / (2 * h_rad);
                    largest_m = std::max(largest_m, (moves - expected).length());
                }
            }
        }
    }
    std::printf("seed %u: largest difference %.1e m a rad\n", seed, largest_m);
    EXPECT_LE(largest_m, 1e-10); // h^2 / 6 of an arm of at most 0.1 m, and rounding over h
}

INSTANTIATE_TEST_SUITE_P(Sim, fast_stepper_kinematics, all_finger_cases(), name_of);

} // namespace
} // namespace twiddle::sim
