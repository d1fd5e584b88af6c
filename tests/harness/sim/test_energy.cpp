// Energy of the hand as Bullet integrates it, summed up here from joint angles and velocities alone.
#include "fixtures.hpp"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace twiddle::sim
{
namespace
{

const btVector3 gravity_m_s2(9.81, 0, 0); // along the straight fingers, as in the world

constexpr double default_step_s = 2e-3; // 5 substeps of a control step

// A hand that nothing drives, stops or brakes. It starts at rest with all joints in the middle of their ranges.
class FreeHand
{
  public:
    FreeHand(HandHold hold, bool runge_kutta)
        : setup_(default_setup()), hand_(icub_hand(), setup_.hand, hold), dispatcher_(&configuration_),
          world_(&dispatcher_, &broadphase_, &solver_, &configuration_)
    {
        world_.setGravity(gravity_m_s2);
        world_.addMultiBody(&hand_.body());
        for (std::size_t i = 0; i < hand_.links().size(); ++i)
            world_.addCollisionObject(&hand_.collider(static_cast<int>(i)), 0, 0); // meets nothing
        hand_.body().useRK4Integration(runge_kutta);
        std::vector<double> middle_rad;
        for (const ArticulatedLink &link : hand_.links()) {
            const HandLink &model = hand_.model().links[link.model_link];
            if (link.moves) middle_rad.push_back((model.lower_rad + model.upper_rad) / 2);
        }
        hand_.set_posture(middle_rad);
    }

    void step(double step_s)
    {
        world_.stepSimulation(step_s, 0);
        hand_.place_colliders(); // and the links' frames
    }

    // Kinetic energy: translation and turning of every link, its velocities propagated from joint to joint. The
    // drive's reflected inertia counts as part of its link.
    double kinetic_j() const;
    double potential_j() const;

  private:
    settings::Setup setup_;
    ArticulatedHand hand_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadphase_;
    btMultiBodyConstraintSolver solver_;
    btMultiBodyDynamicsWorld world_;
};

double FreeHand::kinetic_j() const
{
    const HandModel &model = hand_.model();
    std::vector<btVector3> turning_rad_s(model.links.size()), velocity_m_s(model.links.size()),
        origin_m(model.links.size());
    double sum_j = 0;
    for (int i = 0; i < static_cast<int>(hand_.links().size()); ++i) {
        const int at = hand_.links()[i].model_link;
        const HandLink &link = model.links[at];
        const btTransform X_palm_link = hand_.X_palm_link(i);
        origin_m[at] = X_palm_link.getOrigin();
        turning_rad_s[at] = velocity_m_s[at] = btVector3(0, 0, 0);
        if (link.parent >= 0) {
            turning_rad_s[at] = turning_rad_s[link.parent];
            velocity_m_s[at] =
                velocity_m_s[link.parent] + turning_rad_s[link.parent].cross(origin_m[at] - origin_m[link.parent]);
        }
        if (hand_.links()[i].moves)
            turning_rad_s[at] +=
                X_palm_link.getBasis().getColumn(2) * hand_.body().getJointVel(hand_.links()[i].body_link);

        btMatrix3x3 inertia_kg_m2 = link.inertia_kg_m2;
        inertia_kg_m2[2][2] += setup_.hand.reflected_inertia_kg_m2;
        const btVector3 to_com_m = X_palm_link.getBasis() * link.p_link_com_m;
        const btVector3 com_m_s = velocity_m_s[at] + turning_rad_s[at].cross(to_com_m);
        const btVector3 turning_link_rad_s = X_palm_link.getBasis().transpose() * turning_rad_s[at];
        sum_j += link.mass_kg * com_m_s.length2() / 2 + turning_link_rad_s.dot(inertia_kg_m2 * turning_link_rad_s) / 2;
    }
    return sum_j;
}

double FreeHand::potential_j() const
{
    double sum_j = 0;
    for (int i = 0; i < static_cast<int>(hand_.links().size()); ++i) {
        const HandLink &link = hand_.model().links[hand_.links()[i].model_link];
        sum_j -= link.mass_kg * gravity_m_s2.dot(hand_.X_palm_link(i) * link.p_link_com_m);
    }
    return sum_j;
}

// How far the total energy leaves its first value within 3 s, as a share of the largest kinetic energy on the way.
double largest_drift(HandHold hold, bool runge_kutta, double step_s)
{
    FreeHand hand(hold, runge_kutta);
    const double start_j = hand.kinetic_j() + hand.potential_j();
    double largest_j = 0, largest_kinetic_j = 0;
    const int steps = static_cast<int>(std::lround(3 / step_s));
    for (int i = 0; i < steps; ++i) {
        hand.step(step_s);
        const double kinetic_j = hand.kinetic_j();
        largest_kinetic_j = std::max(largest_kinetic_j, kinetic_j);
        largest_j = std::max(largest_j, std::abs(kinetic_j + hand.potential_j() - start_j));
    }
    std::printf("%s, steps of %.1f ms: drift %.2g %% of the largest kinetic energy, %.3f mJ\n",
                runge_kutta ? "Runge-Kutta" : "semi-implicit Euler", 1e3 * step_s, 100 * largest_j / largest_kinetic_j,
                1e3 * largest_kinetic_j);
    return largest_j / largest_kinetic_j;
}

class Energy : public testing::TestWithParam<HandHold>
{
};

// Expected: conservation. A fourth-order step leaves the drift to the multibody's equations of motion alone: wrong
// masses, inertias, gyroscopic or Coriolis terms, or a damping that was left on, would show.
TEST_P(Energy, of_the_free_hand_is_conserved_by_its_equations_of_motion)
{
    EXPECT_LE(largest_drift(GetParam(), true, 1e-4), 1e-6);
}

// Expected: the error of a first-order method, which the world's semi-implicit Euler is: its velocity-dependent forces
// are those of the step before, so that the energy grows in proportion to the step.
TEST_P(Energy, of_the_free_hand_drifts_in_proportion_to_the_worlds_step)
{
    largest_drift(GetParam(), false, default_step_s);
    const double coarse = largest_drift(GetParam(), false, 2e-4);
    const double fine = largest_drift(GetParam(), false, 1e-4);
    EXPECT_LE(fine, 3e-3);
    EXPECT_NEAR(coarse / fine, 2, 0.2);
}

INSTANTIATE_TEST_SUITE_P(Sim, Energy, testing::Values(HandHold::welded, HandHold::full),
                         [](const auto &hold) { return hold.param == HandHold::full ? "full" : "welded"; });

} // namespace
} // namespace twiddle::sim
