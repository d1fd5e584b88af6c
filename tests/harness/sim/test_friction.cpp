// The contact solver against Coulomb's law: sliding friction opposes slip in every direction, and a block on an incline
// sticks and slides as in a textbook.
#include "sim/reference/cone_friction_solver.hpp"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>

namespace twiddle::sim
{

namespace
{

constexpr double substep_s = 0.002;
constexpr double friction = 0.5;
constexpr double pi = 3.14159265358979323846;

// A body that glides along x, y and z on three massive slides, over fixed ground whose surface is z = 0. The slides'
// masses make the effective masses along x and y differ, as a finger's do: (m_x + m_y + m) along x, (m_y + m) along y.
class SlidingWorld
{
  public:
    SlidingWorld(btMultiBodyConstraintSolver &solver, std::unique_ptr<btCollisionShape> shape, double height_m,
                 double slide_mass_kg, const btVector3 &gravity_m_s2)
        : dispatcher_(&configuration_), world_(&dispatcher_, &broadphase_, &solver, &configuration_),
          shape_(std::move(shape)), ground_shape_(btVector3(10, 10, 0.1)),
          ground_(0, 0, btVector3(0, 0, 0), true, false), body_(3, 0, btVector3(0, 0, 0), true, false),
          ground_collider_(&ground_, -1), body_collider_(&body_, 2)
    {
        world_.setGravity(gravity_m_s2);
        world_.getSolverInfo().m_numIterations = 1000;
        world_.getSolverInfo().m_leastSquaresResidualThreshold = 1e-24;
        world_.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
        ground_shape_.setMargin(0.001);

        ground_.setBasePos(btVector3(0, 0, -0.1));
        ground_.finalizeMultiDof();
        ground_collider_.setCollisionShape(&ground_shape_);
        ground_collider_.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, -0.1)));
        add(ground_, ground_collider_);
        ground_.setBaseCollider(&ground_collider_);

        const btVector3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        const double masses_kg[] = {slide_mass_kg, slide_mass_kg, 1};
        for (int i = 0; i < 3; i++) {
            body_.setupPrismatic(i, masses_kg[i], btVector3(1, 1, 1), i - 1, btQuaternion::getIdentity(), axes[i],
                                 btVector3(0, 0, 0), btVector3(0, 0, 0), true);
        }
        body_.finalizeMultiDof();
        body_.setLinearDamping(0);
        body_.setAngularDamping(0);
        body_.setJointPos(2, height_m);
        body_collider_.setCollisionShape(shape_.get());
        body_.getLink(2).m_collider = &body_collider_;
        add(body_, body_collider_);
        btAlignedObjectArray<btQuaternion> rotation;
        btAlignedObjectArray<btVector3> origin;
        body_.forwardKinematics(rotation, origin);
        body_.updateCollisionObjectWorldTransforms(rotation, origin);
    }

    void set_velocity_m_s(double x, double y)
    {
        body_.setJointVel(0, x);
        body_.setJointVel(1, y);
    }

    // One substep; returns the tangential impulses along x and y, N s, and leaves the normal impulse in normal_ns.
    std::array<double, 2> step(double slide_mass_kg, double &normal_ns)
    {
        const double before_x = body_.getJointVel(0), before_y = body_.getJointVel(1);
        const btVector3 gravity = world_.getGravity();
        world_.stepSimulation(substep_s, 0);
        normal_ns = 0;
        for (int m = 0; m < dispatcher_.getNumManifolds(); m++) {
            const btPersistentManifold *manifold = dispatcher_.getManifoldByIndexInternal(m);
            for (int c = 0; c < manifold->getNumContacts(); c++) {
                normal_ns += manifold->getContactPoint(c).getAppliedImpulse();
            }
        }
        const double mass_y_kg = 1 + slide_mass_kg, mass_x_kg = mass_y_kg + slide_mass_kg;
        return {mass_x_kg * (body_.getJointVel(0) - before_x - gravity.x() * substep_s),
                mass_y_kg * (body_.getJointVel(1) - before_y - gravity.y() * substep_s)};
    }

    std::array<double, 2> velocity_m_s() const
    {
        return {body_.getJointVel(0), body_.getJointVel(1)};
    }

  private:
    void add(btMultiBody &body, btMultiBodyLinkCollider &collider)
    {
        collider.setFriction(&collider == &ground_collider_ ? friction : 1);
        collider.setActivationState(DISABLE_DEACTIVATION);
        world_.addMultiBody(&body);
        world_.addCollisionObject(&collider, 1, 1);
    }

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadphase_;
    btMultiBodyDynamicsWorld world_;
    std::unique_ptr<btCollisionShape> shape_;
    btBoxShape ground_shape_;
    btMultiBody ground_;
    btMultiBody body_;
    btMultiBodyLinkCollider ground_collider_;
    btMultiBodyLinkCollider body_collider_;
};

