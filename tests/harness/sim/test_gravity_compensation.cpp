// The controller's gravity torque (controller/gravity.h) against Bullet's inverse dynamics, and holding
// the Bullet hand.
#include "bullet_inverse_dynamics.hpp"
#include "fixtures.hpp"

#include "engine/controller_setup.hpp"
#include "sim/object.hpp"
#include "sim/world.hpp"

#include "setups.hpp"

#include <twiddle/convert.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace twiddle
{
namespace
{

namespace id = btInverseDynamicsBullet3;

constexpr double deg = M_PI / 180;

// The finger `name` of the hand's URDF as a tree of Bullet's inverse dynamics, in the `hand` frame: its first two
// joints move, the other two are rigid at `held_rad`. The drives' reflected inertia has no weight and stays out.
void build_finger(id::MultiBodyTree &tree, const sim::HandModel &model, const std::string &name, double held_rad,
                  const btVector3 &gravity_m_s2)
{
    for (int i = 0; i < 4; ++i) {
        const sim::HandLink &link = model.links[model.link_of_joint(name + "_" + std::to_string(i))];
        const bool moves = i < 2;
        const btMatrix3x3 turn(btQuaternion(btVector3(0, 0, 1), moves ? 0 : held_rad));
        const btMatrix3x3 rotation_parent_body = link.X_parent_joint.getBasis() * turn;
        const btVector3 &c = link.p_link_com_m;
        btMatrix3x3 inertia = link.inertia_kg_m2;
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                inertia[row][column] += link.mass_kg * ((row == column ? c.length2() : 0) - c[row] * c[column]);
        }
        ASSERT_EQ(tree.addBody(i, i - 1, moves ? id::REVOLUTE : id::FIXED, id::vec3(link.X_parent_joint.getOrigin()),
                               id::mat33(rotation_parent_body.transpose()), id::vec3(btVector3(0, 0, 1)), link.mass_kg,
                               id::vec3(c), id::mat33(inertia), 0, nullptr),
                  0);
    }
    ASSERT_EQ(tree.finalize(), 0);
    ASSERT_EQ(tree.setGravityInWorldFrame(id::vec3(gravity_m_s2)), 0);
}

struct FingerCase {
    const char *name;
    int finger; // index into twd_controller_config::finger
    double held_deg;
};

void PrintTo(const FingerCase &finger, std::ostream *stream)
{
    *stream << finger.name << " with its distal joints at " << finger.held_deg << " deg";
}

class GravityTorque : public testing::TestWithParam<FingerCase>
{
};

// Expected: Bullet's inverse dynamics of a motionless finger, at 200 random postures, within 1e-6 N m. The finger's
// weight makes torques up to 6e-3 N m.
TEST_P(GravityTorque, equals_bullets_inverse_dynamics)
{
    const auto [name, finger, held_deg] = GetParam();
    const std::string held = std::to_string(held_deg);
    const settings::Setup setup =
        sim::default_setup({{"hand.index_distal_deg", held}, {"hand.thumb_distal_deg", held}});
    const twd_controller_config config = engine::TWD_BUILD_NAMESPACE::controller_config({setup, "cpg-c", true});
    const sim::HandModel model = sim::icub_hand();
    const auto &direction = setup.physics.gravity_direction;
    id::MultiBodyTree tree;
    build_finger(tree, model, name, held_deg * deg,
                 btVector3(direction[0], direction[1], direction[2]) * setup.physics.gravity_m_s2);

    constexpr unsigned seed = 3;
    std::mt19937_64 random(seed);
    double largest_nm = 0, difference_nm = 0;
    for (int trial = 0; trial < 200; ++trial) {
        std::array<twd_num, 2> angle_rad{}, torque_nm{};
        id::vecx q(2), torques(2);
        const id::vecx rest(2);
        for (int i = 0; i < 2; ++i) {
            const sim::HandLink &link = model.links[model.link_of_joint(std::string(name) + "_" + std::to_string(i))];
            angle_rad[i] =
                twd_num_from_double(std::uniform_real_distribution<double>(link.lower_rad, link.upper_rad)(random));
            q[i] = twd_num_to_double(angle_rad[i]);
        }
        ASSERT_EQ(tree.calculateInverseDynamics(q, rest, rest, &torques), 0);
        twd_gravity_torque(&config.finger[finger].gravity, angle_rad.data(), torque_nm.data());
        for (int i = 0; i < 2; ++i) {
            largest_nm = std::max(largest_nm, std::abs(torques[i]));
            difference_nm = std::max(difference_nm, std::abs(twd_num_to_double(torque_nm[i]) - torques[i]));
        }
    }
    std::printf("seed %u: torques up to %.2e N m, largest difference %.1e N m\n", seed, largest_nm, difference_nm);
    EXPECT_GT(largest_nm, 1e-3);
    EXPECT_LE(difference_nm, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Sim, GravityTorque,
                         testing::Values(FingerCase{"index", 0, 0}, FingerCase{"index", 0, 20},
                                         FingerCase{"thumb", 1, 0}, FingerCase{"thumb", 1, 20}),
                         [](const auto &finger) {
                             return std::string(finger.param.name) + "_at_" +
                                    std::to_string(static_cast<int>(finger.param.held_deg)) + "_deg";
                         });

// A world without anything in the fingers' way, and the controller that holds its hand.
class GravityHold : public testing::TestWithParam<std::tuple<sim::Stepper, const char *>>
{
  protected:
    GravityHold()
        : setup_(test::load_setup(std::get<1>(GetParam()), {{"object.hinge_x_m", "-0.2"}})),
          world_(sim::make_world(std::get<0>(GetParam()), sim::icub_hand(),
                                 sim::read_object(TWIDDLE_MODELS, "small-sphere"), setup_, sim::HandHold::welded))
    {
        const twd_controller_config config = engine::TWD_BUILD_NAMESPACE::controller_config({setup_, "cpg-c", true});
        EXPECT_EQ(twd_controller_init(&controller_, &config), TWD_OK);
    }

    // One second under the PD law with gravity torque, towards `desired_rad`.
    void drive_to(const JointVector &desired_rad)
    {
        for (int i = 0; i < substeps_in_a_second(); ++i) {
            world_->substep(torque_nm(desired_rad, world_->angles_rad(), world_->velocities_rad_s()));
        }
    }

    // One second in which the desired angles and velocities are the actual ones, so that the gravity torque alone acts,
    // times `share`. Returns how far a joint went.
    double drift_rad(double share)
    {
        const JointVector start_rad = world_->angles_rad();
        const JointVector at_rest{};
        double drift = 0;
        for (int i = 0; i < substeps_in_a_second(); ++i) {
            JointVector applied_nm = torque_nm(world_->angles_rad(), world_->angles_rad(), at_rest);
            for (double &torque : applied_nm)
                torque *= share;
            world_->substep(applied_nm);
            for (std::size_t j = 0; j < joint_count; ++j)
                drift = std::max(drift, std::abs(world_->angles_rad()[j] - start_rad[j]));
        }
        return drift;
    }

    const JointVector posture_rad_ = {60 * deg, 5 * deg, 50 * deg, 70 * deg}; // away from all stops

  private:
    // The library's torques.
    JointVector torque_nm(const JointVector &desired_rad, const JointVector &angle_rad,
                          const JointVector &velocity_rad_s)
    {
        std::array<twd_num, joint_count> desired{}, angle{}, torque{};
        std::array<twd_rate, joint_count> velocity{};
        std::transform(desired_rad.begin(), desired_rad.end(), desired.begin(), twd_num_from_double);
        std::transform(angle_rad.begin(), angle_rad.end(), angle.begin(), twd_num_from_double);
        std::transform(velocity_rad_s.begin(), velocity_rad_s.end(), velocity.begin(), twd_rate_from_double);
        twd_controller_torque(&controller_, desired.data(), angle.data(), velocity.data(), torque.data());
        JointVector in_nm{};
        std::transform(torque.begin(), torque.end(), in_nm.begin(), twd_num_to_double);
        return in_nm;
    }

    int substeps_in_a_second() const
    {
        return 100 * world_->substeps_per_step();
    }

    settings::Setup setup_;
    std::unique_ptr<sim::World> world_;
    twd_controller controller_{};
};

// Expected: no motion, since the gravity torque balances the weight; without it the fingers must fall, or the test has
// no power.
TEST_P(GravityHold, the_hand_stays_where_the_gravity_torque_alone_holds_it)
{
    drive_to(posture_rad_);
    const double held_rad = drift_rad(1);
    drive_to(posture_rad_);
    const double falling_rad = drift_rad(0);
    std::printf("drift in 1 s: %.1e rad held, %.2f rad without\n", held_rad, falling_rad);
    EXPECT_LT(held_rad, 1e-3);
    EXPECT_GT(falling_rad, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Sim, GravityHold,
                         testing::Combine(testing::Values(sim::Stepper::reference, sim::Stepper::fast),
                                          testing::Values("mid-a", "mid-b", "near")),
                         [](const auto &world) {
                             std::string name = std::get<1>(world.param);
                             std::replace(name.begin(), name.end(), '-', '_'); // GoogleTest's names have no hyphens
                             return name + (std::get<0>(world.param) == sim::Stepper::fast ? "_fast_stepper" : "");
                         });

} // namespace
} // namespace twiddle
