// Impulses of several contacts at once. Expected: the laws of Signorini and Coulomb, and an independent
// method's velocities.
#include "contact_problems.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>

namespace twiddle::sim
{
namespace
{

constexpr int most = 6; // contacts of a problem

// What moves and what is held: mostly all moves, but object and joints are held in their turn.
Regime random_regime(const ContactProblem &problem, std::mt19937_64 &random)
{
    std::uniform_real_distribution<double> uniform(0, 1);
    Regime regime;
    regime.object_held = uniform(random) < 0.3;
    for (int f = 0; f < 2; f++) {
        HeldJoints held{};
        for (Stop &stop : held)
            if (uniform(random) < 0.15) stop = Stop::lower;
        regime.finger[f] = JointStops::freedom(held, problem.state[f].mass);
    }
    return regime;
}

// The nearest impulse in Coulomb's cone.
ContactVector projected(const ContactVector &p, double friction)
{
    const double tangential = std::hypot(p[1], p[2]);
    if (tangential <= friction * p[0]) return p;
    const double normal = (p[0] + friction * tangential) / (1 + friction * friction);
    if (normal <= 0) return {};
    const double share = friction * normal / tangential;
    return {normal, share * p[1], share * p[2]};
}

// Iterates De Saxce's bipotential form of the laws, p = projection of p - rho (u + mu |u_t| n) on the cone, contact by
// contact. Nothing of it is the solver's: neither the law's form nor its solution nor when it ends.
class Bipotential
{
  public:
    Bipotential(const ContactProblem &problem, const Regime &regime, const Contacts &start)
        : contacts_(start), regime_(regime), friction_(problem.friction), velocities_(problem.free)
    {
        add(velocities_, change_by(contacts_, regime_));
        for (const Contact &contact : contacts_) {
            const ContactMatrix w = inverse_mass(contact, regime);
            rho_.push_back(can_move(contact, regime) ? 1 / (w[0][0] + w[1][1] + w[2][2]) : 0);
        }
    }

    // Returns whether it settled.
    bool run(int most_sweeps, double settled_at)
    {
        for (int sweep = 0; sweep < most_sweeps; sweep++)
            if (swept() < settled_at) return true;
        return false;
    }

    const Velocities &velocities() const
    {
        return velocities_;
    }

  private:
    // Returns the largest velocity by which an impulse still misses its projection. (That velocities rest is not
    // enough: impulses may move along a direction that pushes nothing.)
    double swept()
    {
        double largest = 0;
        for (int i = 0; i < contacts_.size(); i++) {
            Contact &contact = contacts_[i];
            if (rho_[i] == 0) continue;
            const ContactVector u = contact_velocity(contact, velocities_);
            const ContactVector before = contact.solution.impulse_ns;
            const ContactVector after = projected({before[0] - rho_[i] * (u[0] + friction_ * std::hypot(u[1], u[2])),
                                                   before[1] - rho_[i] * u[1], before[2] - rho_[i] * u[2]},
                                                  friction_);
            Contacts step;
            step.add(contact);
            step.last().solution.impulse_ns = {after[0] - before[0], after[1] - before[1], after[2] - before[2]};
            const Velocities change = change_by(step, regime_);
            add(velocities_, change);
            contact.solution.impulse_ns = after;
            for (int k = 0; k < 3; k++)
                largest = std::max(largest, std::abs(after[k] - before[k]) / rho_[i]);
        }
        return largest;
    }

