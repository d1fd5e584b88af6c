#include "experiment/controller_setup.hpp"
#include "experiment/models.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace
{

using namespace twiddle;
using namespace twiddle::experiment;

sim::Setup mid_a()
{
    return sim::load_setup(TWIDDLE_MODELS, "mid-a");
}

// Gains, ranges and limits of the default set-up reach the joints they are named for. Expected: the set-up's values, and the
// paper's joint ranges (FEI 0..90, AAI -15..15, FET 0..90, OT 0..130 deg).
TEST(ControllerSetup, settings_reach_their_joints)
{
    const twd_controller_config config = controller_config(mid_a(), find_model("cpg-h"), true);
    const double deg = 3.14159265358979 / 180;
    const std::array<std::array<double, 4>, 4> expected = {
        {{0, 90, 0.21, 0.0069}, {-15, 15, 0.32, 0.0107}, {0, 90, 0.21, 0.0069}, {0, 130, 0.37, 0.0122}}};
    ASSERT_EQ(config.joints, 4);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const twd_joint &joint = config.joint[i];
        EXPECT_NEAR(joint.lower_rad, expected[i][0] * deg, 1e-6) << i;
        EXPECT_NEAR(joint.upper_rad, expected[i][1] * deg, 1e-6) << i;
        EXPECT_NEAR(joint.pd.stiffness_nm_per_rad, expected[i][2], 1e-7) << i;
        EXPECT_NEAR(joint.pd.damping_nms_per_rad, expected[i][3], 1e-9) << i;
        EXPECT_NEAR(joint.pd.torque_limit_nm, 1, 1e-7) << i;
    }
    EXPECT_NEAR(config.tick_s, 0.01, 1e-9);
    EXPECT_NEAR(config.ranges.frequency_upper_hz, 1, 1e-7);
    EXPECT_NEAR(config.ranges.lone_frequency_hz, 0.84, 1e-7);
    EXPECT_EQ(config.phase_start, TWD_PHASE_START_AT_LAG);
    twd_controller controller;
    EXPECT_EQ(twd_controller_init(&controller, &config), TWD_OK);
}

// The chains' moving joints are the controller's: index AAI then FEI, thumb OT then FET, from the palm outwards.
TEST(ControllerSetup, chains_move_their_own_joints)
{
    const twd_controller_config config = controller_config(mid_a(), find_model("cpg-c"), true);
    ASSERT_EQ(config.fingers, 2);
    EXPECT_EQ(config.finger[0].joint[0], sim::aai);
    EXPECT_EQ(config.finger[0].joint[1], sim::fei);
    EXPECT_EQ(config.finger[1].joint[0], sim::ot);
    EXPECT_EQ(config.finger[1].joint[1], sim::fet);
    EXPECT_EQ(config.finger[0].gravity.moving, 2);
}

// Held distal joints change the gravity table: a bent finger's centre of mass lies elsewhere. Expected: another moment, same weight.
TEST(ControllerSetup, held_angles_reach_the_gravity_table)
{
    const auto bent_setup = sim::load_setup(TWIDDLE_MODELS, "mid-a", {{"hand.index_distal_deg", "20"}});
    const auto straight = controller_config(mid_a(), find_model("cpg-c"), true).finger[0].gravity;
    const auto bent = controller_config(bent_setup, find_model("cpg-c"), true).finger[0].gravity;
    EXPECT_NEAR(bent.joint[1].weight_n, straight.joint[1].weight_n, 1e-6);
    EXPECT_GT(std::abs(bent.joint[1].moment_nm[1] - straight.joint[1].moment_nm[1]), 1e-5);
}

// The squared norm of the learner's input is the set-up's 10 for each object. Expected: the setting, within the map's few per cent.
TEST(ControllerSetup, input_has_the_set_ups_norm)
{
    for (const std::string &name : sim::object_names(TWIDDLE_MODELS)) {
        const LearnerInput input = learner_input(sim::read_object(TWIDDLE_MODELS, name), mid_a().learner);
        const double squared_norm = std::inner_product(input.begin(), input.end(), input.begin(), 0.0);
        EXPECT_NEAR(squared_norm, 10, 0.5) << name;
    }
}

} // namespace
