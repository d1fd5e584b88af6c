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
    MassFactor mass;
};

// Both fingers, in lanes.
struct BothFingers {
    FingerVectorOf<Pair> angle_rad{};
    MassFactorOf<Pair> mass;

    FingerState finger(int f) const
    {
        return {{angle_rad[0][f], angle_rad[1][f]}, lane(mass, f)};
    }
};

class ConstraintSearch
{
  public:
    ConstraintSearch(const ContactSolver &solver, const HingeFriction &hinge, const std::array<JointStops, 2> &stops,
                     double substep_s);

    // Velocities after the substep from `free`, those without contacts, stops and hinge friction. Solves for
    // the impulses in `contacts`; what they hold is the first guess. `holds` is the first choice and becomes
    // the one that was found.
    Velocities solve(const BothFingers &state, const Velocities &free, Contacts &contacts, Holds &holds);

  private:
    Velocities attempt(const BothFingers &state, const Velocities &free, const Holds &holds, Contacts &contacts);
    Holds judge(const BothFingers &state, const Velocities &free, const Velocities &found, const Contacts &contacts,
                const Holds &holds) const;
    // Whether all joints are between their stops and stay there, which is so nearly always.
    bool stay_between_stops(const BothFingers &state, const Velocities &found) const;

    ContactSolver solver_;
    HingeFriction hinge_;
    std::array<JointStops, 2> stops_;
    double substep_s_;
    FingerVectorOf<Pair> lower_rad_, upper_rad_;      // the stops, in lanes
    ShortList<ContactSolution, most_contacts> guess_; // of the present call
};

} // namespace twiddle::sim