// Sine of the angle between the friction impulse and the direction opposite to the slip that is left, largest over 17
// directions of slip. Coulomb's law says 0.
double worst_misalignment(btMultiBodyConstraintSolver &solver, double &worst_size)
{
    double worst = 0;
    worst_size = 0;
    for (int k = 0; k < 17; k++) {
        const double direction_rad = 2 * pi * k / 17;
        const double slide_mass_kg = 3;
        SlidingWorld sliding(solver, std::make_unique<btSphereShape>(0.05), 0.05, slide_mass_kg,
                             btVector3(0, 0, -9.81));
        sliding.set_velocity_m_s(std::cos(direction_rad), std::sin(direction_rad));
        double normal_ns = 0;
        const auto impulse_ns = sliding.step(slide_mass_kg, normal_ns);
        const auto slip_m_s = sliding.velocity_m_s();
        const double size_ns = std::hypot(impulse_ns[0], impulse_ns[1]);
        const double slip = std::hypot(slip_m_s[0], slip_m_s[1]);
        const double cross = impulse_ns[0] * slip_m_s[1] - impulse_ns[1] * slip_m_s[0];
        const double dot = impulse_ns[0] * slip_m_s[0] + impulse_ns[1] * slip_m_s[1];
        EXPECT_GT(normal_ns, 0);
        EXPECT_LT(dot, 0) << "direction " << k;
        worst = std::max(worst, std::abs(cross) / (size_ns * slip));
        worst_size = std::max(worst_size, std::abs(size_ns / (friction * normal_ns) - 1));
    }
    return worst;
}

// Speed after a second on a plane tilted by `angle_rad` about y, for a block that starts at rest.
double speed_after_one_second_m_s(double angle_rad)
{
    ConeFrictionSolver solver;
    auto block = std::make_unique<btBoxShape>(btVector3(0.05, 0.04, 0.03));
    block->setMargin(0.001);
    const btVector3 gravity_m_s2(9.81 * std::sin(angle_rad), 0, -9.81 * std::cos(angle_rad));
    SlidingWorld sliding(solver, std::move(block), 0.03, 0, gravity_m_s2);
    double normal_ns = 0;
    for (int i = 0; i < 500; i++)
        sliding.step(0, normal_ns);
    return sliding.velocity_m_s()[0];
}

} // namespace

// The friction of a sliding contact opposes its slip within 1e-3 and has Coulomb's size, in 17 directions, although the
// sliding body is 1.75 times heavier along x than along y. Expected: Coulomb's law.
TEST(Friction, opposes_slip_in_every_direction)
{
    ConeFrictionSolver repaired;
    double size_error = 0;
    EXPECT_LT(worst_misalignment(repaired, size_error), 1e-3);
    EXPECT_LT(size_error, 1e-3);

    btMultiBodyConstraintSolver stock;
    double stock_size_error = 0;
    const double stock_misalignment = worst_misalignment(stock, stock_size_error);
    std::printf("Bullet's own solver: misalignment %.3f, error of size %.3f\n", stock_misalignment, stock_size_error);
}

// A block stays below the friction angle atan(0.5) = 26.57 deg.
TEST(Friction, block_sticks_below_the_friction_angle)
{
    const double friction_angle_rad = std::atan(friction);
    for (const double share : {0.2, 0.5, 0.9, 0.99}) {
        EXPECT_LT(std::abs(speed_after_one_second_m_s(share * friction_angle_rad)), 1e-6) << "share " << share;
    }
}

// Above it, the block slides at g (sin a - mu cos a): after one second its speed is that number.
TEST(Friction, block_slides_above_the_friction_angle_at_the_closed_form_acceleration)
{
    for (const double angle_rad : {0.48, 0.6, 0.9, 1.2}) {
        const double expected_m_s = 9.81 * (std::sin(angle_rad) - friction * std::cos(angle_rad));
        EXPECT_NEAR(speed_after_one_second_m_s(angle_rad), expected_m_s, 1e-3 * expected_m_s) << angle_rad;
    }
}

} // namespace twiddle::sim
