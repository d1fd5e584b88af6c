// contact_solver.hpp: the impulses of all contacts in one substep, for a hinge and joints that either move or are held.
//
// Velocities are whitened: y = L^T v with M = L L^T, so that an impulse p on rows R changes them by R^T p and the
// contact's inverse mass is R R^T. Signorini's and Coulomb's laws are solved contact by contact, each exactly
// (coulomb_contact.hpp), in sweeps until the velocities settle: block Gauss-Seidel (nonsmooth contact dynamics; Jean
// 1999). A contact that is alone needs no sweep.
#pragma once

#include "finger_dynamics.hpp"
#include "lanes.hpp"
#include "short_list.hpp"
#include "sim/coulomb_contact.hpp"

#include <array>

namespace twiddle::sim
{

// Two fingers of two joints each, then the object's hinge.
struct Velocities {
    std::array<FingerVector, 2> finger{}; // whitened
    double object = 0;                    // whitened: square root of the inertia times the angular velocity
};

// How a contact is, or may be, solved.
struct ContactSolution {
    ContactVector impulse_ns{};
    double multiplier = 0; // of its law (coulomb_contact.hpp)
};

// One point of a finger on the object. Rows: normal (out of the object), two tangents.
struct Contact {
    int finger = 0;
    std::array<FingerVector, 3> finger_row{}; // of the finger's whitened velocities
    ContactVector object_row{};               // of the object's whitened velocity
    double least_normal_m_s = 0;              // relative normal velocity that it must not fall below
    ContactSolution solution;                 // in: a first guess
    int feature = 0;                          // names the place within the finger: capsule and point on it
    double distance_m = 0;                    // between the surfaces; negative for a penetration
    Vector p_axis_m{}; // of the capsule's centre line, in the palm's axes from the object's centre
};

constexpr int most_contacts = 16;
using Contacts = ShortList<Contact, most_contacts>;

// In which directions impulses move a finger: a symmetric projector of its whitened velocities. The default is all.
struct Freedom {
    double p00 = 1, p01 = 0, p11 = 1;

    bool of_all() const
    {
        return p00 == 1 && p11 == 1;
    }
    FingerVector of(const FingerVector &y) const
    {
        return {p00 * y[0] + p01 * y[1], p01 * y[0] + p11 * y[1]};
    }
};

// What moves and what is held in a substep.
struct Regime {
    std::array<Freedom, 2> finger;
    bool object_held = false;
};

class ContactSolver
{
  public:
    explicit ContactSolver(double friction) : friction_(friction)
    {
    }

    // Solve for the impulses of `contacts`, and add what they do to `velocities`. What is held keeps its velocity.
    void solve(const Regime &regime, Contacts &contacts, Velocities &velocities);

  private:
    // A contact's rows as the solver works with them: of the finger's two velocities and of the object's; the
    // tangential ones in lanes.
    struct Rows {
        std::array<double, 3> normal{};
        std::array<Pair, 3> tangential{};
    };

    // A contact in a regime. Made when it is first pushed, since most contacts stay open.
    struct Block {
        Contact *contact = nullptr;
        bool made = false;
        bool movable = false; // whether a normal impulse changes anything
        // In the law's axes, as the impulses are.
        Rows rows;
        Rows acting; // the same, less what stops hold
        CoulombContact law;
        ContactPair impulse_ns;
        ContactPair change_ns; // of the last relax()

        double normal_velocity(const Velocities &y) const;
        ContactPair velocity(const Velocities &y) const;
        // Returns the size of the change.
        double apply(const ContactPair &more_ns, Velocities &y) const;
        // Solve the contact for the present impulses of all others; returns the size of the change.
        double relax(Velocities &y);
        // Change the impulse by a share of its last change.
        void go_on(double share, Velocities &y);
        // Hand the impulse to the contact.
        void store() const;
    };
    // What a sweep did. Two contacts, one a finger, feel each other through the object's velocity alone: their changes
    // then fall from sweep to sweep as a geometric series, whose sum is known after two of them (Aitken).
    struct Coupling {
        double change = 0; // the largest, of a velocity
        bool of_two_fingers = false;
        double object_change = 0; // by the last contact
    };
    Coupling relax_all(const Regime &regime, Velocities &velocities);
    void make(Block &block, const Regime &regime) const;
    void solve_alone(const Regime &regime, Contact &contact, Velocities &velocities);

    double friction_;
    ShortList<Block, most_contacts> blocks_; // of the present call
};

} // namespace twiddle::sim
