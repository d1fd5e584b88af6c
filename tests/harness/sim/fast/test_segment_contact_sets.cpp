// Which points hold a segment on the object, in poses where they are known: lying flat, along an edge, inside.
#include "sim/fast/segment_contacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace twiddle::sim
{
namespace
{

constexpr double rounding_m = 0.0005, gap_m = 0.0065;
constexpr double exact_m = 1e-12;

ObjectBody rounded_body(Shape shape, double across_m, double height_m)
{
    ObjectBody body;
    body.shape = shape;
    body.height_m = height_m;
    (shape == Shape::cube ? body.side_m : body.radius_m) = across_m;
    if (shape != Shape::sphere) body.rounding_m = rounding_m;
    return body;
}

const RoundedCore cube = rounded_core(rounded_body(Shape::cube, 0.020, 0.020));
const RoundedCore cylinder = rounded_core(rounded_body(Shape::cylinder, 0.032, 0.040));
const RoundedCore sphere = rounded_core(rounded_body(Shape::sphere, 0.032, 0.064));

SegmentContacts contacts_of(const RoundedCore &core, const btVector3 &start_m, const btVector3 &end_m, double reach_m)
{
    SegmentContacts contacts;
    find_segment_contacts(core, vector_of(start_m), vector_of(end_m), reach_m, contacts);
    return contacts;
}

std::vector<int> features(const SegmentContacts &contacts)
{
    std::vector<int> names;
    for (int i = 0; i < contacts.count; i++)
        names.push_back(contacts.contact[i].feature);
    std::sort(names.begin(), names.end());
    return names;
}

// The contact of a feature; a failure if there is none.
SegmentContact contact_of(const SegmentContacts &contacts, int feature)
{
    for (int i = 0; i < contacts.count; i++)
        if (contacts.contact[i].feature == feature) return contacts.contact[i];
    ADD_FAILURE() << "no contact of feature " << feature;
    return {-1, Vector{0, 0, 0}, 0, feature};
}

void expect_contact(const SegmentContacts &contacts, int feature, double share, const btVector3 &normal,
                    double distance_m)
{
    const SegmentContact contact = contact_of(contacts, feature);
    EXPECT_NEAR(contact.share, share, 1e-9) << "feature " << feature;
    EXPECT_LT((bullet_vector(contact.normal) - normal).length(), 1e-9) << "feature " << feature;
    EXPECT_NEAR(contact.distance_m, distance_m, exact_m) << "feature " << feature;
}

const btVector3 x_axis(1, 0, 0), z_axis(0, 0, 1);

TEST(fast_stepper_contact_sets, a_segment_flat_on_a_face_has_its_two_ends)
{
    const double z_m = 0.010 + gap_m;
    const SegmentContacts contacts = contacts_of(cube, {-0.008, 0.002, z_m}, {0.008, -0.003, z_m}, 0.0085);
    EXPECT_EQ(features(contacts), (std::vector<int>{contact_start, contact_end}));
    expect_contact(contacts, contact_start, 0, z_axis, gap_m);
    expect_contact(contacts, contact_end, 1, z_axis, gap_m);
}

// The core's face goes from -9.5 to 9.5 mm; the ends hang 3.5 mm over and are out of reach.
TEST(fast_stepper_contact_sets, a_segment_flat_across_a_face_has_the_faces_edges)
{
    const double z_m = 0.010 + gap_m;
    const SegmentContacts contacts = contacts_of(cube, {-0.013, 0.002, z_m}, {0.013, 0.002, z_m}, 0.0068);
    EXPECT_EQ(features(contacts), (std::vector<int>{contact_first_clip, contact_second_clip}));
    expect_contact(contacts, contact_first_clip, 3.5 / 26, z_axis, gap_m);
    expect_contact(contacts, contact_second_clip, 22.5 / 26, z_axis, gap_m);
}

// The segment stands 4.5 mm out in x and y from the core's upright edge, which goes up to 9.5 mm; upright, or leaning
// so little that the distances stay.
TEST(fast_stepper_contact_sets, a_segment_along_an_edge_has_the_edges_end)
{
    const btVector3 start_m(0.014, 0.014, -0.008), end_m(0.014, 0.014, 0.012);
    const btVector3 normal = btVector3(1, 1, 0).normalized();
    const double distance_m = 0.0045 * std::sqrt(2) - rounding_m;
    for (const btVector3 &lean_m : {btVector3(0, 0, 0), btVector3(1e-13, 0, 0), btVector3(0, -1e-13, 0)}) {
        const SegmentContacts contacts = contacts_of(cube, start_m, end_m + lean_m, 0.00626);
        EXPECT_EQ(features(contacts), (std::vector<int>{contact_start, contact_second_clip}));
        expect_contact(contacts, contact_start, 0, normal, distance_m);
        expect_contact(contacts, contact_second_clip, 17.5 / 20, normal, distance_m);
    }
}

TEST(fast_stepper_contact_sets, a_segment_upright_beside_a_cylinder_has_its_ends)
{
    const double x_m = 0.032 + gap_m;
    const SegmentContacts contacts = contacts_of(cylinder, {x_m, 0, 0.015}, {x_m, 0, -0.011}, 0.0085);
    EXPECT_EQ(features(contacts), (std::vector<int>{contact_start, contact_end}));
    expect_contact(contacts, contact_start, 0, x_axis, gap_m);
    expect_contact(contacts, contact_end, 1, x_axis, gap_m);
}

// The core's side goes up to 19.5 mm.
TEST(fast_stepper_contact_sets, a_segment_hanging_over_a_cylinders_side_has_the_sides_end)
{
    const double x_m = 0.032 + gap_m;
    const SegmentContacts contacts = contacts_of(cylinder, {x_m, 0, 0.0}, {x_m, 0, 0.025}, 0.0068);
    EXPECT_EQ(features(contacts), (std::vector<int>{contact_start, contact_second_clip}));
    expect_contact(contacts, contact_start, 0, x_axis, gap_m);
    expect_contact(contacts, contact_second_clip, 19.5 / 25, x_axis, gap_m);
}

// 30 mm off the axis a chord of the core's cap of 31.5 mm is 2 sqrt(31.5^2 - 30^2) mm long.
TEST(fast_stepper_contact_sets, a_segment_across_a_cylinders_cap_has_the_chords_ends)
{
    const double z_m = -0.020 - gap_m, half_m = std::sqrt(0.0315 * 0.0315 - 0.030 * 0.030);
    const SegmentContacts contacts = contacts_of(cylinder, {-0.013, 0.030, z_m}, {0.013, 0.030, z_m}, 0.0066);
    EXPECT_EQ(features(contacts), (std::vector<int>{contact_first_clip, contact_second_clip}));
    expect_contact(contacts, contact_first_clip, (0.013 - half_m) / 0.026, -z_axis, gap_m);
    expect_contact(contacts, contact_second_clip, (0.013 + half_m) / 0.026, -z_axis, gap_m);
}

// While the segment tips from one end to the other, the deeper end stands first and both keep their names.
TEST(fast_stepper_contact_sets, keep_their_names_while_a_segment_rocks)
{
    for (const double tip_m : {-1e-5, -1e-9, -1e-15, 0.0, 1e-15, 1e-9, 1e-5}) {
        const double z_m = 0.010 + gap_m, x_m = 0.032 + gap_m;
        const auto flat = contacts_of(cube, {-0.008, 0, z_m - tip_m}, {0.008, 0, z_m + tip_m}, 0.0085);
        const auto upright = contacts_of(cylinder, {x_m - tip_m, 0, -0.013}, {x_m + tip_m, 0, 0.013}, 0.0085);
        for (const SegmentContacts &contacts : {flat, upright}) {
            EXPECT_EQ(features(contacts), (std::vector<int>{contact_start, contact_end})) << tip_m;
            if (tip_m != 0) {
                EXPECT_EQ(contacts.contact[0].feature, tip_m > 0 ? contact_start : contact_end) << tip_m;
            }
            EXPECT_NEAR(contact_of(contacts, contact_start).distance_m, gap_m - tip_m, exact_m);
            EXPECT_NEAR(contact_of(contacts, contact_end).distance_m, gap_m + tip_m, exact_m);
        }
    }
}

// Across a face, low end first: the closest point is beyond the face's edge by more than 0.1 mm, so
// that there are five.
TEST(fast_stepper_contact_sets, leave_out_the_farthest_of_five)
{
    const double z_m = 0.010 + gap_m;
    const auto contacts = contacts_of(cube, {-0.013, 0, z_m - 0.0005}, {0.013, 0, z_m + 0.0005}, 0.02);
    EXPECT_EQ(features(contacts),
              (std::vector<int>{contact_closest, contact_start, contact_first_clip, contact_second_clip}));
    EXPECT_EQ(contacts.contact[0].feature, contact_closest);
}

TEST(fast_stepper_contact_sets, of_a_sphere_have_one_point)
{
    const auto contacts = contacts_of(sphere, {0.032 + gap_m, 0, -0.010}, {0.032 + gap_m, 0, 0.015}, 0.0085);
    EXPECT_EQ(features(contacts), (std::vector<int>{contact_closest}));
    expect_contact(contacts, contact_closest, 0.4, x_axis, gap_m);
}

// Expected: the nearest point of the unrounded surface, which for a point of the core is that of the rounded one.
TEST(fast_stepper_contact_sets, of_a_point_inside_lead_out_the_shortest_way)
{
    const auto expect_way = [](const RoundedCore &core, const btVector3 &p_m, const btVector3 &normal, double out_m) {
        const SegmentContacts contacts = contacts_of(core, p_m, p_m, 0.0085);
        ASSERT_EQ(contacts.count, 1);
        EXPECT_LT((bullet_vector(contacts.contact[0].normal) - normal).length(), 1e-12);
        EXPECT_NEAR(contacts.contact[0].distance_m, -out_m, exact_m);
    };
    expect_way(cube, {0.004, -0.007, 0.003}, {0, -1, 0}, 0.003);
    expect_way(cube, {0.004, 0.005, -0.006}, -z_axis, 0.004);
    expect_way(cylinder, {0.018, -0.024, 0.001}, {0.6, -0.8, 0}, 0.002);
    expect_way(cylinder, {0.018, -0.004, 0.015}, z_axis, 0.005);
    expect_way(cylinder, {0, 0, 0.001}, z_axis, 0.019);
    expect_way(sphere, {0, 0, -0.012}, -z_axis, 0.020);
    expect_way(sphere, {0, 0, 0}, x_axis, 0.032);
}

// From 15 mm out to 5 mm in, off the middle: half of the way inside the core of 9.5 mm is at 7.25 mm, 2.75 mm deep.
TEST(fast_stepper_contact_sets, of_a_segment_into_the_core_start_in_the_middle_of_the_part_inside)
{
    const SegmentContacts contacts = contacts_of(cube, {0.015, 0.001, 0}, {0.005, 0.001, 0}, 0.0085);
    ASSERT_GE(contacts.count, 1);
    EXPECT_NEAR(contacts.contact[0].share, 0.775, 1e-9);
    EXPECT_NEAR(contacts.contact[0].distance_m, -0.00275, exact_m);
}

} // namespace
} // namespace twiddle::sim
