// Joint frames and capsules of a finger. Expected: where Bullet puts its links.
#include "finger_fixtures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

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

// A joint's sphere has every capsule that the joint carries inside, surfaces included. Expected: the distance of a
// capsule's farthest point is that of its farther end's centre and its radius.
TEST_P(fast_stepper_kinematics, bounding_spheres_contain_all_capsules)
{
    constexpr double rounding_m = 1e-15;
    finger_.set_angles({0.1, 0.7});
    const std::array<Frame, 2> frames = kinematics_.frames(sines_cosines({0.1, 0.7}));
    for (int joint = 0; joint < 2; joint++) {
        const btVector3 centre_m = frames[joint].point(kinematics_.carried(joint).centre_m);
        for (const int link : links_of(joint)) {
            for (const btVector3 &end_m : finger_.hand.p_palm_capsule_m(link)) {
                const double reach_m =
                    (end_m - p_palm_centre_m - centre_m).length() + finger_.hand.capsule(link).radius_m;
                EXPECT_LE(reach_m, kinematics_.carried(joint).radius_m + rounding_m) << "joint " << joint;
            }
        }
    }
}

// The spheres' centres as the object's bounding volume sees them. Expected: the same centres by the joints' frames.
TEST_P(fast_stepper_kinematics, centres_are_as_far_from_the_hinge_as_their_frames_say)
{
    constexpr unsigned seed = 23;
    std::mt19937_64 random(seed);
    double largest_m = 0, largest_m2 = 0;
    for (int i = 0; i < 1000; i++) {
        const auto angle = sines_cosines(finger_.random_angles(random, beyond_rad));
        const std::array<Frame, 2> frames = kinematics_.frames(angle);
        for (int joint = 0; joint < 2; joint++) {
            const btVector3 centre_m = frames[joint].point(kinematics_.carried(joint).centre_m);
            const PolarPlace place = kinematics_.centre(joint, angle);
            const double square_m2 = centre_m.x() * centre_m.x() + centre_m.y() * centre_m.y();
            largest_m2 = std::max(largest_m2, std::abs(place.square_across_m2 - square_m2));
            largest_m = std::max(largest_m, std::abs(place.height_m - centre_m.z()));
        }
    }
    std::printf("seed %u: largest differences %.1e m and %.1e m^2\n", seed, largest_m, largest_m2);
    EXPECT_LE(largest_m, 1e-12);
    EXPECT_LE(largest_m2, 1e-13);
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
