// coulomb_contact.hpp: one frictional point contact solved exactly, given all other impulses.
//
// Unknown impulse p = (normal, tangential 1, tangential 2); velocity u = W p + b, with W the contact's 3 x 3 inverse effective
// mass and b the velocity without p, both relative to the velocity that the contact asks for. Signorini's and
// Coulomb's laws: p_n >= 0, u_n >= 0, p_n u_n = 0; |p_t| <= mu p_n; and where the contact slides, p_t = -mu p_n u_t / |u_t|.
// With the normal row eliminated, sliding is (A + lambda I) p_t = -c for a multiplier lambda > 0 that makes |p_t| = mu p_n: a
// scalar equation in the eigenbasis of the 2 x 2 Schur complement A (as in trust-region methods: More and
// Sorensen 1983).
#pragma once

#include <array>

namespace twiddle::sim
{

// Order of all three-vectors: normal, tangential 1, tangential 2.
using ContactVector = std::array<double, 3>;
using ContactMatrix = std::array<ContactVector, 3>;

class CoulombContact
{
  public:
    // `inverse_mass` is W: symmetric, positive semi-definite, its normal entry > 0. `friction` is mu >= 0.
    CoulombContact(const ContactMatrix &inverse_mass, double friction);

    // The impulse that obeys both laws for the velocity `b`; a sliding one meets the cone within 1e-10 of the impulse that
    // would stop `b` without friction.
    ContactVector solve(const ContactVector &b) const;

    const ContactMatrix &inverse_mass() const
    {
        return inverse_mass_;
    }

  private:
    // Tangential impulse in the eigenbasis, and the normal impulse that goes with it.
    struct Trial {
        std::array<double, 2> tangential;
        double normal;
        // |p_t| - mu p_n: positive outside the cone.
        double excess;
    };
    Trial try_multiplier(double lambda, double b_normal, const std::array<double, 2> &c) const;

    ContactMatrix inverse_mass_;
    double friction_;
    std::array<double, 2> eigenvalue_{};                 // of A
    std::array<std::array<double, 2>, 2> eigenvector_{}; // [which][tangential axis]
    std::array<double, 2> coupling_{};                   // W's normal-tangential entries in the eigenbasis
};

} // namespace twiddle::sim
