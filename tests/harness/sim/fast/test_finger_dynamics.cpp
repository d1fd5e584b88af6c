// The reduced equations of motion of a finger. Expected: Bullet's articulated-body algorithm, and
// conservation of energy.
#include "finger_fixtures.hpp"

#include <LinearMath/btAlignedObjectArray.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace twiddle::sim
{
namespace
{

constexpr double beyond_rad = 1; // how far random angles go past the stops
constexpr double largest_rad_s = 30;
constexpr double largest_nm = 1; // the drives' limit

double dot(const FingerVector &a, const FingerVector &b)
{
    return a[0] * b[0] + a[1] * b[1];
}

double distance(const FingerVector &a, const FingerVector &b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1]);
}

double size(const FingerVector &a)
{
    return std::hypot(a[0], a[1]);
}

// The accelerations that Bullet's articulated-body algorithm gives the finger's joints.
class ArticulatedBodyAlgorithm
{
  public:
    explicit ArticulatedBodyAlgorithm(BulletFinger &finger) : finger_(finger)
    {
        finger_.hand.body().setMaxCoordinateVelocity(1e12); // a step of 1 s below reaches any velocity
    }

    FingerVector accelerations_rad_s2(const FingerVector &angle_rad, const FingerVector &velocity_rad_s,
                                      const FingerVector &torque_nm, const btVector3 &gravity_m_s2)
    {
        btMultiBody &body = finger_.hand.body();
        finger_.hand.reset();
        finger_.set_angles(angle_rad);
        for (int link = 0; link < body.getNumLinks(); link++)
            body.addLinkForce(link, gravity_m_s2 * body.getLinkMass(link));
        for (int j = 0; j < 2; j++) {
            body.setJointVel(finger_.link[j], velocity_rad_s[j]);
            body.addJointTorque(finger_.link[j], torque_nm[j]);
        }
        body.computeAccelerationsArticulatedBodyAlgorithmMultiDof(1, scalars_, vectors_, matrices_, false, false,
                                                                  false);
        FingerVector acceleration;
        for (int j = 0; j < 2; j++)
            acceleration[j] = body.getJointVel(finger_.link[j]) - velocity_rad_s[j];
        return acceleration;
    }

  private:
    BulletFinger &finger_;
    btAlignedObjectArray<btScalar> scalars_;
    btAlignedObjectArray<btVector3> vectors_;
    btAlignedObjectArray<btMatrix3x3> matrices_;
};

// The mass matrix's entries 00, 01, 11: Bullet's answers to a torque on each joint of the finger at rest, inverted.
std::array<double, 3> bullet_mass(ArticulatedBodyAlgorithm &bullet, const FingerVector &angle_rad)
{
    const btVector3 weightless(0, 0, 0);
    const FingerVector a = bullet.accelerations_rad_s2(angle_rad, {0, 0}, {1, 0}, weightless);
    const FingerVector b = bullet.accelerations_rad_s2(angle_rad, {0, 0}, {0, 1}, weightless);
    const double determinant = a[0] * b[1] - a[1] * b[0];
    return {b[1] / determinant, -a[1] / determinant, a[0] / determinant};
}

FingerVector accelerations_rad_s2(const FingerDynamics &dynamics, const FingerVector &angle_rad,
                                  const FingerVector &velocity_rad_s, const FingerVector &torque_nm)
{
    const FingerEquations equations = dynamics.equations(sines_cosines(angle_rad), velocity_rad_s);
    const FingerVector net_nm = {torque_nm[0] - equations.resistance_nm[0], torque_nm[1] - equations.resistance_nm[1]};
    return equations.mass.velocity(equations.mass.whitened(net_nm));
}

class fast_stepper_dynamics : public testing::TestWithParam<FingerCase>
{
  protected:
    fast_stepper_dynamics()
        : finger_(setup_with_distal(std::get<0>(GetParam()), std::get<1>(GetParam())), std::get<2>(GetParam())),
          dynamics_(finger_.hand, finger_.link[0], finger_.link[1], finger_.gravity_m_s2)
    {
    }

    BulletFinger finger_;
    const FingerDynamics dynamics_;
};

