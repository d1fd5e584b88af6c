// The fast stepper's distances between a capsule and the object, against libccd's Gilbert-Johnson-Keerthi test (GJK)
// and against a search along the segment.
#include "sim/fast/segment_contacts.hpp"

#include "setups.hpp"
#include "sim/object.hpp"
#include "sim/object_body.hpp"

#include <ccd/ccd.h>
#include <ccd/vec3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <string>

namespace twiddle::sim
{
namespace
{

constexpr double capsule_radius_m = 0.0065;
constexpr double near_m = 0.003; // of a capsule's surface to the object's, either sign, in random poses
constexpr int poses = 10000;

struct Segment {
    btVector3 start_m, end_m;

    btVector3 at(double share) const
    {
        return start_m + share * (end_m - start_m);
    }
    Segment moved(const btVector3 &by_m) const
    {
        return {start_m + by_m, end_m + by_m};
    }
};

ObjectBody body_named(const std::string &object)
{
    return object_body(read_object(TWIDDLE_MODELS, object), test::load_setup("mid-a").object);
}

SegmentContacts contacts_of(const RoundedCore &core, const Segment &segment, double reach_m)
{
    SegmentContacts contacts;
    find_segment_contacts(core, vector_of(segment.start_m), vector_of(segment.end_m), reach_m, contacts);
    return contacts;
}

// From the object's rounded surface to a point outside the core, from the object's outer dimensions.
double distance_m(const ObjectBody &body, const btVector3 &p_m)
{
    if (body.shape == Shape::sphere) return p_m.length() - body.radius_m;
    const double above_m = std::max(0.0, std::abs(p_m.z()) - (body.height_m / 2 - body.rounding_m));
    if (body.shape == Shape::cylinder) {
        const double across_m = std::max(0.0, std::hypot(p_m.x(), p_m.y()) - (body.radius_m - body.rounding_m));
        return std::hypot(across_m, above_m) - body.rounding_m;
    }
    const double half_m = body.side_m / 2 - body.rounding_m;
    const double x_m = std::max(0.0, std::abs(p_m.x()) - half_m), y_m = std::max(0.0, std::abs(p_m.y()) - half_m);
    return std::hypot(x_m, y_m, above_m) - body.rounding_m;
}

// The least distance along a segment: the best of 50 places, then golden section between its neighbours.
double least_distance_m(const ObjectBody &body, const Segment &segment)
{
    constexpr int places = 50;
    const auto f = [&](double share) { return distance_m(body, segment.at(share)); };
    int best = 0;
    for (int i = 1; i <= places; i++)
        if (f(double(i) / places) < f(double(best) / places)) best = i;
    double low = std::max(0, best - 1) / double(places), high = std::min(places, best + 1) / double(places);
    const double golden = (std::sqrt(5) - 1) / 2;
    double first = high - golden * (high - low), second = low + golden * (high - low);
    double at_first = f(first), at_second = f(second);
    while (high - low > 1e-12) {
        if (at_first < at_second) {
            high = second, second = first, at_second = at_first;
            at_first = f(first = high - golden * (high - low));
        } else {
            low = first, first = second, at_first = at_second;
            at_second = f(second = low + golden * (high - low));
        }
    }
    return std::min({f(0), f(1), f((low + high) / 2)});
}

btVector3 gradient(const ObjectBody &body, const btVector3 &p_m)
{
    constexpr double h_m = 1e-7;
    btVector3 slope;
    for (int axis = 0; axis < 3; axis++) {
        btVector3 step_m(0, 0, 0);
        step_m[axis] = h_m;
        slope[axis] = (distance_m(body, p_m + step_m) - distance_m(body, p_m - step_m)) / (2 * h_m);
    }
    return slope;
}

// libccd's two shapes: the rounded object in its own frame, and a capsule.
struct GjkObject {
    const ObjectBody &body;
};

struct GjkCapsule {
    Segment segment;
    double radius_m;
};

// libccd takes squares and products of lengths under 1e-16 for 0, so it gets micrometres.
constexpr double ccd_per_m = 1e6;

btVector3 direction_from_ccd(const ccd_vec3_t *direction)
{
    return btVector3(direction->v[0], direction->v[1], direction->v[2]).normalized();
}

void to_ccd(const btVector3 &from_m, ccd_vec3_t *to)
{
    ccdVec3Set(to, ccd_per_m * from_m.x(), ccd_per_m * from_m.y(), ccd_per_m * from_m.z());
}

void object_support(const void *shape, const ccd_vec3_t *direction, ccd_vec3_t *point)
{
    const ObjectBody &body = static_cast<const GjkObject *>(shape)->body;
    const btVector3 d = direction_from_ccd(direction);
    if (body.shape == Shape::sphere) return to_ccd(body.radius_m * d, point);
    btVector3 corner(0, 0, std::copysign(body.height_m / 2 - body.rounding_m, d.z()));
    if (body.shape == Shape::cube) {
        corner.setX(std::copysign(body.side_m / 2 - body.rounding_m, d.x()));
        corner.setY(std::copysign(body.side_m / 2 - body.rounding_m, d.y()));
    } else if (const double across = std::hypot(d.x(), d.y()); across > 0) {
        corner.setX((body.radius_m - body.rounding_m) * d.x() / across);
        corner.setY((body.radius_m - body.rounding_m) * d.y() / across);
    }
    to_ccd(corner + body.rounding_m * d, point);
}

void capsule_support(const void *shape, const ccd_vec3_t *direction, ccd_vec3_t *point)
{
    const auto &capsule = *static_cast<const GjkCapsule *>(shape);
    const btVector3 d = direction_from_ccd(direction);
    const bool at_end = d.dot(capsule.segment.end_m - capsule.segment.start_m) > 0;
    to_ccd((at_end ? capsule.segment.end_m : capsule.segment.start_m) + capsule.radius_m * d, point);
}

bool gjk_intersect(const ObjectBody &body, const Segment &segment, double radius_m)
{
    ccd_t ccd;
    CCD_INIT(&ccd);
    ccd.support1 = object_support;
    ccd.support2 = capsule_support;
    ccd.max_iterations = 10000;
    const GjkObject object{body};
    const GjkCapsule capsule{segment, radius_m};
    return ccdGJKIntersect(&object, &capsule, &ccd) != 0;
}

// A link's segment near the object: at a random place and in a random direction, which for `special` poses is along one
// of the object's axes or planes, exactly or but for a tilt of 1e-2 to 1e-12.
Segment random_segment(std::mt19937_64 &random, bool special)
{
    constexpr std::array<double, 4> length_m = {0.0148, 0.0168, 0.022, 0.026};
    std::uniform_real_distribution<double> place_m(-0.06, 0.06), power(-12, -2);
    std::normal_distribution<double> normal;
    btVector3 direction(normal(random), normal(random), normal(random));
    if (special) {
        const double tilt = random() % 2 == 0 ? 0 : std::pow(10, power(random));
        for (int axis = 0; axis < 3; axis++)
            if (random() % 2 == 0) direction[axis] *= tilt;
        if (direction.fuzzyZero()) direction.setZ(1);
    }
    const btVector3 middle_m(place_m(random), place_m(random), place_m(random));
    const btVector3 half_m = direction.normalized() * (length_m[random() % length_m.size()] / 2);
    return {middle_m - half_m, middle_m + half_m};
}

class fast_stepper_distances : public testing::TestWithParam<const char *>
{
  protected:
    // Calls judge(segment, least distance) for `count` random segments whose capsule is less than near_m apart from the
    // object or deep in it.
    template <class Judge> void for_random_segments(unsigned seed, int count, bool special, Judge &&judge)
    {
        std::printf("%s, seed %u\n", GetParam(), seed);
        std::mt19937_64 random(seed);
        for (int found = 0; found < count;) {
            const Segment segment = random_segment(random, special);
            if (distance_m(body_, segment.at(0.5)) > capsule_radius_m + near_m + 0.013) continue;
            const double least_m = least_distance_m(body_, segment);
            if (std::abs(least_m - capsule_radius_m) > near_m) continue;
            SCOPED_TRACE(found);
            judge(segment, least_m);
            if (HasFatalFailure()) return;
            ++found;
        }
    }

