// constraint_search.hpp: contacts, joint stops and hinge friction of one substep, solved together.
//
// Stops and hinge friction choose what is held (joint_stops.hpp, hinge_friction.hpp); for each choice the contacts are
// solved (contact_solver.hpp); an answer that contradicts the choice names the next one. The last substep's choice
// comes first and mostly stands.
#pragma once

#include "contact_solver.hpp"
#include "hinge_friction.hpp"
#include "joint_stops.hpp"

#include <array>

namespace twiddle::sim
{

// What is held, and by what.
struct Holds {
    HingeRegime hinge = HingeRegime::held;
    std::array<HeldJoints, 2> finger{};

    bool operator==(const Holds &other) const
    {
        return hinge == other.hinge && finger == other.finger;
    }
};

// A finger at the start of a substep.
struct FingerState {
    FingerVector angle_rad{};
    std::array<SineCosine, 2> angle;
    MassFactor mass;
};

class ConstraintSearch
{
  public:
    ConstraintSearch(const ContactSolver &solver, const HingeFriction &hinge, const std::array<JointStops, 2> &stops)
        : solver_(solver), hinge_(hinge), stops_(stops)
    {
    }

    // Velocities after the substep from `free`, those without contacts, stops and hinge friction. Solves for
    // the impulses in `contacts`; what they hold is the first guess. `holds` is the first choice and becomes
    // the one that was found.
    Velocities solve(const std::array<FingerState, 2> &state, const Velocities &free, Contacts &contacts, Holds &holds);

  private:
    Velocities attempt(const std::array<FingerState, 2> &state, const Velocities &free, const Holds &holds,
                       Contacts &contacts);
    Holds judge(const std::array<FingerState, 2> &state, const Velocities &free, const Velocities &found,
                const Contacts &contacts, const Holds &holds) const;

    ContactSolver solver_;
    HingeFriction hinge_;
    std::array<JointStops, 2> stops_;
};

} // namespace twiddle::sim
