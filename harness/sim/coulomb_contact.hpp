// coulomb_contact.hpp: one frictional point contact solved exactly, given all other impulses.
//
// Unknown impulse p = (normal, tangential 1, tangential 2); velocity u = W p + b, with W the contact's 3 x 3 inverse
// effective mass and b the velocity without p, both relative to the velocity that the contact asks for. Signorini's and
// Coulomb's laws: p_n >= 0, u_n >= 0, p_n u_n = 0; |p_t| <= mu p_n; and where the contact slides,
// p_t = -mu p_n u_t / |u_t|. With the normal row eliminated, sliding is (A + lambda I) p_t = -c for a multiplier
// lambda > 0 that makes |p_t| = mu p_n: a scalar secular equation. Written as mu p_n / |p_t| = 1 it is nearly a
// straight line in lambda, so that Newton's method needs two to four steps (as in trust-region methods: More and
// Sorensen 1983).
#pragma once

#include "fast/lanes.hpp"

#include <array>

namespace twiddle::sim
{

// Order of all three-vectors: normal, tangential 1, tangential 2.
using ContactVector = std::array<double, 3>;
using ContactMatrix = std::array<ContactVector, 3>;

// The same, with the tangential ones in lanes.
struct ContactPair {
    double normal = 0;
    Pair tangential{};
};

// W, which is symmetric, with the tangential rows in lanes.
struct InverseMass {
    double normal = 0; // its first entry
    Pair coupled{};    // the rest of its first row
    Pair tangential{}; // the rest of its diagonal
    double across = 0; // between the tangential directions
};

class CoulombContact
{
  public:
    CoulombContact() = default;

    // `w` is W: positive semi-definite, its normal entry > 0. `friction` is mu >= 0.
    CoulombContact(const InverseMass &w, double friction);
    CoulombContact(const ContactMatrix &w, double friction);

    // The impulse that obeys both laws for the velocity `b`; a sliding one meets the cone within 1e-10 of the impulse
    // that would stop `b` without friction. `multiplier` (lambda, 0 where the contact does not slide) is the first
    // guess and becomes the solution's: that of a similar contact saves most of the work.
    ContactVector solve(const ContactVector &b, double &multiplier) const;
    ContactVector solve(const ContactVector &b) const
    {
        double multiplier = 0;
        return solve(b, multiplier);
    }

    // The principal axes of A, in which a contact is solved again and again for less. What has tangential parts is
    // turned there and back.
    Pair to_axes(Pair tangential) const
    {
        return tangential * cosine_ + swapped(tangential) * Pair{sine_, -sine_};
    }
    Pair from_axes(Pair along_axes) const
    {
        return along_axes * cosine_ + swapped(along_axes) * Pair{-sine_, sine_};
    }

    // The impulse, in these axes, where `velocity` is the velocity with the impulse `present` at work.
    ContactPair solve_along_axes(const ContactPair &velocity, const ContactPair &present, double &multiplier) const;

  private:
    // The impulse for one multiplier.
    struct Trial {
        Pair inverse; // of A + lambda I
        Pair tangential;
        double size; // |p_t|
        double normal;

        // Positive outside the cone.
        double excess(double friction) const
        {
            return size - friction * normal;
        }
    };
    Trial try_multiplier(double lambda, double normal_alone, Pair c) const;
    // Newton's step of the multiplier.
    double newton_step(const Trial &trial) const;
    // The root, held in a bracket from wherever Newton's steps went.
    Trial search(double normal_alone, Pair c, double &multiplier) const;

    double friction_ = 0;
    double cosine_ = 1, sine_ = 0; // of A's first axis
    // All in A's axes.
    Pair schur_{};              // A's diagonal
    Pair coupling_{};           // W's normal-tangential entries over its normal one
    double inverse_normal_ = 0; // 1 / W's normal entry
};

} // namespace twiddle::sim
