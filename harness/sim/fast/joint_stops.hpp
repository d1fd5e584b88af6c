// joint_stops.hpp: the ranges of a finger's joints as unilateral constraints.
//
// A stop acts a substep ahead, as contacts do: a joint may approach its stop no faster than reaches it exactly. Each
// joint is either free or held at such a velocity by one of its stops; the choice that contradicts nothing is the
// solution: a free joint must not pass a stop, and a stop must not pull.
#pragma once

#include "contact_solver.hpp"
#include "finger_dynamics.hpp"

#include <array>

namespace twiddle::sim
{

// For each joint of a finger: which of its stops holds it.
enum class Stop : unsigned char { none, lower, upper };
using HeldJoints = std::array<Stop, 2>;

class JointStops
{
  public:
    // The joints' ranges. A joint that is past its stop is brought back by the share `error_reduction` in a substep.
    JointStops(const FingerVector &lower_rad, const FingerVector &upper_rad, double error_reduction, double substep_s);

    const FingerVector &lower_rad() const
    {
        return lower_rad_;
    }
    const FingerVector &upper_rad() const
    {
        return upper_rad_;
    }

    // The stops that joints at `angle_rad` would pass with these velocities.
    HeldJoints passed(const FingerVector &angle_rad, const FingerVector &velocity_rad_s) const;

    // How the finger can move while `held`: its freedom, and its velocities (whitened) from those without stops.
    static Freedom freedom(const HeldJoints &held, const MassFactor &mass);
    FingerVector start(const HeldJoints &held, const FingerVector &angle_rad, const MassFactor &mass,
                       const Freedom &freedom, const FingerVector &y) const;

    // Of `held` those that push; `impulse_nms` is what holds the joints.
    static HeldJoints pushing(const HeldJoints &held, const FingerVector &impulse_nms);

  private:
    // How far a joint may move in the coming substep: to its stop, or back to it.
    double least_rad(int joint, double angle_rad) const;
    double most_rad(int joint, double angle_rad) const;

    FingerVector lower_rad_;
    FingerVector upper_rad_;
    double error_reduction_;
    double substep_s_;
};

} // namespace twiddle::sim
