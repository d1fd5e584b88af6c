// Impulses of several contacts at once. Expected: the laws of Signorini and Coulomb, and an independent method's velocities.
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

bool each_has_one_answer(const ContactProblem &problem, const Regime &regime)
{
    for (const Contact &contact : problem.contacts)
        if (can_move(contact, regime) && !has_one_answer(contact, regime, problem.friction)) return false;
    return true;
}

double largest_difference(const Velocities &a, const Velocities &b)
{
    double largest = std::abs(a.object - b.object);
    for (int f = 0; f < 2; f++)
        for (int j = 0; j < 2; j++)
            largest = std::max(largest, std::abs(a.finger[f][j] - b.finger[f][j]));
    return largest;
}

double largest_entry(const Velocities &velocities)
{
    return largest_difference(velocities, {});
}

void add(Velocities &velocities, const Velocities &change)
{
    for (int f = 0; f < 2; f++)
        for (int j = 0; j < 2; j++)
            velocities.finger[f][j] += change.finger[f][j];
    velocities.object += change.object;
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
    // Returns the largest velocity by which an impulse still misses its projection. (That velocities rest is not enough:
    // impulses may move along a direction that pushes nothing.)
    double swept()
    {
        double largest = 0;
        for (int i = 0; i < contacts_.size(); i++) {
            Contact &contact = contacts_[i];
            if (rho_[i] == 0) continue;
            const ContactVector u = contact_velocity(contact, velocities_);
            const ContactVector before = contact.impulse_ns;
            const ContactVector after =
                projected({before[0] - rho_[i] * (u[0] + friction_ * std::hypot(u[1], u[2])),
                           before[1] - rho_[i] * u[1], before[2] - rho_[i] * u[2]},
                          friction_);
            Contacts step;
            step.add(contact);
            step.last().impulse_ns = {after[0] - before[0], after[1] - before[1], after[2] - before[2]};
            const Velocities change = change_by(step, regime_);
            add(velocities_, change);
            contact.impulse_ns = after;
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
        contact.impulse_ns = projected({0.003 * std::abs(normal(random)), 0.001 * x, 0.001 * y}, friction);
    }
    return started;
}

// Signorini's and Coulomb's laws hold at every contact, within what velocities explain that the last sweep still changed: each
// contact was solved for the others' impulses at its turn, and each other changed a velocity by `settled` at most afterwards.
// Compared: all problems whose contacts alone have one answer. A problem that does not settle in the solver's 100 sweeps
// breaks a law visibly; those are counted, and are a small share.
TEST(fast_stepper_contact_solver, impulses_obey_signorini_and_coulomb)
{
    constexpr unsigned seed = 31;
    constexpr int problems = 20000;
    ProblemSource source(seed);
    int compared = 0, touching = 0, unsettled = 0;
    std::map<std::string, int> broken;
    for (int i = 0; i < problems; i++) {
        ContactProblem problem = source.problem(1 + i % most);
        const Regime regime = random_regime(problem, source.random());
        if (!each_has_one_answer(problem, regime)) continue;
        compared++;
        Velocities velocities = problem.free;
        ContactSolver(problem.friction).solve(regime, problem.contacts, velocities);

        // The velocities are those that the impulses make; by definition, to rounding.
        Velocities expected = problem.free;
        add(expected, change_by(problem.contacts, regime));
        ASSERT_LE(largest_difference(velocities, expected), 1e-12) << "seed " << seed << ", case " << i;

        std::string law;
        for (const Contact &contact : problem.contacts) {
            touching += contact.impulse_ns[0] > 0;
            const std::string found =
                broken_law(contact, regime, velocities, problem.friction, (problem.contacts.size() - 1) * settled + 1e-12);
            if (!found.empty()) law = found;
        }
        unsettled += !law.empty();
        if (!law.empty()) broken[law]++;
    }
    std::printf("seed %u: %d of %d problems compared, %d contacts touch; %d problems break a law:", seed, compared,
                problems, touching, unsettled);
    for (const auto &[law, count] : broken)
        std::printf(" %s %d;", law.c_str(), count);
    std::printf("\n");
    EXPECT_GT(compared, problems / 3) << "too few cases to say anything";
    EXPECT_GT(touching, problems / 3) << "too few cases to say anything";
    EXPECT_EQ(unsettled, 0);
}

// Expected: the velocities of the bipotential's iteration, to 1e-5 of the largest. Compared: problems whose contacts alone have
// one answer and in which the iteration settles at the same velocities from no impulses and from random ones, which
// tells that the problem has one answer in velocities.
TEST(fast_stepper_contact_solver, velocities_equal_those_of_an_independent_iteration)
{
    constexpr unsigned seed = 32;
    constexpr int problems = 2000, most_sweeps = 20000;
    constexpr double settled_at = 1e-10; // m/s
    ProblemSource source(seed);
    int jamming = 0, unsettled = 0, several = 0, compared = 0, off = 0;
    double largest = 0;
    for (int i = 0; i < problems; i++) {
        ContactProblem problem = source.problem(1 + i % most);
        const Regime regime = random_regime(problem, source.random());
        if (!each_has_one_answer(problem, regime)) {
            jamming++;
            continue;
        }
        Bipotential first(problem, regime, problem.contacts);
        Bipotential second(problem, regime,
                           with_random_impulses(problem.contacts, problem.friction, source.random()));
        if (!first.run(most_sweeps, settled_at) || !second.run(most_sweeps, settled_at)) {
            unsettled++;
            continue;
        }
        const double scale = largest_entry(problem.free);
        if (largest_difference(first.velocities(), second.velocities()) > 1e-7 * scale) {
            several++;
            continue;
        }
        compared++;
        Velocities velocities = problem.free;
        ContactSolver(problem.friction).solve(regime, problem.contacts, velocities);
        const double difference = largest_difference(velocities, first.velocities()) / scale;
        largest = std::max(largest, difference);
        if (difference > 1e-5) {
            off++;
            std::printf("case %d: %.1e with %d contacts\n", i, difference, problem.contacts.size());
        }
    }
    std::printf("seed %u: of %d problems %d may jam, in %d the iteration does not settle, in %d it finds several "
                "answers, %d compared: largest difference %.1e, %d above 1e-5\n",
                seed, problems, jamming, unsettled, several, compared, largest, off);
    EXPECT_GT(compared, problems / 3) << "too few cases to say anything";
    EXPECT_EQ(off, 0);
}

} // namespace
} // namespace twiddle::sim
