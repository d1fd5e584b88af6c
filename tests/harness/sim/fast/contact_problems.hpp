// contact_problems.hpp: random problems of fingers on an object, and the laws that their solutions have to obey.
#pragma once

#include "finger_fixtures.hpp"

#include "sim/fast/constraint_search.hpp"
#include "sim/fast/contact_solver.hpp"

#include <array>
#include <random>
#include <string>

namespace twiddle::sim
{

constexpr double substep_s = 0.002; // 5 substeps of a control step
constexpr double error_reduction = 0.1;
constexpr double object_inertia_kg_m2 = 4.5e-5; // of a sphere of 110 g and 32 mm radius

// What the solver stops at: the change of whitened velocities in its last sweep, sqrt(kg) m/s (contact_solver.cpp).
constexpr double settled = 1e-7;

struct ContactProblem {
    std::array<FingerState, 2> state;
    Velocities free; // without contacts, stops and hinge friction
    Contacts contacts;
    double friction = 0;
};

// How the contacts of one finger lie. face: on one capsule, normals within a few degrees, as on a face or an edge of
// the object. scattered: on any capsule with any normal, so that the finger may be wedged in between; no convex
// object does that.
enum class Places { face, scattered };

// The fingers of the iCub's hand in random postures with random torques on them, and contacts at random places
// of their capsules.
class ProblemSource
{
  public:
    explicit ProblemSource(unsigned seed);

    // Angles in the joints' ranges.
    ContactProblem problem(Places places, int contacts);
    // The same with joints that are near their stops or a little past them.
    ContactProblem problem_at_stops(Places places, int contacts);

    std::array<JointStops, 2> stops() const;
    const BulletFinger &finger(int f) const
    {
        return finger_[f];
    }
    std::mt19937_64 &random()
    {
        return random_;
    }

  private:
    double uniform(double lower, double upper)
    {
        return std::uniform_real_distribution<double>(lower, upper)(random_);
    }
    btVector3 random_direction();
    FingerVector angles_at_stops_rad(int f);
    ContactProblem problem(Places places, int contacts, const std::array<FingerVector, 2> &angle_rad);
    void add_contact(ContactProblem &problem, int finger, int joint, std::size_t capsule, double share,
                     const btVector3 &normal);

    std::mt19937_64 random_;
    std::array<BulletFinger, 2> finger_;
    std::array<FingerDynamics, 2> dynamics_;
    std::array<FingerKinematics, 2> kinematics_;
};

// As the search takes them.
BothFingers in_lanes(const std::array<FingerState, 2> &state);

// The contact's velocity relative to the least that it asks for, normal first.
ContactVector contact_velocity(const Contact &contact, const Velocities &velocities);

// What impulses of `contacts` do to velocities if they act on all that `regime` leaves free.
Velocities change_by(const Contacts &contacts, const Regime &regime);

// W of the contact in the regime: its rows act on what moves.
ContactMatrix inverse_mass(const Contact &contact, const Regime &regime);

// Whether the contact can move in its regime at all.
bool can_move(const Contact &contact, const Regime &regime);

// Whether the friction is small enough for the contact alone never to jam: its normal velocity grows with its normal
// impulse in every direction of slip, and its laws have one answer.
bool has_one_answer(const Contact &contact, const Regime &regime, double friction);

// The same of all contacts that can move.
bool each_has_one_answer(const ContactProblem &problem, const Regime &regime);

// Which of Signorini's and Coulomb's laws the contact breaks by more than whitened velocities that are wrong by up to
// `tolerance` each explain; empty if none. A contact that cannot move has to have no impulse.
std::string broken_law(const Contact &contact, const Regime &regime, const Velocities &velocities, double friction,
                       double tolerance);

// The largest entry of a difference, of velocities; and a sum.
double largest_difference(const Velocities &a, const Velocities &b);
double largest_entry(const Velocities &velocities);
void add(Velocities &velocities, const Velocities &change);

// Whether `found` and the contacts' impulses are where the solver's sweeps come to rest: one more sweep, made here,
// changes no velocity by more than the solver's own limit. A problem that has not settled when the solver's sweeps are
// used up has no answer to be compared.
bool has_settled(const ContactProblem &problem, const Regime &regime, const Velocities &found);

} // namespace twiddle::sim
