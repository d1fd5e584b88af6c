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

CarriedCapsules carried_by(const ArticulatedHand &hand, int body_link)
{
    const btTransform X_joint_palm = joint_frame(hand, body_link).inverse();
    CarriedCapsules carried;
    for (int link = 0; link < static_cast<int>(hand.links().size()); link++) {
        if (hand.links()[link].body_link != body_link) continue;
        const auto ends_m = hand.p_palm_capsule_m(link);
        carried.capsules.push_back({X_joint_palm * ends_m[0], X_joint_palm * ends_m[1], hand.capsule(link).radius_m});
    }
    btVector3 lower = carried.capsules.front().start_m, upper = lower;
    for (const LinkCapsule &capsule : carried.capsules) {
        for (const btVector3 &end : {capsule.start_m, capsule.end_m}) {
            lower.setMin(end);
            upper.setMax(end);
        }
    }
    carried.centre_m = (lower + upper) / 2;
    for (const LinkCapsule &capsule : carried.capsules) {
        for (const btVector3 &end : {capsule.start_m, capsule.end_m})
            carried.radius_m = std::max(carried.radius_m, (end - carried.centre_m).length() + capsule.radius_m);
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
}

std::array<Frame, 2> FingerKinematics::frames(const std::array<SineCosine, 2> &angle) const
{
    const Frame first = first_.turned(angle[0]);
    const Frame second = {first.point(second_.origin_m), first.direction(second_.x), first.direction(second_.y),
                          first.direction(second_.z)};
    return {first, second.turned(angle[1])};
}

} // namespace twiddle::sim
