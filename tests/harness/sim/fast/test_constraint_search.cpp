// Contacts, joint stops and hinge friction of a substep together. Expected: the law of each, and one
// case worked by hand.
#include "contact_problems.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>

namespace twiddle::sim
{
namespace
{

constexpr double coulomb_nm = 0.002;
constexpr double rounding = 1e-10; // of velocities in rad/s and impulses in N m s, relative to 1

HingeFriction hinge()
{
    return HingeFriction(coulomb_nm, object_inertia_kg_m2, substep_s);
}

// The most by which the hinge's friction changes the object's whitened velocity.
double most_friction()
{
    return coulomb_nm * substep_s / std::sqrt(object_inertia_kg_m2);
}

// What a found choice leaves free.
Regime regime_of(const Holds &holds, const std::array<FingerState, 2> &state)
{
    Regime regime;
    regime.object_held = holds.hinge == HingeRegime::held;
    for (int f = 0; f < 2; f++)
        regime.finger[f] = JointStops::freedom(holds.finger[f], state[f].mass);
    return regime;
}

// The law of the hinge: its friction is the change of the object's velocity that contacts do not explain. It is at most
// Coulomb's, and if the object turns, all of that against it.
std::string broken_hinge_law(const ContactProblem &problem, const Velocities &found, double tolerance)
{
    const double friction = found.object - problem.free.object - change_by(problem.contacts, Regime()).object;
    if (std::abs(friction) > most_friction() + tolerance) return "hinge: more than Coulomb's friction";
    if (found.object > tolerance && friction > -most_friction() + tolerance) return "hinge: less friction in motion";
    if (found.object < -tolerance && friction < most_friction() - tolerance) return "hinge: less friction in motion";
    return "";
}

// The law of one joint's two stops: the joint passes neither (from behind one it comes back as far as asked), and the
// impulse that contacts do not explain pushes inwards, and only at a stop that is reached.
std::string broken_stop_law(const FingerVector &lower_rad, const FingerVector &upper_rad, int joint,
                            const FingerState &state, const FingerVector &found_rad_s, const FingerVector &impulse_nms,
                            double tolerance_rad_s)
{
    const double to_lower_rad = lower_rad[joint] - state.angle_rad[joint];
    const double to_upper_rad = upper_rad[joint] - state.angle_rad[joint];
    const double least_rad_s = (to_lower_rad > 0 ? error_reduction : 1) * to_lower_rad / substep_s;
    const double most_rad_s = (to_upper_rad < 0 ? error_reduction : 1) * to_upper_rad / substep_s;
    const double v = found_rad_s[joint], p = impulse_nms[joint];
    if (v < least_rad_s - tolerance_rad_s || v > most_rad_s + tolerance_rad_s) return "stop: passed";
    if (p > rounding && v > least_rad_s + tolerance_rad_s) return "stop: pushes where it is not reached, or pulls";
    if (p < -rounding && v < most_rad_s - tolerance_rad_s) return "stop: pushes where it is not reached, or pulls";
    return "";
}

// The names of all laws that an answer breaks.
std::vector<std::string> broken_laws(const ProblemSource &source, const ContactProblem &problem,
                                     const Velocities &found, const Holds &holds)
{
    std::vector<std::string> broken;
    const auto note = [&](const std::string &law) {
        if (!law.empty()) broken.push_back(law);
    };
    const double tolerance = problem.contacts.size() * settled + rounding;
    const Regime regime = regime_of(holds, problem.state);
    for (const Contact &contact : problem.contacts) {
        const std::string law = broken_law(contact, regime, found, problem.friction, tolerance);
        note(law.empty() ? "" : "contact: " + law);
    }
    note(broken_hinge_law(problem, found, rounding));
    const Velocities pushed = change_by(problem.contacts, Regime());
    for (int f = 0; f < 2; f++) {
        const FingerState &state = problem.state[f];
        FingerVector by_stops;
        for (int j = 0; j < 2; j++)
            by_stops[j] = found.finger[f][j] - problem.free.finger[f][j] - pushed.finger[f][j];
        for (int j = 0; j < 2; j++)
            note(broken_stop_law(source.finger(f).lower_rad, source.finger(f).upper_rad, j, state,
                                 state.mass.velocity(found.finger[f]), state.mass.impulse(by_stops), 1e-9));
    }
    return broken;
}

class fast_stepper_constraint_search : public testing::TestWithParam<Places>
{
};

// Random problems with joints at their stops, each law checked from its own definition with impulses and velocities
// alone. Compared: problems in which no contact may jam in the choice that was found, and whose contacts settle in it.
// The search ends after a few attempts whatever it has found, and its last attempts let no stop go; so a few answers
// may break a law.
TEST_P(fast_stepper_constraint_search, answers_obey_the_laws_of_contacts_stops_and_hinge)
{
    constexpr unsigned seed = 71;
    constexpr int problems = 5000, most = 4;
    ProblemSource source(seed);
    int at_stops = 0, touching = 0, turning = 0, jamming = 0, unsettled = 0, compared = 0, broken = 0;
    std::map<std::string, int> laws;
    for (int i = 0; i < problems; i++) {
        ContactProblem problem = source.problem_at_stops(GetParam(), i % (most + 1));
        Holds holds;
        const Velocities found = ConstraintSearch(ContactSolver(problem.friction), hinge(), source.stops(), substep_s)
                                     .solve(in_lanes(problem.state), problem.free, problem.contacts, holds);
        const Regime regime = regime_of(holds, problem.state);
        if (!each_has_one_answer(problem, regime)) {
            jamming++;
            continue;
        }
        if (!has_settled(problem, regime, found)) {
            unsettled++;
            continue;
        }
        compared++;
        for (const Contact &contact : problem.contacts)
            touching += contact.solution.impulse_ns[0] > 0;
        for (const HeldJoints &held : holds.finger)
            at_stops += (held[0] != Stop::none) + (held[1] != Stop::none);
        turning += holds.hinge != HingeRegime::held;
        const auto names = broken_laws(source, problem, found, holds);
        broken += !names.empty();
        for (const std::string &law : names)
            laws[law]++;
    }
    std::printf("seed %u: of %d problems %d may jam, %d do not settle, %d compared: %d contacts touch, %d joints at "
                "stops, the object turns in %d; laws broken in %d\n",
                seed, problems, jamming, unsettled, compared, touching, at_stops, turning, broken);
    for (const auto &[law, count] : laws)
        std::printf("broken: %s, %d times\n", law.c_str(), count);
    EXPECT_GT(compared, problems / 4) << "too few cases to say anything";
    EXPECT_LE(broken, compared / 200);
}

INSTANTIATE_TEST_SUITE_P(Sim, fast_stepper_constraint_search, testing::Values(Places::face, Places::scattered),
                         [](const auto &places) { return places.param == Places::face ? "face" : "scattered"; });

// Unit masses; the first joint comes at 1 rad/s to 1 mrad before its stop, which lets 0.5 rad/s through in 2 ms. A
// contact against it either lets less through, and holds it alone, or more, and stays open. By hand.
TEST(fast_stepper_constraint_search_by_hand, the_nearer_of_stop_and_contact_holds_the_joint)
{
    const JointStops range({-1, -1}, {0.001, 1}, error_reduction, substep_s);
    const std::array<FingerState, 2> state; // at 0, with unit masses
    Velocities free;
    free.finger[0] = {1, 0.1};
    for (const double let_through_rad_s : {0.2, 0.7}) {
        Contacts contacts;
        Contact contact;
        contact.finger_row = {{{-1, 0}, {0, 1}, {0, 0}}};
        contact.least_normal_m_s = -let_through_rad_s;
        contacts.add(contact);
        Holds holds;
        const Velocities found = ConstraintSearch(ContactSolver(0.5), hinge(), {range, range}, substep_s)
                                     .solve(in_lanes(state), free, contacts, holds);
        EXPECT_EQ(holds.hinge, HingeRegime::held);
        EXPECT_EQ(holds.finger[1], HeldJoints{});
        if (let_through_rad_s < 0.5) {
            EXPECT_EQ(holds.finger[0], HeldJoints{});
            EXPECT_NEAR(found.finger[0][0], 0.2, 1e-9);
            EXPECT_NEAR(found.finger[0][1], 0, 1e-9); // friction of at most 0.4 holds what takes 0.1
            EXPECT_NEAR(contacts[0].solution.impulse_ns[0], 0.8, 1e-9);
            EXPECT_NEAR(contacts[0].solution.impulse_ns[1], -0.1, 1e-9);
        } else {
            EXPECT_EQ(holds.finger[0], (HeldJoints{Stop::upper, Stop::none}));
            EXPECT_NEAR(found.finger[0][0], 0.5, 1e-9);
            EXPECT_NEAR(found.finger[0][1], 0.1, 1e-9);
            EXPECT_EQ(contacts[0].solution.impulse_ns, ContactVector{});
        }
    }
}

} // namespace
} // namespace twiddle::sim
