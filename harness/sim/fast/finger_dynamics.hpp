// finger_dynamics.hpp: the equations of motion of a finger of two joints, reduced to a few constants.
//
//     M(q) a + bias(q, v) + weight(q) = torque
// The mass matrix M of two joints on a fixed base depends on the second angle alone, as a Fourier series that ends at
// the second harmonic (a rotated inertia tensor is quadratic in sine and cosine); M11 is constant. Centrifugal and
// Coriolis torques follow from its derivative M' (Christoffel symbols; Featherstone 2008, "Rigid Body Dynamics
// Algorithms", section 3.3):
//     bias0 = M00' v0 v1 + M01' v1^2,   bias1 = -M00' v0^2 / 2
// The weight's torques are bilinear in (1, cos, sin) of the two angles. All constants are sampled from Bullet's
// articulated-body algorithm at set-up.
#pragma once

#include "sim/articulated_hand.hpp"
#include "sine_cosine.hpp"

#include <array>

namespace twiddle::sim
{

// Values of a finger's two joints, from the palm outwards.
using FingerVector = std::array<double, 2>;

// M = U D U^T, U with ones on its diagonal and m01 / m11 above it; D is diagonal and its second entry constant, m11.
// Whitening velocities to y = D^1/2 U^T v makes the kinetic energy half of their square.
struct MassFactor {
    double coupling = 0;                // m01 / m11
    FingerVector root = {1, 1};         // of D, sqrt(kg) m
    FingerVector inverse_root = {1, 1}; // 1 / root

    // D^-1/2 U^-1 b: what an impulse does to whitened velocities, and a row of a Jacobian in them.
    FingerVector whitened(const FingerVector &b) const
    {
        return {inverse_root[0] * (b[0] - coupling * b[1]), inverse_root[1] * b[1]};
    }
    // U D^1/2 y: the impulse that changes whitened velocities by y.
    FingerVector impulse(const FingerVector &y) const
    {
        const double second = root[1] * y[1];
        return {root[0] * y[0] + coupling * second, second};
    }
    // U^-T D^-1/2 y: joint velocities.
    FingerVector velocity(const FingerVector &y) const
    {
        const double first = inverse_root[0] * y[0];
        return {first, inverse_root[1] * y[1] - coupling * first};
    }
    // D^1/2 U^T v.
    FingerVector from_velocity(const FingerVector &v) const
    {
        return {root[0] * v[0], root[1] * (coupling * v[0] + v[1])};
    }
};

// A finger's equations of motion in one state.
struct FingerEquations {
    MassFactor mass;
    FingerVector resistance_nm{}; // bias(q, v) + weight(q)
};

class FingerDynamics
{
  public:
    // Sample the joints `first` and `second` (Bullet links of `hand`, the second hanging on the first) under gravity.
    // Leaves the hand reset.
    FingerDynamics(ArticulatedHand &hand, int first, int second, const btVector3 &gravity_palm_m_s2);

    FingerEquations equations(const std::array<SineCosine, 2> &angle, const FingerVector &velocity_rad_s) const;

  private:
    // 1, cos, sin, cos 2, sin 2 of the second angle.
    using Series = std::array<double, 5>;
    // [1, cos, sin of the first angle][the same of the second].
    using Bilinear = std::array<std::array<double, 3>, 3>;

    FingerVector weight_nm(const std::array<SineCosine, 2> &angle) const;

    Series m00_{};
    Series m01_{};
    double m11_ = 0;
    double inverse_m11_ = 0;
    double root_m11_ = 0;
    double inverse_root_m11_ = 0;
    std::array<Bilinear, 2> weight_{};
};

} // namespace twiddle::sim