    Contacts contacts_;
    Regime regime_;
    double friction_;
    Velocities velocities_;
    std::vector<double> rho_;
};

Contacts with_random_impulses(const Contacts &contacts, double friction, std::mt19937_64 &random)
{
    std::normal_distribution<double> normal;
    Contacts started = contacts;
    for (Contact &contact : started) {
        const double x = normal(random), y = normal(random);
        contact.solution.impulse_ns = projected({0.003 * std::abs(normal(random)), 0.001 * x, 0.001 * y}, friction);
    }
    return started;
}

class fast_stepper_contact_solver : public testing::TestWithParam<Places>
{
};

// Signorini's and Coulomb's laws hold at every contact, within what velocities explain that may still change in a
// sweep. Compared: all problems that settle and whose contacts alone have one answer each.
TEST_P(fast_stepper_contact_solver, impulses_obey_signorini_and_coulomb)
{
    constexpr unsigned seed = 31;
    constexpr int problems = 20000;
    ProblemSource source(seed);
    int jamming = 0, touching = 0, unsettled = 0, compared = 0;
    std::map<std::string, int> broken;
    for (int i = 0; i < problems; i++) {
        ContactProblem problem = source.problem(GetParam(), 1 + i % most);
        const Regime regime = random_regime(problem, source.random());
        if (!each_has_one_answer(problem, regime)) {
            jamming++;
            continue;
        }
        Velocities velocities = problem.free;
        ContactSolver(problem.friction).solve(regime, problem.contacts, velocities);
        // The velocities are those that the impulses make, settled or not; to rounding, which large impulses of a
        // wedge make more of.
        Velocities expected = problem.free;
        add(expected, change_by(problem.contacts, regime));
        double most_ns = 0;
        for (const Contact &contact : problem.contacts)
            most_ns = std::max(most_ns, std::abs(contact.solution.impulse_ns[0]));
        ASSERT_LE(largest_difference(velocities, expected), 1e-12 * (1 + most_ns)) << "seed " << seed << ", case " << i;
        if (!has_settled(problem, regime, velocities)) {
            unsettled++;
            continue;
        }
        compared++;
        for (const Contact &contact : problem.contacts) {
            touching += contact.solution.impulse_ns[0] > 0;
            const std::string law =
                broken_law(contact, regime, velocities, problem.friction, problem.contacts.size() * settled);
            if (!law.empty()) broken[law]++;
        }
    }
    std::printf("seed %u: of %d problems %d may jam, %d do not settle, %d compared with %d contacts that touch\n", seed,
                problems, jamming, unsettled, compared, touching);
    for (const auto &[law, count] : broken)
        std::printf("broken: %s, %d contacts\n", law.c_str(), count);
    EXPECT_GT(compared, problems / 4) << "too few cases to say anything";
    EXPECT_GT(touching, problems / 10) << "too few cases to say anything";
    EXPECT_TRUE(broken.empty());
}

// Expected: the velocities of the bipotential's iteration, to 1e-5 of the largest and ten times what the solver lets
// change in its last sweep (a change that shrinks by a tenth a sweep adds up to that). The iteration starts from no
// impulses, from random ones and from the solver's. Compared: problems that settle, whose contacts alone have one
// answer each, and in which the iteration comes to rest. From the solver's impulses it must stay where it is in all of
// them; from the other starts it must come there but for the few problems that have several answers.
TEST_P(fast_stepper_contact_solver, velocities_equal_those_of_an_independent_iteration)
{
    constexpr unsigned seed = 32;
    constexpr int problems = 3000, most_sweeps = 20000;
    constexpr double rest_m_s = 1e-10;
    ProblemSource source(seed);
    int jamming = 0, unsettled = 0, restless = 0, several = 0, compared = 0;
    double largest = 0;
    for (int i = 0; i < problems; i++) {
        ContactProblem problem = source.problem(GetParam(), 1 + i % most);
        const Regime regime = random_regime(problem, source.random());
        if (!each_has_one_answer(problem, regime)) {
            jamming++;
            continue;
        }
        Bipotential first(problem, regime, problem.contacts);
        Bipotential second(problem, regime, with_random_impulses(problem.contacts, problem.friction, source.random()));
        Velocities velocities = problem.free;
        ContactSolver(problem.friction).solve(regime, problem.contacts, velocities);
        if (!has_settled(problem, regime, velocities)) {
            unsettled++;
            continue;
        }
        Bipotential stays(problem, regime, problem.contacts);
        if (!first.run(most_sweeps, rest_m_s) || !second.run(most_sweeps, rest_m_s) ||
            !stays.run(most_sweeps, rest_m_s)) {
            restless++;
            continue;
        }
        compared++;
        const double scale = largest_entry(problem.free), same = 1e-5 * scale + 10 * settled;
        const double difference = largest_difference(velocities, stays.velocities());
        largest = std::max(largest, difference / scale);
        EXPECT_LE(difference, same) << "seed " << seed << ", case " << i;
        several += largest_difference(velocities, first.velocities()) > same ||
                   largest_difference(velocities, second.velocities()) > same;
    }
    std::printf("seed %u: of %d problems %d may jam, the solver does not settle in %d and the iteration not in %d; %d "
                "compared: largest difference %.1e of the largest velocity; %d with several answers\n",
                seed, problems, jamming, unsettled, restless, compared, largest, several);
    EXPECT_GT(compared, problems / 4) << "too few cases to say anything";
    EXPECT_LE(several, compared / 100) << "more problems with several answers than the friction explains";
}

INSTANTIATE_TEST_SUITE_P(Sim, fast_stepper_contact_solver, testing::Values(Places::face, Places::scattered),
                         [](const auto &places) { return places.param == Places::face ? "face" : "scattered"; });

} // namespace
} // namespace twiddle::sim
