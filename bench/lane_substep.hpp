// lane_substep.hpp: the part of a substep that has no branches (sines and cosines, equations of motion, free velocities, joint
// frames, points of the capsules, bounding tests, joint stops, integration), for several trials at once in SIMD lanes.
//
// An experiment: the library's stepper does not use it (bench_lanes.cpp measures why).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#if defined(__GNUC__) && !defined(__clang__)
// As the simulation's library is compiled; without fused multiplications, so that all instruction sets compute the same.
#pragma GCC optimize("O3", "no-math-errno", "fp-contract=off")
#pragma GCC diagnostic ignored "-Wpsabi" // no lanes are passed between functions: all are inlined
#endif

namespace twiddle::lanes
{

constexpr int most_points = 6; // that one joint carries
constexpr double substep_s = 0.002;
constexpr double error_reduction = 0.1;

// `lanes` numbers as one value, for a register of as many. One lane is a plain number.
template <int lanes> struct Lane;
template <> struct Lane<1> {
    using Real = double;
    using Bits = std::uint64_t;
};
template <> struct Lane<2> {
    typedef double Real __attribute__((vector_size(16)));
    typedef std::uint64_t Bits __attribute__((vector_size(16)));
};
template <> struct Lane<4> {
    typedef double Real __attribute__((vector_size(32)));
    typedef std::uint64_t Bits __attribute__((vector_size(32)));
};
template <> struct Lane<8> {
    typedef double Real __attribute__((vector_size(64)));
    typedef std::uint64_t Bits __attribute__((vector_size(64)));
};
template <class Real> constexpr int lanes_of = sizeof(Real) / sizeof(double);

// Everything below is written once, for plain numbers and for lanes.

template <class Real> inline Real square_root(const Real &x)
{
    std::array<double, lanes_of<Real>> each;
    std::memcpy(each.data(), &x, sizeof x);
    for (double &value : each)
        value = std::sqrt(value);
    Real root;
    std::memcpy(&root, each.data(), sizeof root);
    return root;
}

template <class Real> struct Vector {
    Real x, y, z;
};

template <class A, class B> inline auto operator+(const Vector<A> &a, const Vector<B> &b)
{
    return Vector<decltype(a.x + b.x)>{a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class A, class B> inline auto scaled(const A &factor, const Vector<B> &v)
{
    return Vector<decltype(factor * v.x)>{factor * v.x, factor * v.y, factor * v.z};
}

template <class Real> struct Turn {
    Real sine, cosine;
};

// As sim::sine_cosine().
template <class Real> inline Turn<Real> turn(const Real &angle_rad)
{
    using Bits = typename Lane<lanes_of<Real>>::Bits;
    constexpr double rounder = 6755399441055744.0;
    const Real shifted = angle_rad * 0.63661977236758134308 + rounder;
    Bits quarters;
    std::memcpy(&quarters, &shifted, sizeof quarters);
    const Real whole = shifted - rounder;
    const Real x = (angle_rad - whole * 1.57079632673412561417) - whole * 6.0771005065061922e-11;
    const Real xx = x * x;
    const Real sine_rest =
        -1.0 / 6 +
        xx * (1.0 / 120 +
              xx * (-1.0 / 5040 + xx * (1.0 / 362880 + xx * (-1.0 / 39916800 +
                                                             xx * (1.0 / 6227020800 + xx * (-1.0 / 1307674368000))))));
    const Real cosine_rest =
        1.0 / 24 +
        xx * (-1.0 / 720 +
              xx * (1.0 / 40320 + xx * (-1.0 / 3628800 + xx * (1.0 / 479001600 + xx * (-1.0 / 87178291200 +
                                                                                       xx * (1.0 / 20922789888000))))));
    const Real sine = x + x * xx * sine_rest;
    const Real cosine = 1 - (xx / 2 - xx * xx * cosine_rest);
    const Bits one = quarters & std::uint64_t{1}, two = quarters & std::uint64_t{2};
    const Bits next_two = (quarters + std::uint64_t{1}) & std::uint64_t{2};
    const Real turned_sine = one != 0 ? cosine : sine, turned_cosine = one != 0 ? sine : cosine;
    return {two != 0 ? -turned_sine : turned_sine, next_two != 0 ? -turned_cosine : turned_cosine};
}

template <class Real> struct AnyFrame {
    Vector<Real> origin_m, x, y, z;
};

template <class Real> inline auto direction_of(const AnyFrame<Real> &frame, const Vector<double> &v)
{
    return scaled(v.x, frame.x) + scaled(v.y, frame.y) + scaled(v.z, frame.z);
}

template <class Frame, class Real> inline AnyFrame<Real> turned(const Frame &frame, const Turn<Real> &angle)
{
    const Real minus_sine = -angle.sine, zero = angle.sine * 0;
    const Vector<Real> nothing = {zero, zero, zero};
    return {frame.origin_m + nothing, scaled(angle.cosine, frame.x) + scaled(angle.sine, frame.y),
            scaled(angle.cosine, frame.y) + scaled(minus_sine, frame.x), frame.z + nothing};
}

// What a joint carries: points of capsules, and where the centre of the ball around them may touch the object.
struct Carried {
    int points = 0;
    std::array<Vector<double>, most_points> point_m;
    Vector<double> centre_m;
    double square_across_m2 = 0, along_m = 0;
};

// What is constant of a finger: as FingerDynamics, FingerKinematics and JointStops hold it.
struct Finger {
    std::array<double, 5> m00{}, m01{};
    double inverse_m11 = 0, root_m11 = 0, inverse_root_m11 = 0;
    std::array<std::array<std::array<double, 3>, 3>, 2> weight{};
    AnyFrame<double> first, second;
    std::array<Carried, 2> carried;
    std::array<double, 2> lower_rad{}, upper_rad{};
};

// Aligned by hand: without instructions for such wide lanes the compiler does not do it, and those with them ask for it.
template <class Real> struct alignas(sizeof(Real)) State {
    std::array<Real, 2> angle_rad, velocity_rad_s, torque_nm;
};

// What contacts ask of a finger, and where the finger is after the substep if there are none.
template <class Real> struct alignas(sizeof(Real)) Result {
    std::array<Real, 2> angle_rad, velocity_rad_s;
    Real coupling, root, inverse_root;      // MassFactor
    std::array<Real, 2> free;               // whitened velocities
    std::array<Real, 2> may_touch, at_stop; // 1 or 0 for each joint
    std::array<AnyFrame<Real>, 2> frame;
    std::array<std::array<Vector<Real>, most_points>, 2> point_m;
};

// As FingerDynamics::equations(), and what is made of it.
template <class Real>
inline void find_free_velocities(const Finger &finger, const State<Real> &state, const std::array<Turn<Real>, 2> &angle,
                                 Result<Real> &result)
{
    const Real c = angle[1].cosine, s = angle[1].sine;
    const Real c2 = c * c - s * s, s2 = 2 * s * c;
    const auto sum = [&](const std::array<double, 5> &m) { return m[0] + m[1] * c + m[2] * s + m[3] * c2 + m[4] * s2; };
    const auto slope = [&](const std::array<double, 5> &m) {
        return m[2] * c - m[1] * s + 2 * (m[4] * c2 - m[3] * s2);
    };
    const Real m01 = sum(finger.m01), coupling = m01 * finger.inverse_m11;
    const Real root = square_root<Real>(sum(finger.m00) - m01 * coupling), inverse_root = 1 / root;
    const Real m00_slope = slope(finger.m00), m01_slope = slope(finger.m01);
    const Real v0 = state.velocity_rad_s[0], v1 = state.velocity_rad_s[1];
    const std::array<Real, 2> bias_nm = {(m00_slope * v0 + m01_slope * v1) * v1, -(m00_slope * v0 * v0 / 2)};
    std::array<Real, 2> impulse_nms;
    for (int j = 0; j < 2; j++) {
        const auto row = [&](int a) {
            return finger.weight[j][a][0] + finger.weight[j][a][1] * c + finger.weight[j][a][2] * s;
        };
        const Real weight_nm = row(0) + row(1) * angle[0].cosine + row(2) * angle[0].sine;
        impulse_nms[j] = substep_s * (state.torque_nm[j] - (weight_nm + bias_nm[j]));
    }
    result.coupling = coupling;
    result.root = root;
    result.inverse_root = inverse_root;
    result.free[0] = root * v0 + inverse_root * (impulse_nms[0] - coupling * impulse_nms[1]);
    result.free[1] = finger.root_m11 * (coupling * v0 + v1) + finger.inverse_root_m11 * impulse_nms[1];
}

// As FingerKinematics::frames(), the capsules' points, and may_touch().
template <class Real>
inline void find_places(const Finger &finger, const std::array<Turn<Real>, 2> &angle, Result<Real> &result)
{
    result.frame[0] = turned(finger.first, angle[0]);
    const AnyFrame<Real> &first = result.frame[0];
    const AnyFrame<Real> second = {first.origin_m + direction_of(first, finger.second.origin_m),
                                   direction_of(first, finger.second.x), direction_of(first, finger.second.y),
                                   direction_of(first, finger.second.z)};
    result.frame[1] = turned(second, angle[1]);
    const Real one = angle[0].sine * 0 + 1, zero = angle[0].sine * 0;
    for (int j = 0; j < 2; j++) {
        const Carried &carried = finger.carried[j];
        const AnyFrame<Real> &frame = result.frame[j];
        for (int i = 0; i < carried.points; i++)
            result.point_m[j][i] = frame.origin_m + direction_of(frame, carried.point_m[i]);
        const Vector<Real> p_m = frame.origin_m + direction_of(frame, carried.centre_m);
        const Real across_m2 = p_m.x * p_m.x + p_m.y * p_m.y;
        const auto outside =
            (across_m2 > carried.square_across_m2) | (p_m.z > carried.along_m) | (p_m.z < -carried.along_m);
        result.may_touch[j] = outside ? zero : one;
    }
}

// As JointStops::passed(), and FastWorld::integrate().
template <class Real> inline void finish(const Finger &finger, const State<Real> &state, Result<Real> &result)
{
    const Real first = result.inverse_root * result.free[0];
    result.velocity_rad_s = {first, finger.inverse_root_m11 * result.free[1] - result.coupling * first};
    const Real one = first * 0 + 1, zero = first * 0;
    for (int j = 0; j < 2; j++) {
        const Real move_rad = substep_s * result.velocity_rad_s[j];
        const Real below_rad = finger.lower_rad[j] - state.angle_rad[j];
        const Real above_rad = finger.upper_rad[j] - state.angle_rad[j];
        const Real reduced_below_rad = error_reduction * below_rad, reduced_above_rad = error_reduction * above_rad;
        const Real least_rad = below_rad < 0 ? below_rad : reduced_below_rad;
        const Real most_rad = above_rad > 0 ? above_rad : reduced_above_rad;
        result.at_stop[j] = (move_rad < least_rad) | (move_rad > most_rad) ? one : zero;
        result.angle_rad[j] = state.angle_rad[j] + move_rad;
    }
}

template <class Real>
inline void advance(const std::array<Finger, 2> &fingers, const std::array<State<Real>, 2> &states,
                    std::array<Result<Real>, 2> &results)
{
    for (int f = 0; f < 2; f++) {
        const std::array<Turn<Real>, 2> angle = {turn(states[f].angle_rad[0]), turn(states[f].angle_rad[1])};
        find_free_velocities(fingers[f], states[f], angle, results[f]);
        find_places(fingers[f], angle, results[f]);
        finish(fingers[f], states[f], results[f]);
    }
}

} // namespace twiddle::lanes
