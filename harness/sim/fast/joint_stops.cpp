#include "joint_stops.hpp"

namespace twiddle::sim
{

JointStops::JointStops(const FingerVector &lower_rad, const FingerVector &upper_rad, double error_reduction,
                       double substep_s)
    : lower_rad_(lower_rad), upper_rad_(upper_rad), error_reduction_(error_reduction), substep_s_(substep_s)
{
}

double JointStops::least_rad(int joint, double angle_rad) const
{
    const double distance_rad = lower_rad_[joint] - angle_rad;
    return distance_rad < 0 ? distance_rad : error_reduction_ * distance_rad;
}

double JointStops::most_rad(int joint, double angle_rad) const
{
    const double distance_rad = upper_rad_[joint] - angle_rad;
    return distance_rad > 0 ? distance_rad : error_reduction_ * distance_rad;
}

HeldJoints JointStops::passed(const FingerVector &angle_rad, const FingerVector &velocity_rad_s) const
{
    HeldJoints held{};
    for (int j = 0; j < 2; j++) {
        const double move_rad = substep_s_ * velocity_rad_s[j];
        if (move_rad < least_rad(j, angle_rad[j])) held[j] = Stop::lower;
        if (move_rad > most_rad(j, angle_rad[j])) held[j] = Stop::upper;
    }
    return held;
}

Freedom JointStops::freedom(const HeldJoints &held, const MassFactor &mass)
{
    if (held[0] == Stop::none && held[1] == Stop::none) return {};
    if (held[0] != Stop::none && held[1] != Stop::none) return {0, 0, 0};
    // The projector across the held joint's row, L^-1 e.
    const FingerVector row = held[0] != Stop::none ? mass.whitened({1, 0}) : mass.whitened({0, 1});
    const double square = row[0] * row[0] + row[1] * row[1];
    return {row[1] * row[1] / square, -row[0] * row[1] / square, row[0] * row[0] / square};
}

FingerVector JointStops::start(const HeldJoints &held, const FingerVector &angle_rad, const MassFactor &mass,
                               const Freedom &freedom, const FingerVector &y) const
{
    FingerVector wanted_rad_s{};
    for (int j = 0; j < 2; j++) {
        if (held[j] == Stop::lower) wanted_rad_s[j] = least_rad(j, angle_rad[j]) / substep_s_;
        if (held[j] == Stop::upper) wanted_rad_s[j] = most_rad(j, angle_rad[j]) / substep_s_;
    }
    // Any motion with the wanted velocities of the held joints, less its share along the free directions.
    const FingerVector fixed = mass.from_velocity(wanted_rad_s);
    const FingerVector moving = freedom.of({y[0] - fixed[0], y[1] - fixed[1]});
    return {fixed[0] + moving[0], fixed[1] + moving[1]};
}

HeldJoints JointStops::pushing(const HeldJoints &held, const FingerVector &impulse_nms)
{
    HeldJoints pushing = held;
    for (int j = 0; j < 2; j++) {
        if (held[j] == Stop::lower && impulse_nms[j] < 0) pushing[j] = Stop::none;
        if (held[j] == Stop::upper && impulse_nms[j] > 0) pushing[j] = Stop::none;
    }
    return pushing;
}

} // namespace twiddle::sim
