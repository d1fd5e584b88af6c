#include "finger_kinematics.hpp"

#include <algorithm>

namespace twiddle::sim
{

namespace
{

Frame frame_of(const btTransform &X)
{
    return {X.getOrigin(), X.getBasis().getColumn(0), X.getBasis().getColumn(1), X.getBasis().getColumn(2)};
}

// Frame of the joint of Bullet link `body_link`, as the hand stands.
btTransform joint_frame(const ArticulatedHand &hand, int body_link)
{
    int link = 0;
    while (hand.links()[link].body_link != body_link)
        link++; // the first of a rigid group is the one that its joint moves
    return hand.X_palm_link(link);
}

// The place of `point_m` among `points_m`, where it is added if it is new.
int place_of(const btVector3 &point_m, std::vector<btVector3> &points_m)
{
    constexpr double same_m = 1e-12;
    for (std::size_t i = 0; i < points_m.size(); i++) {
        if ((points_m[i] - point_m).length() < same_m) return static_cast<int>(i);
    }
    points_m.push_back(point_m);
    return static_cast<int>(points_m.size()) - 1;
}

// Whether `capsule` goes on where `before` ends, in the same direction: the two are one longer capsule.
bool goes_on(const LinkCapsule &before, const LinkCapsule &capsule, const std::vector<btVector3> &points_m)
{
    constexpr double parallel = 1e-9; // sine of the angle between them
    if (before.end != capsule.start || before.radius_m != capsule.radius_m) return false;
    const btVector3 first = points_m[before.end] - points_m[before.start];
    const btVector3 second = points_m[capsule.end] - points_m[capsule.start];
    return first.dot(second) > 0 && first.cross(second).length() < parallel * first.length() * second.length();
}

CarriedCapsules carried_by(const ArticulatedHand &hand, int body_link)
{
    const btTransform X_joint_palm = joint_frame(hand, body_link).inverse();
    CarriedCapsules carried;
    for (int link = 0; link < static_cast<int>(hand.links().size()); link++) {
        if (hand.links()[link].body_link != body_link) continue;
        const auto ends_m = hand.p_palm_capsule_m(link);
        LinkCapsule capsule;
        capsule.start = place_of(X_joint_palm * ends_m[0], carried.points_m);
        capsule.end = place_of(X_joint_palm * ends_m[1], carried.points_m);
        capsule.radius_m = hand.capsule(link).radius_m;
        if (!carried.capsules.empty() && goes_on(carried.capsules.back(), capsule, carried.points_m)) {
            carried.points_m[carried.capsules.back().end] = carried.points_m[capsule.end];
            carried.points_m.pop_back();
        } else {
            carried.capsules.push_back(capsule);
        }
    }
    btVector3 lower = carried.points_m.front(), upper = lower;
    for (const btVector3 &point_m : carried.points_m) {
        lower.setMin(point_m);
        upper.setMax(point_m);
    }
    carried.centre_m = (lower + upper) / 2;
    for (const LinkCapsule &capsule : carried.capsules) {
        for (const int end : {capsule.start, capsule.end}) {
            const double reach_m = (carried.points_m[end] - carried.centre_m).length() + capsule.radius_m;
            carried.radius_m = std::max(carried.radius_m, reach_m);
        }
    }
    return carried;
}

} // namespace

FingerKinematics::FingerKinematics(ArticulatedHand &hand, int first, int second, const btVector3 &p_palm_centre_m)
{
    hand.reset();
    const btTransform X_palm_first = joint_frame(hand, first);
    first_ = frame_of(X_palm_first);
    first_.origin_m -= p_palm_centre_m;
    second_ = frame_of(X_palm_first.inverse() * joint_frame(hand, second));
    carried_ = {carried_by(hand, first), carried_by(hand, second)};

    const btVector3 &p = carried_[1].centre_m;
    centre_part_m_[0] = {carried_[0].centre_m, btVector3(0, 0, 0), btVector3(0, 0, 0)};
    centre_part_m_[1] = {second_.origin_m + p.z() * second_.z, p.x() * second_.x + p.y() * second_.y,
                         p.x() * second_.y - p.y() * second_.x};
    p_first_object_m_ =
        btVector3(-first_.origin_m.dot(first_.x), -first_.origin_m.dot(first_.y), -first_.origin_m.dot(first_.z));
    hinge_direction_ = btVector3(first_.x.z(), first_.y.z(), first_.z.z());
}

std::array<Frame, 2> FingerKinematics::frames(const std::array<SineCosine, 2> &angle) const
{
    const Frame first = first_.turned(angle[0]);
    const Frame second = {first.point(second_.origin_m), first.direction(second_.x), first.direction(second_.y),
                          first.direction(second_.z)};
    return {first, second.turned(angle[1])};
}

PolarPlace FingerKinematics::centre(int joint, const std::array<SineCosine, 2> &angle) const
{
    const auto &part_m = centre_part_m_[joint];
    const btVector3 p_m = part_m[0] + angle[1].cosine * part_m[1] + angle[1].sine * part_m[2];
    const double c = angle[0].cosine, s = angle[0].sine;
    const btVector3 from_object_m =
        btVector3(c * p_m.x() - s * p_m.y(), s * p_m.x() + c * p_m.y(), p_m.z()) - p_first_object_m_;
    const double height_m = hinge_direction_.dot(from_object_m);
    return {from_object_m.length2() - height_m * height_m, height_m};
}

} // namespace twiddle::sim
