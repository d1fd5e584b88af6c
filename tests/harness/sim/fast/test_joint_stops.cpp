// Joint stops as choices of what is held. Expected: closed forms.
#include "sim/fast/joint_stops.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace twiddle::sim
{
namespace
{

constexpr double substep_s = 0.002, error_reduction = 0.1;
const FingerVector lower_rad = {-0.2, 0}, upper_rad = {0.3, 1.5};
constexpr double exact = 1e-12;

const std::array<HeldJoints, 9> all_choices = {{{Stop::none, Stop::none},
                                                {Stop::none, Stop::lower},
                                                {Stop::none, Stop::upper},
                                                {Stop::lower, Stop::none},
                                                {Stop::lower, Stop::lower},
                                                {Stop::lower, Stop::upper},
                                                {Stop::upper, Stop::none},
                                                {Stop::upper, Stop::lower},
                                                {Stop::upper, Stop::upper}}};

JointStops stops()
{
    return JointStops(lower_rad, upper_rad, error_reduction, substep_s);
}

// A factor of M = [m00 m01; m01 m11] with random positive moments and a coupling that keeps it positive definite.
MassFactor random_mass(std::mt19937_64 &random)
{
    std::uniform_real_distribution<double> uniform(0, 1);
    const double m00 = 1e-5 + 1e-4 * uniform(random), m11 = 1e-5 + 1e-4 * uniform(random);
    const double m01 = (1.8 * uniform(random) - 0.9) * std::sqrt(m00 * m11);
    MassFactor mass;
    mass.coupling = m01 / m11;
    mass.root = {std::sqrt(m00 - m01 * m01 / m11), std::sqrt(m11)};
    mass.inverse_root = {1 / mass.root[0], 1 / mass.root[1]};
    return mass;
}

bool held(const HeldJoints &choice, int joint)
{
    return choice[joint] != Stop::none;
}

// How far a joint may go in a substep: to its stop from inside, a tenth of the way back from outside.
double target_rad(Stop stop, int joint, double angle_rad)
{
    const double distance_rad = (stop == Stop::lower ? lower_rad[joint] : upper_rad[joint]) - angle_rad;
    const bool past = stop == Stop::lower ? distance_rad > 0 : distance_rad < 0;
    return past ? error_reduction * distance_rad : distance_rad;
}

// By hand: from 0.01 rad before the stop a substep of 2 ms allows 5 rad/s; from 0.01 rad behind it, it asks for a
// tenth of that back.
TEST(fast_stepper_joint_stops, are_passed_where_the_substep_ends_behind_them)
{
    const HeldJoints none{};
    EXPECT_EQ(stops().passed({0, 0.5}, {4, -4}), none);
    EXPECT_EQ(stops().passed({0.29, 1.49}, {4.99, 4.99}), none);
    EXPECT_EQ(stops().passed({0.29, 1.49}, {5.01, 4.99}), (HeldJoints{Stop::upper, Stop::none}));
    EXPECT_EQ(stops().passed({-0.19, 0.01}, {-4.99, -5.01}), (HeldJoints{Stop::none, Stop::lower}));
    EXPECT_EQ(stops().passed({0.31, -0.01}, {-0.49, 0.49}), (HeldJoints{Stop::upper, Stop::lower}));
    EXPECT_EQ(stops().passed({0.31, -0.01}, {-0.51, 0.51}), none);
}

// The freedom is a symmetric projector: P P = P. It leaves as many directions as joints are free (its trace), lets
// through no impulse's share that would move a held joint (the joint's velocity under P y is 0 for any y), and takes
// nothing from a motion in which the held joints rest. Symmetry is part of its type.
TEST(fast_stepper_joint_stops, freedom_is_the_projector_on_the_motions_that_the_held_joints_leave)
{
    constexpr unsigned seed = 41;
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 1000; i++) {
        const MassFactor mass = random_mass(random);
        for (const HeldJoints &choice : all_choices) {
            SCOPED_TRACE(testing::Message() << "seed " << seed << ", case " << i);
            const Freedom p = JointStops::freedom(choice, mass);
            EXPECT_NEAR(p.p00 * p.p00 + p.p01 * p.p01, p.p00, exact);
            EXPECT_NEAR(p.p00 * p.p01 + p.p01 * p.p11, p.p01, exact);
            EXPECT_NEAR(p.p01 * p.p01 + p.p11 * p.p11, p.p11, exact);
            EXPECT_NEAR(p.p00 + p.p11, (held(choice, 0) ? 0 : 1) + (held(choice, 1) ? 0 : 1), exact);

            const double y0 = normal(random);
            const FingerVector moved = mass.velocity(p.of({y0, normal(random)}));
            const FingerVector freely = {held(choice, 0) ? 0 : normal(random), held(choice, 1) ? 0 : normal(random)};
            const FingerVector kept = mass.velocity(p.of(mass.from_velocity(freely)));
            for (int j = 0; j < 2; j++) {
                // Joint velocities are whitened ones over the inertias' roots, some 100 times larger.
                if (held(choice, j)) {
                    EXPECT_NEAR(moved[j], 0, 1e3 * exact);
                }
                EXPECT_NEAR(kept[j], freely[j], 1e3 * exact);
            }
        }
    }
}

// Held joints start with the velocity that brings them to the stop; what the stops do to the others is what impulses on
// the held joints alone do (M times the change of velocity has no entry at a free joint: Newton's law).
TEST(fast_stepper_joint_stops, held_joints_reach_their_stops_by_impulses_of_their_own)
{
    constexpr unsigned seed = 42;
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 1000; i++) {
        const MassFactor mass = random_mass(random);
        const double first_rad = -0.3 + 0.7 * std::uniform_real_distribution<double>()(random);
        const FingerVector angle_rad = {first_rad, -0.1 + 1.7 * std::uniform_real_distribution<double>()(random)};
        const double v0_rad_s = 5 * normal(random);
        const FingerVector before_rad_s = {v0_rad_s, 5 * normal(random)};
        const FingerVector y = mass.from_velocity(before_rad_s);
        for (const HeldJoints &choice : all_choices) {
            SCOPED_TRACE(testing::Message() << "seed " << seed << ", case " << i);
            const FingerVector after = stops().start(choice, angle_rad, mass, JointStops::freedom(choice, mass), y);
            const FingerVector after_rad_s = mass.velocity(after);
            const FingerVector impulse_nms = mass.impulse({after[0] - y[0], after[1] - y[1]});
            for (int j = 0; j < 2; j++) {
                if (held(choice, j)) {
                    EXPECT_NEAR(substep_s * after_rad_s[j], target_rad(choice[j], j, angle_rad[j]), exact);
                } else {
                    EXPECT_NEAR(impulse_nms[j], 0, exact);
                }
            }
        }
    }
}

// A lower stop pushes forwards and an upper one backwards; the impulse of the other sign would pull, and lets go.
TEST(fast_stepper_joint_stops, let_go_where_they_would_pull)
{
    for (const HeldJoints &choice : all_choices) {
        for (const FingerVector &impulse_nms : {FingerVector{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
            const HeldJoints pushing = JointStops::pushing(choice, impulse_nms);
            for (int j = 0; j < 2; j++) {
                const bool pulls = choice[j] == Stop::lower ? impulse_nms[j] < 0 : impulse_nms[j] > 0;
                EXPECT_EQ(pushing[j], pulls ? Stop::none : choice[j]);
            }
        }
    }
}

} // namespace
} // namespace twiddle::sim
