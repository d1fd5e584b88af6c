#include "constraint_search.hpp"

#include <cmath>
#include <optional>

namespace twiddle::sim
{

namespace
{

// Almost always one or two are enough. From the fifth on no stop lets go any more, so that whatever answer is the last
// one respects all joint ranges.
constexpr int most_attempts = 10;
constexpr int attempts_with_release = 4;

// A whitened velocity of the object that counts as none, sqrt(kg) m/s; about 1e-4 rad/s.
constexpr double standstill = 5e-7;

// Which regimes of the hinge were tried with the same stops. An answer may name one that was: an object pinned between
// fingers, or pushed by one that a stop holds, has contacts that no impulse satisfies in the wrong regime, and their
// impulses say nothing. Then the one that is left comes next, and if none is left the object is held.
class TriedRegimes
{
  public:
    // Where to go on from `wanted`; nothing where all were tried.
    std::optional<HingeRegime> next(HingeRegime wanted) const
    {
        for (const HingeRegime regime :
             {wanted, HingeRegime::held, HingeRegime::turning_forward, HingeRegime::turning_backward}) {
            if (!tried_[static_cast<int>(regime)]) return regime;
        }
        return std::nullopt;
    }
    bool has(HingeRegime regime) const
    {
        return tried_[static_cast<int>(regime)];
    }
    void add(HingeRegime regime)
    {
        tried_[static_cast<int>(regime)] = true;
    }

  private:
    std::array<bool, 3> tried_{};
};

// What the contacts' impulses alone would do to the velocities.
Velocities pushed(const Contacts &contacts)
{
    Velocities sum;
    for (const Contact &contact : contacts) {
        for (int i = 0; i < 3; i++) {
            sum.finger[contact.finger][0] += contact.finger_row[i][0] * contact.solution.impulse_ns[i];
            sum.finger[contact.finger][1] += contact.finger_row[i][1] * contact.solution.impulse_ns[i];
            sum.object += contact.object_row[i] * contact.solution.impulse_ns[i];
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
    std::array<ContactSolution, most_contacts> guess;
    for (int k = 0; k < contacts.size(); k++)
        guess[k] = contacts[k].solution;
    TriedRegimes tried;
    for (int i = 0;; i++) {
        const Velocities found = attempt(state, free, holds, contacts);
        Holds next = judge(state, free, found, contacts, holds);
        if (i >= attempts_with_release) {
            for (int f = 0; f < 2; f++)
                next.finger[f] = united(holds.finger[f], next.finger[f]);
        }
        if (next == holds || i + 1 == most_attempts) return found;
        if (next.finger == holds.finger) {
            // Contacts hold the object, and friction does not resist them: the velocity is 0 but for the
            // solver's tolerance.
            if (tried.has(HingeRegime::held) && std::abs(found.object) < standstill) return found;
            tried.add(holds.hinge);
            const auto untried = tried.next(next.hinge);
            if (!untried && holds.hinge == HingeRegime::held) return found;
            next.hinge = untried.value_or(HingeRegime::held);
        } else {
            tried = TriedRegimes();
        }
        holds = next;
        for (int k = 0; k < contacts.size(); k++)
            contacts[k].solution = guess[k]; // impulses of a refuted choice can be of any size
    }
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
