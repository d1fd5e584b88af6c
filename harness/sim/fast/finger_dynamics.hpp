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

// The same of one finger, or of two fingers in lanes (lanes.hpp).
template <class Number> using FingerVectorOf = std::array<Number, 2>;

inline FingerVectorOf<Pair> in_lanes(const std::array<FingerVector, 2> &finger)
{
    return {Pair{finger[0][0], finger[1][0]}, Pair{finger[0][1], finger[1][1]}};
}

// M = U D U^T, U with ones on its diagonal and m01 / m11 above it; D is diagonal and its second entry constant, m11.
// Whitening velocities to y = D^1/2 U^T v makes the kinetic energy half of their square.
template <class Number> struct MassFactorOf {
    using FingerVector = FingerVectorOf<Number>;

    Number coupling{};                                        // m01 / m11
    FingerVector root = {Number{} + 1, Number{} + 1};         // of D, sqrt(kg) m
    FingerVector inverse_root = {Number{} + 1, Number{} + 1}; // 1 / root

    // D^-1/2 U^-1 b: what an impulse does to whitened velocities, and a row of a Jacobian in them.
    FingerVector whitened(const FingerVector &b) const
    {
        return {inverse_root[0] * (b[0] - coupling * b[1]), inverse_root[1] * b[1]};
    }
    // U D^1/2 y: the impulse that changes whitened velocities by y.
    FingerVector impulse(const FingerVector &y) const
    {
        const Number second = root[1] * y[1];
        return {root[0] * y[0] + coupling * second, second};
    }
    // U^-T D^-1/2 y: joint velocities.
    FingerVector velocity(const FingerVector &y) const
    {
        const Number first = inverse_root[0] * y[0];
        return {first, inverse_root[1] * y[1] - coupling * first};
    }
    // D^1/2 U^T v.
    FingerVector from_velocity(const FingerVector &v) const
    {
        return {root[0] * v[0], root[1] * (coupling * v[0] + v[1])};
    }
};

using MassFactor = MassFactorOf<double>;

inline MassFactor lane(const MassFactorOf<Pair> &mass, int i)
{
    return {mass.coupling[i], {mass.root[0][i], mass.root[1][i]}, {mass.inverse_root[0][i], mass.inverse_root[1][i]}};
}

// A finger's equations of motion in one state.
template <class Number> struct FingerEquationsOf {
    MassFactorOf<Number> mass;
    FingerVectorOf<Number> resistance_nm{}; // bias(q, v) + weight(q)
};

using FingerEquations = FingerEquationsOf<double>;

// The constants of a finger, or of two in lanes, and what follows from them.
template <class Number> struct FingerConstants {
    // 1, cos, sin, cos 2, sin 2 of the second angle.
    using Series = std::array<Number, 5>;
    // [1, cos, sin of the first angle][the same of the second].
    using Bilinear = std::array<std::array<Number, 3>, 3>;

    Series m00{};
    Series m01{};
    Number inverse_m11{};
    Number root_m11{};
    Number inverse_root_m11{};
    std::array<Bilinear, 2> weight{};

    FingerEquationsOf<Number> equations(const std::array<SineCosineOf<Number>, 2> &angle,
                                        const FingerVectorOf<Number> &velocity_rad_s) const;
    FingerVectorOf<Number> weight_nm(const std::array<SineCosineOf<Number>, 2> &angle) const;
};

class FingerDynamics
{
  public:
    // Sample the joints `first` and `second` (Bullet links of `hand`, the second hanging on the first) under gravity.
    // Leaves the hand reset.
    FingerDynamics(ArticulatedHand &hand, int first, int second, const btVector3 &gravity_palm_m_s2);

    FingerEquations equations(const std::array<SineCosine, 2> &angle, const FingerVector &velocity_rad_s) const
    {
        return constants_.equations(angle, velocity_rad_s);
    }

    const FingerConstants<double> &constants() const
    {
        return constants_;
    }

  private:
    FingerConstants<double> constants_;
};

// Two fingers in lanes.
FingerConstants<Pair> in_lanes(const FingerConstants<double> &first, const FingerConstants<double> &second);

template <class Number>
FingerEquationsOf<Number> FingerConstants<Number>::equations(const std::array<SineCosineOf<Number>, 2> &angle,
                                                             const FingerVectorOf<Number> &velocity_rad_s) const
{
    const Number c = angle[1].cosine, s = angle[1].sine;
    const Number c2 = c * c - s * s, s2 = (s + s) * c;
    const auto sum = [&](const Series &m) { return m[0] + m[1] * c + m[2] * s + m[3] * c2 + m[4] * s2; };
    const auto slope = [&](const Series &m) {
        const Number second = m[4] * c2 - m[3] * s2;
        return m[2] * c - m[1] * s + second + second;
    };

    FingerEquationsOf<Number> equations;
    const Number coupled = sum(m01);
    equations.mass.coupling = coupled * inverse_m11;
    const Number first = square_root(sum(m00) - coupled * equations.mass.coupling);
    equations.mass.root = {first, root_m11};
    equations.mass.inverse_root = {in_lanes<Number>(1) / first, inverse_root_m11};

    const Number m00_slope = slope(m00), m01_slope = slope(m01);
    const Number v0 = velocity_rad_s[0], v1 = velocity_rad_s[1];
    const FingerVectorOf<Number> weight_now = weight_nm(angle);
    equations.resistance_nm = {weight_now[0] + (m00_slope * v0 + m01_slope * v1) * v1,
                               weight_now[1] - m00_slope * v0 * v0 * in_lanes<Number>(0.5)};
    return equations;
}

template <class Number>
FingerVectorOf<Number> FingerConstants<Number>::weight_nm(const std::array<SineCosineOf<Number>, 2> &angle) const
{
    FingerVectorOf<Number> sum;
    for (int joint = 0; joint < 2; joint++) {
        const Bilinear &k = weight[joint];
        const auto row = [&](int a) { return k[a][0] + k[a][1] * angle[1].cosine + k[a][2] * angle[1].sine; };
        sum[joint] = row(0) + row(1) * angle[0].cosine + row(2) * angle[0].sine;
    }
    return sum;
}

} // namespace twiddle::sim
