#include "finger_dynamics.hpp"

#include <LinearMath/btAlignedObjectArray.h>

#include <cmath>

namespace twiddle::sim
{

namespace
{

constexpr double turn_rad = SIMD_2_PI;
// More than the five constants of a series need, so that the fit averages rounding errors.
constexpr int series_samples = 8;
constexpr int bilinear_samples = 4;

// Bullet's multibody as a black box that answers torques with accelerations.
class Sampler
{
  public:
    Sampler(ArticulatedHand &hand, int first, int second, const btVector3 &gravity_m_s2)
        : body_(hand.body()), joint_{first, second}, gravity_m_s2_(gravity_m_s2)
    {
    }

    void set_angles(double first_rad, double second_rad)
    {
        body_.setJointPos(joint_[0], first_rad);
        body_.setJointPos(joint_[1], second_rad);
    }

    // m00, m01, m11 at the angles that were set.
    std::array<double, 3> mass()
    {
        articulated_body_algorithm(btVector3(0, 0, 0));
        const FingerVector a = response(0), b = response(1);
        const double determinant = a[0] * b[1] - a[1] * b[0];
        return {b[1] / determinant, -(a[1] + b[0]) / (2 * determinant), a[0] / determinant};
    }

    // The torques that the weight exerts, with the sign of the finger's resistance.
    FingerVector weight_nm()
    {
        articulated_body_algorithm(gravity_m_s2_);
        const FingerVector fall = {body_.getJointVel(joint_[0]), body_.getJointVel(joint_[1])};
        body_.clearVelocities();
        const auto m = mass();
        return {-(m[0] * fall[0] + m[1] * fall[1]), -(m[1] * fall[0] + m[2] * fall[1])};
    }

  private:
    // Accelerations of the whole body at rest, taken for 1 s; they also bring the body's caches to the
    // angles that were set.
    void articulated_body_algorithm(const btVector3 &acceleration_m_s2)
    {
        body_.clearForcesAndTorques();
        body_.clearVelocities();
        for (int link = 0; link < body_.getNumLinks(); link++)
            body_.addLinkForce(link, acceleration_m_s2 * body_.getLinkMass(link));
        body_.computeAccelerationsArticulatedBodyAlgorithmMultiDof(1, scalars_, vectors_, matrices_, false, false,
                                                                   false);
        body_.clearForcesAndTorques();
    }

    // Accelerations of the two joints under 1 N m on joint_[which].
    FingerVector response(int which)
    {
        btAlignedObjectArray<btScalar> torque, acceleration;
        torque.resize(6 + body_.getNumDofs(), 0); // Bullet's first six are the base's
        acceleration.resize(6 + body_.getNumDofs(), 0);
        torque[6 + joint_[which]] = 1;
        body_.calcAccelerationDeltasMultiDof(&torque[0], &acceleration[0], scalars_, vectors_);
        return {acceleration[6 + joint_[0]], acceleration[6 + joint_[1]]};
    }

    btMultiBody &body_;
    std::array<int, 2> joint_;
    btVector3 gravity_m_s2_;
    btAlignedObjectArray<btScalar> scalars_;
    btAlignedObjectArray<btVector3> vectors_;
    btAlignedObjectArray<btMatrix3x3> matrices_;
};

} // namespace

FingerDynamics::FingerDynamics(ArticulatedHand &hand, int first, int second, const btVector3 &gravity_palm_m_s2)
{
    double m11 = 0;
    Sampler sampler(hand, first, second, gravity_palm_m_s2);
    for (int i = 0; i < series_samples; i++) {
        const double angle_rad = turn_rad * i / series_samples;
        sampler.set_angles(0, angle_rad);
        const auto m = sampler.mass();
        for (int k = 0; k < 5; k++) {
            const int harmonic = (k + 1) / 2;
            const double wave = k % 2 == 0 && k > 0 ? std::sin(harmonic * angle_rad) : std::cos(harmonic * angle_rad);
            const double share = (k == 0 ? 1.0 : 2.0) / series_samples;
            constants_.m00[k] += share * wave * m[0];
            constants_.m01[k] += share * wave * m[1];
        }
        m11 += m[2] / series_samples;
    }
    constants_.inverse_m11 = 1 / m11;
    constants_.root_m11 = std::sqrt(m11);
    constants_.inverse_root_m11 = 1 / constants_.root_m11;
    for (int i = 0; i < bilinear_samples; i++) {
        for (int j = 0; j < bilinear_samples; j++) {
            const double u_rad = turn_rad * i / bilinear_samples, v_rad = turn_rad * j / bilinear_samples;
            sampler.set_angles(u_rad, v_rad);
            const FingerVector weight = sampler.weight_nm();
            const std::array<double, 3> u = {1, 2 * std::cos(u_rad), 2 * std::sin(u_rad)};
            const std::array<double, 3> v = {1, 2 * std::cos(v_rad), 2 * std::sin(v_rad)};
            constexpr double share = 1.0 / (bilinear_samples * bilinear_samples);
            for (int joint = 0; joint < 2; joint++)
                for (int a = 0; a < 3; a++)
                    for (int b = 0; b < 3; b++)
                        constants_.weight[joint][a][b] += share * u[a] * v[b] * weight[joint];
        }
    }
    hand.reset();
}

FingerConstants<Pair> in_lanes(const FingerConstants<double> &first, const FingerConstants<double> &second)
{
    FingerConstants<Pair> both;
    for (std::size_t k = 0; k < both.m00.size(); k++) {
        both.m00[k] = Pair{first.m00[k], second.m00[k]};
        both.m01[k] = Pair{first.m01[k], second.m01[k]};
    }
    both.inverse_m11 = Pair{first.inverse_m11, second.inverse_m11};
    both.root_m11 = Pair{first.root_m11, second.root_m11};
    both.inverse_root_m11 = Pair{first.inverse_root_m11, second.inverse_root_m11};
    for (int joint = 0; joint < 2; joint++)
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++)
                both.weight[joint][a][b] = Pair{first.weight[joint][a][b], second.weight[joint][a][b]};
    return both;
}

} // namespace twiddle::sim
