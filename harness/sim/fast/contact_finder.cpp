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

// More than all roundings of what a finger has travelled in a trial.
constexpr double rounding_m = 1e-9;

// A vector turned by `angle` about z; with the opposite sine, turned back.
Vector turned(const SineCosine &angle, const Vector &v)
{
    return {angle.cosine * v.x - angle.sine * v.y, angle.sine * v.x + angle.cosine * v.y, v.z};
}

// Two unit vectors across `normal`, in lanes; the first is level.
PairVector tangents(const Vector &normal)
{
    const double across = std::sqrt(normal.x * normal.x + normal.y * normal.y);
    if (across < 1e-6) return {Pair{1, 0}, Pair{0, std::copysign(1, normal.z)}, Pair{0, 0}};
    const double inverse = 1 / across, x = -normal.y * inverse, y = normal.x * inverse;
    return {Pair{x, -normal.z * y}, Pair{y, normal.z * x}, Pair{0, across}};
}

PairVector in_both_lanes(const Vector &v)
{
    return pair_of(v, v);
}

bool has_contact_at(const Contacts &contacts, int finger, const Vector &p_axis_m)
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
    MassFactor mass;
    const Velocities &free;
    SineCosine first_angle; // of the finger's first joint
    Vector second_origin_m, second_x, second_y, second_z;
    bool turns;           // whether the object looks different when it has turned
    SineCosine turned_by; // how far it has
    double reach_m;       // beyond a capsule's radius
    double travelled_m;
};

ContactFinder::ContactFinder(const std::array<FingerKinematics, 2> &fingers, const ObjectBody &object,
                             double breaking_threshold_m, double error_reduction, double substep_s)
    : kinematics_(fingers), pair_kinematics_(fingers), core_(rounded_core(object)),
      whitening_(std::sqrt(object.inertia_kg_m2)), inverse_whitening_(1 / whitening_),
      breaking_threshold_m_(breaking_threshold_m), error_reduction_(error_reduction), substep_s_(substep_s)
{
    for (int joint = 0; joint < 2; joint++)
        stride_m_[joint] = substep_s * Pair{fingers[0].reach_m(joint), fingers[1].reach_m(joint)};
    // Sphere and cylinder look the same however they are turned.
    object_stride_m_ = core_.shape == Shape::cube ? substep_s * core_.bounding_radius_m : 0;
    for (int f = 0; f < 2; f++) {
        finger_[f].origin_m = vector_of(fingers[f].first().origin_m);
        finger_[f].axis = vector_of(fingers[f].first().z);
        for (int joint = 0; joint < 2; joint++) {
            const CarriedCapsules &carried = fingers[f].carried(joint);
            for (const LinkCapsule &link : carried.capsules)
                finger_[f].capsules.push_back({joint, vector_of(carried.points_m[link.start]),
                                               vector_of(carried.points_m[link.end]), link.radius_m, 0});
        }
    }
}

void ContactFinder::reset()
{
    travelled_m_ = Pair{};
    for (Finger &finger : finger_) {
        finger.due_m = 0;
        for (Capsule &capsule : finger.capsules)
            capsule.due_m = 0;
    }
}

void ContactFinder::find(const Motion &motion, const MassFactorOf<Pair> &mass, const Velocities &free,
                         Contacts &contacts)
{
    contacts.clear();
    travelled_m_ += stride_m_[0] * size_of(motion.velocity_rad_s[0]) +
                    stride_m_[1] * size_of(motion.velocity_rad_s[1]) + object_stride_m_ * std::abs(motion.object_rad_s);
    // A contact that is farther away than this cannot come near within the substep.
    const Pair may_matter_m = stride_m_[0] * size_of(motion.free_velocity_rad_s[0]) +
                              stride_m_[1] * size_of(motion.free_velocity_rad_s[1]) +
                              object_stride_m_ * std::abs(free.object * inverse_whitening_) + reserve_m;
    const Pair limit_m = travelled_m_ + may_matter_m;
    const std::array<bool, 2> due = {limit_m[0] >= finger_[0].due_m, limit_m[1] >= finger_[1].due_m};
    if (!due[0] && !due[1]) return;

    const PairFrame second = pair_kinematics_.second_frames(motion.angle);
    const bool turns = core_.shape == Shape::cube;
    const SineCosine turned_by = turns ? sine_cosine(motion.object_rad) : SineCosine{};
    for (int f = 0; f < 2; f++) {
        if (!due[f]) continue;
        const Scene scene{f,
                          lane(mass, f),
                          free,
                          {motion.angle[0].sine[f], motion.angle[0].cosine[f]},
                          lane(second.origin_m, f),
                          lane(second.x, f),
                          lane(second.y, f),
                          lane(second.z, f),
                          turns,
                          turned_by,
                          std::min(may_matter_m[f], breaking_threshold_m_),
                          travelled_m_[f]};
        look(scene, finger_[f], limit_m[f], contacts);
    }
}