    const ObjectBody body_ = body_named(GetParam());
    const RoundedCore core_ = rounded_core(body_);
};

// Expected: GJK's verdict. A capsule as thick as the distance and 1 um touches the object, one 1 um thinner does not;
// and the real capsule, moved along the normal by its depth, does or does not as it lacks 1 um or has 1 um more.
TEST_P(fast_stepper_distances, are_those_of_gjk_within_a_micrometre)
{
    constexpr double tolerance_m = 1e-6;
    for_random_segments(1, poses, false, [&](const Segment &segment, double) {
        const SegmentContacts contacts = contacts_of(core_, segment, 0.02);
        ASSERT_GE(contacts.count, 1);
        const SegmentContact &closest = contacts.contact[0];
        const btVector3 normal = bullet_vector(closest.normal);
        const double closest_m = closest.distance_m;
        EXPECT_TRUE(gjk_intersect(body_, segment, closest_m + tolerance_m));
        EXPECT_FALSE(gjk_intersect(body_, segment, closest_m - tolerance_m));
        const double depth_m = capsule_radius_m - closest_m;
        EXPECT_TRUE(gjk_intersect(body_, segment.moved((depth_m - tolerance_m) * normal), capsule_radius_m));
        EXPECT_FALSE(gjk_intersect(body_, segment.moved((depth_m + tolerance_m) * normal), capsule_radius_m));
    });
}

// Expected: the search along the segment, in ordinary poses and in those where segment and object are parallel; and the
// normal of a closest point between the ends is upright on the segment.
TEST_P(fast_stepper_distances, are_the_least_along_the_segment_within_a_nanometre)
{
    double error_m = 0;
    for (const bool special : {false, true})
        for_random_segments(2, poses, special, [&](const Segment &segment, double least_m) {
            const SegmentContacts contacts = contacts_of(core_, segment, 0.02);
            ASSERT_GE(contacts.count, 1);
            const SegmentContact &closest = contacts.contact[0];
            EXPECT_NEAR(closest.distance_m, least_m, 1e-9);
            if (closest.share > 0 && closest.share < 1) {
                EXPECT_NEAR(bullet_vector(closest.normal).dot((segment.end_m - segment.start_m).normalized()), 0, 1e-9);
            }
            error_m = std::max(error_m, std::abs(closest.distance_m - least_m));
        });
    std::printf("  largest error %.1e m\n", error_m);
}

// Expected: every contact's distance from the object's outer dimensions; its normal is of length 1, is the distance's
// gradient by differences, and leads back from the segment's point to the surface.
TEST_P(fast_stepper_distances, have_normals_that_lead_back_to_the_surface)
{
    for (const bool special : {false, true})
        for_random_segments(3, poses / 10, special, [&](const Segment &segment, double) {
            const SegmentContacts contacts = contacts_of(core_, segment, 0.02);
            for (int i = 0; i < contacts.count; i++) {
                const SegmentContact &contact = contacts.contact[i];
                const btVector3 p_m = segment.at(contact.share);
                ASSERT_TRUE(contact.share >= 0 && contact.share <= 1) << contact.share;
                EXPECT_NEAR(bullet_vector(contact.normal).length(), 1, 1e-12);
                EXPECT_NEAR(contact.distance_m, distance_m(body_, p_m), 1e-12);
                EXPECT_NEAR(distance_m(body_, p_m - contact.distance_m * bullet_vector(contact.normal)), 0, 1e-12);
                EXPECT_LT((bullet_vector(contact.normal) - gradient(body_, p_m)).length(), 1e-4);
            }
        });
}

// Expected: all that is nearer than the reach and nothing else; the closest point first; no two points within 0.1 mm;
// the ends of the segment among them unless there are four nearer ones.
TEST_P(fast_stepper_distances, reach_as_far_as_asked)
{
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> any_m(0.004, 0.02);
    for_random_segments(4, poses / 10, true, [&](const Segment &segment, double least_m) {
        const double reach_m = any_m(random), length_m = (segment.end_m - segment.start_m).length();
        const SegmentContacts contacts = contacts_of(core_, segment, reach_m);
        EXPECT_EQ(contacts.count > 0, least_m < reach_m);
        for (int i = 0; i < contacts.count; i++) {
            EXPECT_LT(contacts.contact[i].distance_m, reach_m);
            EXPECT_GE(contacts.contact[i].distance_m, contacts.contact[0].distance_m - 1e-12);
            for (int j = 0; j < i; j++)
                EXPECT_GE(std::abs(contacts.contact[i].share - contacts.contact[j].share) * length_m, 0.99e-4);
        }
        EXPECT_LE(contacts.count, body_.shape == Shape::sphere ? 1 : 4);
        if (body_.shape == Shape::sphere || contacts.count == 4) return;
        for (const double end : {0.0, 1.0}) {
            if (distance_m(body_, segment.at(end)) >= reach_m) continue;
            EXPECT_TRUE(std::any_of(
                contacts.contact.begin(), contacts.contact.begin() + contacts.count,
                [&](const SegmentContact &contact) { return std::abs(contact.share - end) * length_m < 1.01e-4; }));
        }
    });
}

// Expected: the distance of a point.
TEST_P(fast_stepper_distances, of_segments_without_length_are_those_of_a_point)
{
    for_random_segments(5, poses / 100, false, [&](const Segment &segment, double) {
        for (const double length : {0.0, 1e-300, 1e-20, 1e-15, 1e-12, 1e-9}) {
            const Segment tiny{segment.start_m, segment.at(length)};
            const SegmentContacts contacts = contacts_of(core_, tiny, 0.05);
            ASSERT_EQ(contacts.count, 1);
            EXPECT_NEAR(contacts.contact[0].distance_m, distance_m(body_, segment.start_m), 1e-10);
            EXPECT_NEAR(bullet_vector(contacts.contact[0].normal).length(), 1, 1e-12);
        }
    });
}

// Expected: numbers, a normal of length 1 and a negative distance for whatever lies in the object.
TEST_P(fast_stepper_distances, are_numbers_inside_the_object)
{
    std::mt19937_64 random(6);
    std::uniform_real_distribution<double> place_m(-0.009, 0.009);
    for (int i = 0; i < poses; i++) {
        Segment segment = random_segment(random, true);
        const btVector3 within_m(place_m(random), place_m(random), place_m(random));
        segment = segment.moved(within_m - segment.at(0.5));
        if (i % 3 == 0) segment = segment.moved(-segment.start_m); // from the very centre
        const SegmentContacts contacts = contacts_of(core_, segment, 0.05);
        ASSERT_GE(contacts.count, 1) << "pose " << i;
        EXPECT_LT(contacts.contact[0].distance_m, 0) << "pose " << i;
        for (int j = 0; j < contacts.count; j++) {
            EXPECT_NEAR(bullet_vector(contacts.contact[j].normal).length(), 1, 1e-12) << "pose " << i;
            EXPECT_TRUE(std::isfinite(contacts.contact[j].distance_m)) << "pose " << i;
        }
    }
}

// Of a segment out of reach, too. Expected: no point of it is nearer to the outer dimensions; the closest one is that
// near if it is in reach.
TEST_P(fast_stepper_distances, return_what_no_point_is_nearer_than)
{
    constexpr double rounding_m = 1e-12;
    constexpr double reach_m = 0.01;
    std::mt19937_64 random(7);
    int in_reach = 0, outside = 0;
    for (int i = 0; i < poses; i++) {
        const Segment segment = random_segment(random, i % 2 == 0);
        SegmentContacts contacts;
        const double least_m =
            find_segment_contacts(core_, vector_of(segment.start_m), vector_of(segment.end_m), reach_m, contacts);
        if (contacts.count > 0) {
            in_reach++;
            EXPECT_EQ(least_m, contacts.contact[0].distance_m) << "pose " << i;
            continue;
        }
        outside++;
        EXPECT_GE(least_m, reach_m - rounding_m) << "pose " << i;
        for (int k = 0; k <= 50; k++)
            ASSERT_GE(distance_m(body_, segment.at(k / 50.0)), least_m - rounding_m) << "pose " << i;
    }
    EXPECT_GT(in_reach, 100);
    EXPECT_GT(outside, 100);
}

INSTANTIATE_TEST_SUITE_P(Sim, fast_stepper_distances,
                         testing::Values("small-sphere", "medium-sphere", "large-sphere", "small-cylinder",
                                         "medium-cylinder", "large-cylinder", "small-cube", "medium-cube",
                                         "large-cube"),
                         [](const auto &object) {
                             std::string name = object.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

} // namespace
} // namespace twiddle::sim