// Expected: Bullet's accelerations, of the whole multibody with weight, velocities and torques, at 1,000 random states.
TEST_P(fast_stepper_dynamics, accelerations_equal_bullets_articulated_body_algorithm)
{
    constexpr unsigned seed = 11;
    std::mt19937_64 random(seed);
    ArticulatedBodyAlgorithm bullet(finger_);
    double largest_error = 0, fastest_rad_s2 = 0;
    for (int i = 0; i < 1000; i++) {
        const FingerVector angle_rad = finger_.random_angles(random, beyond_rad);
        const FingerVector velocity_rad_s = random_pair(random, largest_rad_s);
        const FingerVector torque_nm = random_pair(random, largest_nm);
        const FingerVector expected =
            bullet.accelerations_rad_s2(angle_rad, velocity_rad_s, torque_nm, finger_.gravity_m_s2);
        const FingerVector actual = accelerations_rad_s2(dynamics_, angle_rad, velocity_rad_s, torque_nm);
        largest_error = std::max(largest_error, distance(actual, expected) / size(expected));
        fastest_rad_s2 = std::max(fastest_rad_s2, size(expected));
    }
    std::printf("seed %u: accelerations up to %.1e rad/s^2, largest relative difference %.1e\n", seed, fastest_rad_s2,
                largest_error);
    EXPECT_LE(largest_error, 1e-9);
}

// The same where velocities and weight alone accelerate the finger, so that no torque hides them.
TEST_P(fast_stepper_dynamics, accelerations_without_torques_equal_bullets)
{
    constexpr unsigned seed = 12;
    std::mt19937_64 random(seed);
    ArticulatedBodyAlgorithm bullet(finger_);
    double largest_error = 0;
    for (int i = 0; i < 1000; i++) {
        const FingerVector angle_rad = finger_.random_angles(random, beyond_rad);
        const FingerVector velocity_rad_s = random_pair(random, i % 2 == 0 ? largest_rad_s : 0);
        const FingerVector expected =
            bullet.accelerations_rad_s2(angle_rad, velocity_rad_s, {0, 0}, finger_.gravity_m_s2);
        const FingerVector actual = accelerations_rad_s2(dynamics_, angle_rad, velocity_rad_s, {0, 0});
        largest_error = std::max(largest_error, distance(actual, expected) / size(expected));
    }
    std::printf("seed %u: largest relative difference %.1e\n", seed, largest_error);
    EXPECT_LE(largest_error, 1e-9);
}

// |y|^2 = v^T M v with Bullet's M; the changes to whitened velocities and impulses and those back are inverses; an
// impulse changes velocities by M^-1 times it.
TEST_P(fast_stepper_dynamics, mass_factor_whitens_bullets_mass_matrix)
{
    constexpr unsigned seed = 13;
    constexpr double exact = 1e-12; // relative; rounding
    std::mt19937_64 random(seed);
    ArticulatedBodyAlgorithm bullet(finger_);
    double largest_error = 0;
    for (int i = 0; i < 1000; i++) {
        const FingerVector angle_rad = finger_.random_angles(random, beyond_rad);
        const auto m = bullet_mass(bullet, angle_rad);
        const MassFactor mass = dynamics_.equations(sines_cosines(angle_rad), {0, 0}).mass;
        const FingerVector v = random_pair(random, largest_rad_s), y = mass.from_velocity(v);
        const double twice_energy_j = m[0] * v[0] * v[0] + 2 * m[1] * v[0] * v[1] + m[2] * v[1] * v[1];
        largest_error = std::max(largest_error, std::abs(dot(y, y) / twice_energy_j - 1));

        ASSERT_LE(distance(mass.velocity(y), v), exact * size(v));
        const FingerVector impulse_nms = random_pair(random, 1), whitened = mass.whitened(impulse_nms);
        ASSERT_LE(distance(mass.impulse(whitened), impulse_nms), exact * size(impulse_nms));
        const FingerVector change = mass.velocity(whitened);
        const FingerVector back = {m[0] * change[0] + m[1] * change[1], m[1] * change[0] + m[2] * change[1]};
        largest_error = std::max(largest_error, distance(back, impulse_nms) / size(impulse_nms));
    }
    std::printf("seed %u: largest relative difference from Bullet's mass matrix %.1e\n", seed, largest_error);
    EXPECT_LE(largest_error, 1e-9);
}

// Potential energy of the finger's weight, from where Bullet puts its links.
double potential_j(BulletFinger &finger, const FingerVector &angle_rad)
{
    finger.set_angles(angle_rad);
    double sum_j = 0;
    for (int i = 0; i < static_cast<int>(finger.hand.links().size()); i++) {
        const HandLink &link = finger.hand.model().links[finger.hand.links()[i].model_link];
        sum_j -= link.mass_kg * finger.gravity_m_s2.dot(finger.hand.X_palm_link(i) * link.p_link_com_m);
    }
    return sum_j;
}

struct Motion {
    FingerVector angle_rad, velocity_rad_s;
};

Motion moved(const Motion &at, const Motion &rate, double time_s)
{
    Motion motion = at;
    for (int j = 0; j < 2; j++) {
        motion.angle_rad[j] += time_s * rate.angle_rad[j];
        motion.velocity_rad_s[j] += time_s * rate.velocity_rad_s[j];
    }
    return motion;
}

