#include "finger_kinematics.hpp"

#include <algorithm>
#include <cmath>

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

    const auto from_axis_m = [](const btVector3 &p_m) { return std::hypot(p_m.x(), p_m.y()); };
    for (const btVector3 &p_m : carried_[0].points_m)
        reach_m_[0] = std::max(reach_m_[0], from_axis_m(p_m));
    for (const btVector3 &p_m : carried_[1].points_m) {
        reach_m_[0] = std::max(reach_m_[0], from_axis_m(second_.origin_m) + p_m.length());
        reach_m_[1] = std::max(reach_m_[1], from_axis_m(p_m));
    }
}

std::array<Frame, 2> FingerKinematics::frames(const std::array<SineCosine, 2> &angle) const
{
    const Frame first = first_.turned(angle[0]);
    const Frame second = {first.point(second_.origin_m), first.direction(second_.x), first.direction(second_.y),
                          first.direction(second_.z)};
    return {first, second.turned(angle[1])};
}

PairKinematics::PairKinematics(const std::array<FingerKinematics, 2> &fingers)
    : origin_m_(turning(fingers, &Frame::origin_m)), x_(turning(fingers, &Frame::x)), y_(turning(fingers, &Frame::y)),
      z_(turning(fingers, &Frame::z))
{
    origin_m_.constant =
        origin_m_.constant + pair_of(vector_of(fingers[0].first().origin_m), vector_of(fingers[1].first().origin_m));
}

PairKinematics::Turning PairKinematics::turning(const std::array<FingerKinematics, 2> &fingers, VectorOfFrame vector)
{
    std::array<std::array<Vector, 2>, 3> part;
    for (int f = 0; f < 2; f++) {
        const Frame &first = fingers[f].first();
        const btVector3 &v = fingers[f].second().*vector;
        part[0][f] = vector_of(v.z() * first.z);
        part[1][f] = vector_of(v.x() * first.x + v.y() * first.y);
        part[2][f] = vector_of(v.x() * first.y - v.y() * first.x);
    }
    return {pair_of(part[0][0], part[0][1]), pair_of(part[1][0], part[1][1]), pair_of(part[2][0], part[2][1])};
}

PairFrame PairKinematics::second_frames(const std::array<SineCosineOf<Pair>, 2> &angle) const
{
    const PairVector x = x_.at(angle[0]), y = y_.at(angle[0]);
    const Pair c = angle[1].cosine, s = angle[1].sine;
    return {origin_m_.at(angle[0]), x * c + y * s, y * c - x * s, z_.at(angle[0])};
}

} // namespace twiddle::sim
