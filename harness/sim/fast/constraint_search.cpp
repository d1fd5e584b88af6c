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

// What the contacts' impulses alone would do to the object's velocity.
double push_on_object(const Contacts &contacts)
{
    double sum = 0;
    for (const Contact &contact : contacts) {
        for (int i = 0; i < 3; i++)
            sum += contact.object_row[i] * contact.solution.impulse_ns[i];
    }
    return sum;
}

// And to a finger's.
FingerVector push_on_finger(const Contacts &contacts, int finger)
{
    FingerVector sum{};
    for (const Contact &contact : contacts) {
        if (contact.finger != finger) continue;
        for (int i = 0; i < 3; i++) {
            sum[0] += contact.finger_row[i][0] * contact.solution.impulse_ns[i];
            sum[1] += contact.finger_row[i][1] * contact.solution.impulse_ns[i];
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

ConstraintSearch::ConstraintSearch(const ContactSolver &solver, const HingeFriction &hinge,
                                   const std::array<JointStops, 2> &stops, double substep_s)
    : solver_(solver), hinge_(hinge), stops_(stops), substep_s_(substep_s),
      lower_rad_(in_lanes({stops[0].lower_rad(), stops[1].lower_rad()})),
      upper_rad_(in_lanes({stops[0].upper_rad(), stops[1].upper_rad()}))
{
}

Velocities ConstraintSearch::solve(const BothFingers &state, const Velocities &free, Contacts &contacts, Holds &holds)
{
    guess_.clear();
    for (const Contact &contact : contacts)
        guess_.add(contact.solution);
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
            contacts[k].solution = guess_[k]; // impulses of a refuted choice can be of any size
    }
}

Velocities ConstraintSearch::attempt(const BothFingers &state, const Velocities &free, const Holds &holds,
                                     Contacts &contacts)
{
    Regime regime;
    Velocities velocities = free;
    regime.object_held = holds.hinge == HingeRegime::held;
    velocities.object = hinge_.start(holds.hinge, free.object);
    for (int f = 0; f < 2; f++) {
        if (!any_held(holds.finger[f])) continue;
        const FingerState finger = state.finger(f);
        regime.finger[f] = JointStops::freedom(holds.finger[f], finger.mass);
        velocities.finger[f] =
            stops_[f].start(holds.finger[f], finger.angle_rad, finger.mass, regime.finger[f], free.finger[f]);
    }
    solver_.solve(regime, contacts, velocities);
    return velocities;
}

Holds ConstraintSearch::judge(const BothFingers &state, const Velocities &free, const Velocities &found,
                              const Contacts &contacts, const Holds &holds) const
{
    Holds next;
    // Only a hinge that is held asks what pushes it.
    const double push = holds.hinge == HingeRegime::held ? push_on_object(contacts) : 0;
    next.hinge = hinge_.judge(holds.hinge, free.object + push, found.object);
    if (!any_held(holds.finger[0]) && !any_held(holds.finger[1]) && stay_between_stops(state, found)) return next;
    for (int f = 0; f < 2; f++) {
        const FingerState finger = state.finger(f);
        // A joint that was held moves exactly as its stop lets it, and cannot be said to pass it.
        HeldJoints passed = stops_[f].passed(finger.angle_rad, finger.mass.velocity(found.finger[f]));
        HeldJoints held = holds.finger[f];
        for (int j = 0; j < 2; j++) {
            if (held[j] != Stop::none) passed[j] = Stop::none;
        }
        if (any_held(held)) {
            const FingerVector pushed = push_on_finger(contacts, f);
            FingerVector by_stops;
            for (int j = 0; j < 2; j++)
                by_stops[j] = found.finger[f][j] - free.finger[f][j] - pushed[j];
            held = JointStops::pushing(held, finger.mass.impulse(by_stops));
        }
        next.finger[f] = united(held, passed);
    }
    return next;
}

bool ConstraintSearch::stay_between_stops(const BothFingers &state, const Velocities &found) const
{
    const FingerVectorOf<Pair> velocity_rad_s = state.mass.velocity(in_lanes(found.finger));
    PairBits between = ~PairBits{};
    for (int j = 0; j < 2; j++) {
        const Pair angle_rad = state.angle_rad[j], after_rad = angle_rad + substep_s_ * velocity_rad_s[j];
        between &= reinterpret_cast<PairBits>((angle_rad > lower_rad_[j]) & (after_rad > lower_rad_[j]) &
                                              (angle_rad < upper_rad_[j]) & (after_rad < upper_rad_[j]));
    }
    return (between[0] & between[1]) != 0;
}

} // namespace twiddle::sim
