// The hinge's friction in a time stepper of its own. Expected: closed forms of a wheel with Coulomb friction.
#include "sim/fast/hinge_friction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace twiddle::sim
{
namespace
{

constexpr double coulomb_nm = 0.002, inertia_kg_m2 = 4.5e-5, substep_s = 0.002;
const double whitening = std::sqrt(inertia_kg_m2);

// A wheel on the hinge, driven by a torque; no contacts. Each substep finds the regime that speaks for itself.
class Wheel
{
  public:
    double velocity_rad_s = 0;
    HingeRegime regime = HingeRegime::held;

    // Returns the number of regimes that were tried.
    int substep(double torque_nm)
    {
        const double free = whitening * (velocity_rad_s + substep_s * torque_nm / inertia_kg_m2);
        for (int attempts = 1;; attempts++) {
            const double found = friction_.start(regime, free);
            const HingeRegime next = friction_.judge(regime, free, found);
            velocity_rad_s = found / whitening;
            if (next == regime || attempts == 10) return attempts;
            regime = next;
        }
    }

  private:
    HingeFriction friction_{coulomb_nm, inertia_kg_m2, substep_s};
};

class fast_stepper_hinge_friction : public testing::TestWithParam<int>
{
  protected:
    const int direction_ = GetParam();
};

// Expected: stuck, exactly, below the Coulomb torque; above it the acceleration (torque - coulomb) / inertia.
TEST_P(fast_stepper_hinge_friction, holds_a_torque_ramp_up_to_the_coulomb_torque)
{
    Wheel wheel;
    for (int i = 1; i <= 200; i++) {
        const double torque_nm = direction_ * 2 * coulomb_nm * (i - 0.5) / 200;
        const double before_rad_s = wheel.velocity_rad_s;
        EXPECT_LE(wheel.substep(torque_nm), 2);
        if (std::abs(torque_nm) < coulomb_nm) {
            ASSERT_EQ(wheel.velocity_rad_s, 0) << torque_nm;
        } else {
            const double expected_rad_s2 = (torque_nm - direction_ * coulomb_nm) / inertia_kg_m2;
            ASSERT_NEAR((wheel.velocity_rad_s - before_rad_s) / substep_s, expected_rad_s2, 1e-9) << torque_nm;
        }
    }
    EXPECT_GT(direction_ * wheel.velocity_rad_s, 1);
}

// Expected: a constant deceleration coulomb / inertia to a stop, and rest from there on: never the other way.
TEST_P(fast_stepper_hinge_friction, brings_a_turning_wheel_to_a_stop_that_stays)
{
    Wheel wheel;
    wheel.velocity_rad_s = direction_ * 3;
    const double stop_s = 3 * inertia_kg_m2 / coulomb_nm;
    for (int i = 1; i <= 200; i++) {
        wheel.substep(0);
        const double left_rad_s = 3 * (1 - i * substep_s / stop_s);
        ASSERT_NEAR(wheel.velocity_rad_s, direction_ * std::max(left_rad_s, 0.0), 1e-12) << i;
        if (left_rad_s < 0) {
            ASSERT_EQ(wheel.velocity_rad_s, 0) << i;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Sim, fast_stepper_hinge_friction, testing::Values(1, -1),
                         [](const auto &direction) { return direction.param > 0 ? "forward" : "backward"; });

// Expected: the textbook's law, v = clamp of the frictionless velocity towards 0 by coulomb h / inertia; so the
// friction never adds energy. Under random torques, from random velocities and whatever regime was last.
TEST(fast_stepper_hinge_energy, never_adds_energy)
{
    constexpr unsigned seed = 51;
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    const double most_rad_s = coulomb_nm * substep_s / inertia_kg_m2;
    Wheel wheel;
    for (int i = 0; i < 100000; i++) {
        if (i % 10 == 0) wheel.velocity_rad_s = normal(random);
        const double torque_nm = 2 * coulomb_nm * normal(random);
        const double free_rad_s = wheel.velocity_rad_s + substep_s * torque_nm / inertia_kg_m2;
        ASSERT_LE(wheel.substep(torque_nm), 3);
        ASSERT_LE(std::abs(wheel.velocity_rad_s), std::abs(free_rad_s)) << "seed " << seed << ", substep " << i;
        const double expected_rad_s = std::copysign(std::max(std::abs(free_rad_s) - most_rad_s, 0.0), free_rad_s);
        ASSERT_NEAR(wheel.velocity_rad_s, expected_rad_s, 1e-12) << "seed " << seed << ", substep " << i;
    }
}

} // namespace
} // namespace twiddle::sim
