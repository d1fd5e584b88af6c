#include "contact_finder.hpp"

#include <cmath>

namespace twiddle::sim
{

namespace
{

// How much further than its velocity says other contacts may push a contact within a substep; one that is still open
// then is left out.
constexpr double reserve_m = 0.001;

// Contacts of a finger nearer to each other than this are one: neighbouring capsules share an end sphere.
constexpr double same_contact_m = 1e-4;

// A vector or a frame, seen from axes turned by `angle` about z.
btVector3 turned_back(const SineCosine &angle, const btVector3 &v)
{
    return {angle.cosine * v.x() + angle.sine * v.y(), angle.cosine * v.y() - angle.sine * v.x(), v.z()};
}

Frame turned_back(const SineCosine &angle, const Frame &frame)
{
    return {turned_back(angle, frame.origin_m), turned_back(angle, frame.x), turned_back(angle, frame.y),
            turned_back(angle, frame.z)};
}

// Two unit vectors across `normal`; the first is level.
std::array<btVector3, 2> tangents(const btVector3 &normal)
{
    const double across = std::sqrt(normal.x() * normal.x() + normal.y() * normal.y());
    if (across < 1e-6) return {btVector3(1, 0, 0), normal.cross(btVector3(1, 0, 0)).normalized()};
    const btVector3 level(-normal.y() / across, normal.x() / across, 0);
    return {level, normal.cross(level)};
}

bool has_contact_at(const Contacts &contacts, int finger, const btVector3 &p_axis_m)
{
    for (const Contact &contact : contacts) {
        if (contact.finger == finger && (contact.p_axis_m - p_axis_m).length2() < same_contact_m * same_contact_m)
            return true;
    }
    return false;
}

} // namespace

struct ContactFinder::Scene {
    int finger;
    const FingerState &state;
    const Velocities &free;
    std::array<Frame, 2> frame; // of the joints, in the object's frame
};

ContactFinder::ContactFinder(const std::array<FingerKinematics, 2> &fingers, const ObjectBody &object,
                             double breaking_threshold_m, double error_reduction, double substep_s)
    : fingers_(fingers), core_(rounded_core(object)), whitening_(std::sqrt(object.inertia_kg_m2)),
      inverse_whitening_(1 / whitening_), breaking_threshold_m_(breaking_threshold_m),
      error_reduction_(error_reduction), substep_s_(substep_s)
{
}

void ContactFinder::find(const std::array<FingerState, 2> &state, double object_rad, const Velocities &free,
                         Contacts &contacts) const
{
    contacts.clear();
    for (int f = 0; f < 2; f++) {
        const FingerKinematics &finger = fingers_[f];
        std::array<bool, 2> near;
        for (int joint = 0; joint < 2; joint++) {
            const PolarPlace centre = finger.centre(joint, state[f].angle);
            near[joint] = may_touch(core_, centre.square_across_m2, centre.height_m,
                                    finger.carried(joint).radius_m + breaking_threshold_m_);
        }
        if (!near[0] && !near[1]) continue;
        Scene scene{f, state[f], free, finger.frames(state[f].angle)};
        // Sphere and cylinder look the same however they are turned.
        if (core_.shape == Shape::cube) {
            const SineCosine angle = sine_cosine(object_rad);
            for (Frame &frame : scene.frame)
                frame = turned_back(angle, frame);
        }
        for (int joint = 0; joint < 2; joint++) {
            if (near[joint]) find_of_joint(scene, joint, contacts);
        }
    }
}

void ContactFinder::find_of_joint(const Scene &scene, int joint, Contacts &contacts) const
{
    const CarriedCapsules &carried = fingers_[scene.finger].carried(joint);
    std::array<btVector3, 2 * most_capsules> p_m;
    for (std::size_t i = 0; i < carried.points_m.size(); i++)
        p_m[i] = scene.frame[joint].point(carried.points_m[i]);
    for (std::size_t capsule = 0; capsule < carried.capsules.size(); capsule++) {
        const LinkCapsule &link = carried.capsules[capsule];
        const btVector3 &start_m = p_m[link.start], &end_m = p_m[link.end];
        SegmentContacts places;
        find_segment_contacts(core_, start_m, end_m, link.radius_m + breaking_threshold_m_, places);
        for (int i = 0; i < places.count; i++) {
            const SegmentContact &place = places.contact[i];
            const btVector3 p_axis_m = start_m + place.share * (end_m - start_m);
            if (contacts.full() || has_contact_at(contacts, scene.finger, p_axis_m)) continue;
            const int feature = (joint * most_capsules + static_cast<int>(capsule)) * contact_features + place.feature;
            add_contact(scene, joint, p_axis_m, place, link.radius_m, feature, contacts);
        }
    }
}

void ContactFinder::add_contact(const Scene &scene, int joint, const btVector3 &p_axis_m, const SegmentContact &place,
                                double radius_m, int feature, Contacts &contacts) const
{
    const btVector3 p_finger_m = p_axis_m - radius_m * place.normal;
    const btVector3 p_object_m = p_axis_m - place.distance_m * place.normal;
    // Velocities of the finger's point for 1 rad/s of its joints, and of the object's for 1 rad/s of the hinge.
    const btVector3 by_first = scene.frame[0].z.cross(p_finger_m - scene.frame[0].origin_m);
    const btVector3 by_second =
        joint == 0 ? btVector3(0, 0, 0) : scene.frame[1].z.cross(p_finger_m - scene.frame[1].origin_m);
    const btVector3 by_hinge(-p_object_m.y(), p_object_m.x(), 0);

    Contact contact;
    contact.distance_m = place.distance_m - radius_m;
    const auto set_row = [&](int i, const btVector3 &direction) {
        contact.finger_row[i] = scene.state.mass.whitened({direction.dot(by_first), direction.dot(by_second)});
        contact.object_row[i] = -direction.dot(by_hinge) * inverse_whitening_;
    };
    set_row(0, place.normal);
    const FingerVector &free = scene.free.finger[scene.finger];
    const double normal_m_s = contact.finger_row[0][0] * free[0] + contact.finger_row[0][1] * free[1] +
                              contact.object_row[0] * scene.free.object;
    if (contact.distance_m + normal_m_s * substep_s_ > reserve_m) return;

    const auto across = tangents(place.normal);
    set_row(1, across[0]);
    set_row(2, across[1]);
    contact.finger = scene.finger;
    contact.feature = feature;
    contact.p_axis_m = p_axis_m;
    const double share = contact.distance_m > 0 ? 1 : error_reduction_;
    contact.least_normal_m_s = -share * contact.distance_m / substep_s_;
    contacts.add(contact);
}

} // namespace twiddle::sim
