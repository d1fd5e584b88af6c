#include "calibration/reach.hpp"

#include "sim/fixtures.hpp"
#include "sim/object_body.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using namespace twiddle;
using namespace twiddle::sim;
using calibration::Reach;

constexpr double rad_per_deg = 0.017453292519943295;

std::vector<ObjectSpec> all_objects()
{
    std::vector<ObjectSpec> objects;
    for (const std::string &name : object_names(TWIDDLE_MODELS)) {
        objects.push_back(read_object(TWIDDLE_MODELS, name));
    }
    return objects;
}

double distance_to_segment_m(const btVector3 &point_m, const std::array<btVector3, 2> &ends_m)
{
    const btVector3 along = ends_m[1] - ends_m[0];
    const double share = std::clamp((point_m - ends_m[0]).dot(along) / along.length2(), 0.0, 1.0);
    return (point_m - (ends_m[0] + share * along)).length();
}

// Gap between the index and a sphere, in closed form.
double index_gap_m(ArticulatedHand &hand, const ObjectBody &sphere, double fei_deg)
{
    std::vector<double> posture;
    for (const ArticulatedLink &link : hand.links()) {
        if (link.moves) posture.push_back(link.body_link == hand.controlled()[fei] ? fei_deg * rad_per_deg : 0);
    }
    hand.set_posture(posture);
    double gap_m = std::numeric_limits<double>::infinity();
    for (int link = 0; link < static_cast<int>(hand.links().size()); ++link) {
        if (hand.links()[static_cast<std::size_t>(link)].finger != Finger::index) continue;
        const double distance_m = distance_to_segment_m(sphere.p_palm_centre_m, hand.p_palm_capsule_m(link));
        gap_m = std::min(gap_m, distance_m - sphere.radius_m - hand.capsule(link).radius_m);
    }
    return gap_m;
}

TEST(Reach, the_index_meets_a_sphere_where_a_closed_form_says)
{
    const settings::Setup setup = default_setup();
    ArticulatedHand hand(icub_hand(), setup.hand, HandHold::welded);
    Reach reach(icub_hand(), setup);
    for (const char *name : {"small-sphere", "medium-sphere", "large-sphere"}) {
        const ObjectSpec object = read_object(TWIDDLE_MODELS, name);
        const ObjectBody body = object_body(object, setup.object);
        const auto contact_deg = reach.index_contact_deg(object, 0, 90);
        ASSERT_TRUE(contact_deg) << name;
        EXPECT_LE(index_gap_m(hand, body, *contact_deg), 0) << name;
        EXPECT_GT(index_gap_m(hand, body, *contact_deg - calibration::reach_step_deg), 0) << name;
    }
}

TEST(Reach, a_window_is_met_only_if_every_object_is)
{
    Reach reach(icub_hand(), default_setup());
    const std::vector<ObjectSpec> objects = all_objects();
    EXPECT_TRUE(reach.fits(objects, {{0, 90}, {-15, 15}, {0, 90}, {0, 130}}));
    EXPECT_FALSE(reach.fits(objects, {{0, 20}, {-15, 15}, {0, 90}, {0, 130}})) << "the index reaches the object later";
    EXPECT_FALSE(reach.fits(objects, {{0, 90}, {-15, 15}, {0, 3}, {0, 130}})) << "the thumb reaches the object later";
}

TEST(Reach, a_hand_that_stands_in_the_object_is_not_clear)
{
    Reach inside(icub_hand(), default_setup({{"object.centre_z_m", "0.02"}}));
    const ObjectSpec object = read_object(TWIDDLE_MODELS, "large-sphere");
    EXPECT_FALSE(inside.straight_hand_is_clear(object));
    EXPECT_FALSE(inside.fits({object}, {{0, 90}, {-15, 15}, {0, 90}, {0, 130}}));
    EXPECT_TRUE(Reach(icub_hand(), default_setup()).straight_hand_is_clear(object));
}

} // namespace