// One step of the classical Runge-Kutta method.
Motion stepped(const FingerDynamics &dynamics, const Motion &start, double step_s)
{
    const auto rate = [&](const Motion &at) {
        return Motion{at.velocity_rad_s, accelerations_rad_s2(dynamics, at.angle_rad, at.velocity_rad_s, {0, 0})};
    };
    const Motion k1 = rate(start);
    const Motion k2 = rate(moved(start, k1, step_s / 2));
    const Motion k3 = rate(moved(start, k2, step_s / 2));
    const Motion k4 = rate(moved(start, k3, step_s));
    return moved(moved(moved(moved(start, k1, step_s / 6), k2, step_s / 3), k3, step_s / 3), k4, step_s / 6);
}

// Expected: conservation, with the potential energy from the links' places. A fourth-order step leaves the drift to the
// equations.
TEST_P(fast_stepper_dynamics, energy_of_an_undriven_finger_is_conserved)
{
    constexpr double step_s = 1e-4;
    Motion motion;
    for (int j = 0; j < 2; j++)
        motion.angle_rad[j] = (finger_.lower_rad[j] + finger_.upper_rad[j]) / 2;
    motion.velocity_rad_s = {6, -9};
    const auto kinetic_j = [&] {
        const MassFactor mass = dynamics_.equations(sines_cosines(motion.angle_rad), motion.velocity_rad_s).mass;
        const FingerVector y = mass.from_velocity(motion.velocity_rad_s);
        return dot(y, y) / 2;
    };
    const double start_j = kinetic_j() + potential_j(finger_, motion.angle_rad);
    double largest_kinetic_j = 0, smallest_kinetic_j = kinetic_j(), drift_j = 0;
    for (int i = 0; i < std::lround(1 / step_s); i++) {
        motion = stepped(dynamics_, motion, step_s);
        const double now_j = kinetic_j();
        largest_kinetic_j = std::max(largest_kinetic_j, now_j);
        smallest_kinetic_j = std::min(smallest_kinetic_j, now_j);
        drift_j = std::max(drift_j, std::abs(now_j + potential_j(finger_, motion.angle_rad) - start_j));
    }
    std::printf("kinetic energy %.3f to %.3f mJ, drift %.1e of the largest\n", 1e3 * smallest_kinetic_j,
                1e3 * largest_kinetic_j, drift_j / largest_kinetic_j);
    EXPECT_GT(largest_kinetic_j, 1.5 * smallest_kinetic_j) << "too little exchange of energy to say anything";
    EXPECT_LE(drift_j, 1e-9 * largest_kinetic_j);
}

// Both fingers in lanes. Expected: the same bits as of each finger alone.
TEST_P(fast_stepper_dynamics, lanes_have_the_equations_of_each_finger)
{
    constexpr unsigned seed = 16;
    const Finger finger = std::get<2>(GetParam());
    BulletFinger other(setup_with_distal(std::get<0>(GetParam()), std::get<1>(GetParam())),
                       finger == Finger::index ? Finger::thumb : Finger::index);
    const FingerDynamics other_dynamics(other.hand, other.link[0], other.link[1], other.gravity_m_s2);
    const FingerConstants<Pair> both = in_lanes(dynamics_.constants(), other_dynamics.constants());
    std::mt19937_64 random(seed);
    for (int i = 0; i < 1000; i++) {
        const std::array<FingerVector, 2> angle_rad = {random_pair(random, 3), random_pair(random, 3)};
        const std::array<FingerVector, 2> velocity_rad_s = {random_pair(random, 20), random_pair(random, 20)};
        const FingerVectorOf<Pair> angles = in_lanes(angle_rad);
        const FingerEquationsOf<Pair> lanes =
            both.equations({sine_cosine(angles[0]), sine_cosine(angles[1])}, in_lanes(velocity_rad_s));
        for (int f = 0; f < 2; f++) {
            const FingerEquations alone =
                (f == 0 ? dynamics_ : other_dynamics).equations(sines_cosines(angle_rad[f]), velocity_rad_s[f]);
            ASSERT_EQ(lanes.mass.coupling[f], alone.mass.coupling);
            for (int j = 0; j < 2; j++) {
                ASSERT_EQ(lanes.mass.root[j][f], alone.mass.root[j]);
                ASSERT_EQ(lanes.mass.inverse_root[j][f], alone.mass.inverse_root[j]);
                ASSERT_EQ(lanes.resistance_nm[j][f], alone.resistance_nm[j]);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Sim, fast_stepper_dynamics, all_finger_cases(), name_of);

} // namespace
} // namespace twiddle::sim
