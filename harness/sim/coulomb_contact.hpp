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

#include <array>

namespace twiddle::sim
{

// Order of all three-vectors: normal, tangential 1, tangential 2.
using ContactVector = std::array<double, 3>;
using ContactMatrix = std::array<ContactVector, 3>;

class CoulombContact
{
  public:
    CoulombContact() = default;

    // `inverse_mass` is W: symmetric, positive semi-definite, its normal entry > 0. `friction` is mu >= 0.
    CoulombContact(const ContactMatrix &inverse_mass, double friction);

    // The impulse that obeys both laws for the velocity `b`; a sliding one meets the cone within 1e-10 of the impulse
    // that would stop `b` without friction. `multiplier` (lambda, 0 where the contact does not slide) is the first
    // guess and becomes the solution's: that of a similar contact saves most of the work.
    ContactVector solve(const ContactVector &b, double &multiplier) const;
    ContactVector solve(const ContactVector &b) const
    {
        double multiplier = 0;
        return solve(b, multiplier);
    }

    const ContactMatrix &inverse_mass() const
    {
        return inverse_mass_;
    }

  private:
    // The impulse for one multiplier.
    struct Trial {
        std::array<double, 2> tangential;
        double size; // |p_t|
        double normal;
        std::array<double, 2> solved; // (A + lambda I)^-1 p_t: minus the slope of p_t

        // Positive outside the cone.
        double excess(double friction) const
        {
            return size - friction * normal;
        }
    };
    Trial try_multiplier(double lambda, double normal_alone, const std::array<double, 2> &c) const;
    // Newton's step of the multiplier.
    double newton_step(const Trial &trial) const;

    ContactMatrix inverse_mass_{};
    double friction_ = 0;
    std::array<double, 3> schur_{};    // A: entries 11, 12, 22
    std::array<double, 2> coupling_{}; // W's normal-tangential entries over its normal one
    double inverse_normal_ = 0;        // 1 / W's normal entry
};

} // namespace twiddle::sim
