#include "constraint_search.hpp"

namespace twiddle::sim
{

namespace
{

// Two choices can contradict each other only by the contact solver's tolerance. From the third attempt on no stop lets go
// any more, so that whatever answer is the last one respects all joint ranges.
constexpr int most_attempts = 8;
constexpr int attempts_with_release = 3;

// What the contacts' impulses alone would do to the velocities.
Velocities pushed(const Contacts &contacts)
{
    Velocities sum;
    for (const Contact &contact : contacts) {
        for (int i = 0; i < 3; i++) {
            sum.finger[contact.finger][0] += contact.finger_row[i][0] * contact.impulse_ns[i];
            sum.finger[contact.finger][1] += contact.finger_row[i][1] * contact.impulse_ns[i];
            sum.object += contact.object_row[i] * contact.impulse_ns[i];
        }
    }
    return sum;
}

bool any_held(const HeldJoints &held)
{
    return held[0] != Stop::none || held[1] != Stop::none;
}

// Stops that hold already, and those that would be passed.
HeldJoints united(const HeldJoints &held, const HeldJoints &passed)
{
    return {held[0] != Stop::none ? held[0] : passed[0], held[1] != Stop::none ? held[1] : passed[1]};
}

} // namespace

Velocities ConstraintSearch::solve(const std::array<FingerState, 2> &state, const Velocities &free, Contacts &contacts,
                                   Holds &holds)
{
    Velocities found;
    for (int i = 0; i < most_attempts; i++) {
        found = attempt(state, free, holds, contacts);
        Holds next = judge(state, free, found, contacts, holds);
        if (i >= attempts_with_release) {
            for (int f = 0; f < 2; f++)
                next.finger[f] = united(holds.finger[f], next.finger[f]);
        }
        if (next == holds) break;
        holds = next;
    }
    return found;
}

Velocities ConstraintSearch::attempt(const std::array<FingerState, 2> &state, const Velocities &free,
                                     const Holds &holds, Contacts &contacts)
{
    Regime regime;
    Velocities velocities = free;
    regime.object_held = holds.hinge == HingeRegime::held;
    velocities.object = hinge_.start(holds.hinge, free.object);
    for (int f = 0; f < 2; f++) {
        if (!any_held(holds.finger[f])) continue;
        regime.finger[f] = JointStops::freedom(holds.finger[f], state[f].mass);
        velocities.finger[f] =
            stops_[f].start(holds.finger[f], state[f].angle_rad, state[f].mass, regime.finger[f], free.finger[f]);
    }
    solver_.solve(regime, contacts, velocities);
    return velocities;
}

Holds ConstraintSearch::judge(const std::array<FingerState, 2> &state, const Velocities &free, const Velocities &found,
                              const Contacts &contacts, const Holds &holds) const
{
    const Velocities push = pushed(contacts);
    Holds next;
    next.hinge = hinge_.judge(holds.hinge, free.object + push.object, found.object);
    for (int f = 0; f < 2; f++) {
        // A joint that was held moves exactly as its stop lets it, and cannot be said to pass it.
        HeldJoints passed = stops_[f].passed(state[f].angle_rad, state[f].mass.velocity(found.finger[f]));
        HeldJoints held = holds.finger[f];
        for (int j = 0; j < 2; j++) {
            if (held[j] != Stop::none) passed[j] = Stop::none;
        }
        if (any_held(held)) {
            FingerVector by_stops;
            for (int j = 0; j < 2; j++)
                by_stops[j] = found.finger[f][j] - free.finger[f][j] - push.finger[f][j];
            held = JointStops::pushing(held, state[f].mass.impulse(by_stops));
        }
        next.finger[f] = united(held, passed);
    }
    return next;
}

} // namespace twiddle::sim