void ContactFinder::look(const Scene &scene, Finger &finger, double limit_m, Contacts &contacts) const
{
    finger.due_m = 1e30;
    int first_feature = 0;
    for (Capsule &capsule : finger.capsules) {
        if (limit_m >= capsule.due_m) look_at(scene, capsule, first_feature, contacts);
        finger.due_m = std::min(finger.due_m, capsule.due_m);
        first_feature += contact_features;
    }
}

std::array<Vector, 2> ContactFinder::ends_m(const Scene &scene, const Capsule &capsule) const
{
    if (capsule.joint == 0) {
        const Frame first = kinematics_[scene.finger].first().turned(scene.first_angle);
        return {vector_of(first.point(bullet_vector(capsule.start_m))),
                vector_of(first.point(bullet_vector(capsule.end_m)))};
    }
    const auto point_m = [&](const Vector &p_m) {
        return scene.second_origin_m + scene.second_x * p_m.x + scene.second_y * p_m.y + scene.second_z * p_m.z;
    };
    return {point_m(capsule.start_m), point_m(capsule.end_m)};
}

void ContactFinder::look_at(const Scene &scene, Capsule &capsule, int first_feature, Contacts &contacts) const
{
    const auto [start_m, end_m] = ends_m(scene, capsule);
    const SineCosine back = {-scene.turned_by.sine, scene.turned_by.cosine};
    SegmentContacts places;
    const double away_m =
        find_segment_contacts(core_, scene.turns ? turned(back, start_m) : start_m,
                              scene.turns ? turned(back, end_m) : end_m, capsule.radius_m + scene.reach_m, places);
    capsule.due_m = scene.travelled_m + away_m - capsule.radius_m - rounding_m;
    for (int k = 0; k < places.count; k++) {
        const SegmentContact &place = places.contact[k];
        const Vector p_axis_m = start_m + (end_m - start_m) * place.share;
        if (contacts.full() || has_contact_at(contacts, scene.finger, p_axis_m)) continue;
        const Vector normal = scene.turns ? turned(scene.turned_by, place.normal) : place.normal;
        add_contact(scene, capsule, p_axis_m, place, normal, first_feature + place.feature, contacts);
    }
}

void ContactFinder::add_contact(const Scene &scene, const Capsule &capsule, const Vector &p_axis_m,
                                const SegmentContact &place, const Vector &normal, int feature,
                                Contacts &contacts) const
{
    const Finger &finger = finger_[scene.finger];
    const Vector p_finger_m = p_axis_m - normal * capsule.radius_m;
    const Vector p_object_m = p_axis_m - normal * place.distance_m;
    // Velocities of the finger's point for 1 rad/s of its joints, and of the object's for 1 rad/s of the hinge.
    const Vector by_first = finger.axis.cross(p_finger_m - finger.origin_m);
    const Vector by_second =
        capsule.joint == 0 ? Vector{0, 0, 0} : scene.second_z.cross(p_finger_m - scene.second_origin_m);

    const MassFactor &mass = scene.mass;
    const FingerVector row = mass.whitened({normal.dot(by_first), normal.dot(by_second)});
    const double object_row = (normal.x * p_object_m.y - normal.y * p_object_m.x) * inverse_whitening_;
    const FingerVector &free = scene.free.finger[scene.finger];
    const double normal_m_s = row[0] * free[0] + row[1] * free[1] + object_row * scene.free.object;
    const double distance_m = place.distance_m - capsule.radius_m;
    if (distance_m + normal_m_s * substep_s_ > reserve_m) return;

    const PairVector across = tangents(normal);
    const Pair first_moves = across.dot(in_both_lanes(by_first)), second_moves = across.dot(in_both_lanes(by_second));
    const Pair first = mass.inverse_root[0] * (first_moves - mass.coupling * second_moves);
    const Pair second = mass.inverse_root[1] * second_moves;
    const Pair object = (across.x * p_object_m.y - across.y * p_object_m.x) * inverse_whitening_;

    Contact &contact = contacts.add();
    contact.finger = scene.finger;
    contact.finger_row = {{row, {first[0], second[0]}, {first[1], second[1]}}};
    contact.object_row = {object_row, object[0], object[1]};
    contact.least_normal_m_s = -(distance_m > 0 ? 1 : error_reduction_) * distance_m / substep_s_;
    contact.solution = {};
    contact.feature = feature;
    contact.distance_m = distance_m;
    contact.p_axis_m = p_axis_m;
}

} // namespace twiddle::sim
