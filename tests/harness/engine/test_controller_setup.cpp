#include "engine/controller_setup.hpp"

#include "setups.hpp"

#include <twiddle/convert.h>

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

namespace
{

using namespace twiddle;
using namespace twiddle::engine;
using namespace twiddle::engine::TWD_BUILD_NAMESPACE;

// Half a step of a fixed-point number.
constexpr double rounding = std::is_floating_point_v<twd_num> ? 1e-9 : 1.9e-9;

settings::Setup mid_a()
{
    return test::load_setup("mid-a");
}

// Gains, ranges and limits of the default set-up reach the joints they are named for. Expected: the set-up's values,
// and the paper's joint ranges (FEI 0..90, AAI -15..15, FET 0..90, OT 0..130 deg).
TEST(ControllerSetup, settings_reach_their_joints)
{
    const twd_controller_config config = controller_config({mid_a(), "cpg-h", true});
    const double deg = 3.14159265358979 / 180;
    const std::array<std::array<double, 4>, 4> expected = {
        {{0, 90, 0.21, 0.0069}, {-15, 15, 0.32, 0.0107}, {0, 90, 0.21, 0.0069}, {0, 130, 0.37, 0.0122}}};
    ASSERT_EQ(config.joints, 4);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const twd_joint &joint = config.joint[i];
        EXPECT_NEAR(twd_num_to_double(joint.range.lower_rad), expected[i][0] * deg, 1e-6) << i;
        EXPECT_NEAR(twd_num_to_double(joint.range.upper_rad), expected[i][1] * deg, 1e-6) << i;
        EXPECT_NEAR(twd_num_to_double(joint.pd.stiffness_nm_per_rad), expected[i][2], 1e-7) << i;
        EXPECT_NEAR(twd_num_to_double(joint.pd.damping_nms_per_rad), expected[i][3], rounding) << i;
        EXPECT_NEAR(twd_num_to_double(joint.pd.torque_limit_nm), 1, 1e-7) << i;
    }
    EXPECT_NEAR(twd_small_to_double(config.oscillators.tick_s), 0.01, 1e-9);
    EXPECT_NEAR(twd_num_to_double(config.ranges.frequency_upper_hz), 1, 1e-7);
    EXPECT_NEAR(twd_num_to_double(config.ranges.lone_frequency_hz), 0.84, 1e-7);
    EXPECT_EQ(config.phase_start, TWD_PHASE_START_AT_LAG);
    twd_controller controller;
    EXPECT_EQ(twd_controller_init(&controller, &config), TWD_OK);
}

// What the paper leaves open reaches the library: each default, and each other value by its word.
TEST(ControllerSetup, open_choices_reach_the_library)
{
    const twd_controller_config plain = controller_config({mid_a(), "cpg-h", true});
    EXPECT_EQ(plain.oscillators.return_lag, TWD_RETURN_LAG_NEGATED);
    EXPECT_EQ(plain.oscillators.centre_start, TWD_CENTRE_START_AT_TOPOLOGY);
    EXPECT_EQ(plain.saturation, TWD_SATURATE_SUM);
    const auto changed = [](const char *setting, const char *value) {
        const settings::Setup setup = test::load_setup("mid-a", {{setting, value}});
        return controller_config({setup, "cpg-h", true});
    };
    EXPECT_EQ(changed("oscillators.return_lag", "equal").oscillators.return_lag, TWD_RETURN_LAG_EQUAL);
    EXPECT_EQ(changed("oscillators.centre_start", "zero").oscillators.centre_start, TWD_CENTRE_START_AT_ZERO);
    EXPECT_EQ(changed("oscillators.centre_start", "target").oscillators.centre_start, TWD_CENTRE_START_AT_TARGET);
    EXPECT_EQ(changed("oscillators.phase_start", "zero").phase_start, TWD_PHASE_START_AT_ZERO);
    EXPECT_EQ(changed("oscillators.saturation", "each").saturation, TWD_SATURATE_EACH);
}

// Without noise on the selector, its three units are silent; a model without selector has none.
TEST(ControllerSetup, open_choices_reach_the_learner)
{
    const settings::Setup plain = mid_a();
    EXPECT_EQ(learner_config({{plain, "cpg-h", true}, 10, 1}).silent_units, 0U);
    EXPECT_EQ(learner_config({{plain, "cpg-h", true}, 10, 1}).learned_value, TWD_LEARN_FROM_CLIPPED);
    const settings::Setup changed =
        test::load_setup("mid-a", {{"learner.selector_noise", "none"}, {"learner.learned_value", "unclipped"}});
    EXPECT_EQ(learner_config({{changed, "cpg-h", true}, 10, 1}).silent_units, 3U);
    EXPECT_EQ(learner_config({{changed, "cpg-c", true}, 10, 1}).silent_units, 0U);
    EXPECT_EQ(learner_config({{changed, "cpg-h", true}, 10, 1}).learned_value, TWD_LEARN_FROM_UNCLIPPED);
}

// The stable PD law is told each joint's inertia and the substep, and leaves ranges and limit alone. Expected: Kp / D
// and (Kd + h Kp) / D with D = 1 + h (Kd + h Kp) / M, from the settings, in double.
TEST(ControllerSetup, stable_pd_law_takes_its_period_from_the_substeps)
{
    for (const int substeps : {2, 5}) {
        const settings::Setup setup =
            test::load_setup("mid-a", {{"hand.pd_law", "stable"},
                                       {"hand.pd_inertia_kg_m2", "{ fei = 4e-5, aai = 5e-5, fet = 6e-5, ot = 7e-5 }"},
                                       {"physics.substeps", std::to_string(substeps)}});
        const twd_controller_config plain = controller_config({mid_a(), "cpg-c", true});
        const twd_controller_config stable = controller_config({setup, "cpg-c", true});
        const double h = 0.01 / substeps;
        const std::array<double, 4> inertia_kg_m2 = {4e-5, 5e-5, 6e-5, 7e-5};
        for (std::size_t i = 0; i < inertia_kg_m2.size(); ++i) {
            const double kp = setup.hand.stiffness_nm_per_rad[i], kd = setup.hand.damping_nms_per_rad[i];
            const double divisor = 1 + h * (kd + h * kp) / inertia_kg_m2[i];
            EXPECT_NEAR(twd_num_to_double(stable.joint[i].pd.stiffness_nm_per_rad), kp / divisor, 1e-6) << i;
            EXPECT_NEAR(twd_num_to_double(stable.joint[i].pd.damping_nms_per_rad), (kd + h * kp) / divisor, 1e-8) << i;
            EXPECT_EQ(stable.joint[i].pd.torque_limit_nm, plain.joint[i].pd.torque_limit_nm) << i;
            EXPECT_EQ(stable.joint[i].range.upper_rad, plain.joint[i].range.upper_rad) << i;
        }
    }
}

// The chains' moving joints are the controller's: index AAI then FEI, thumb OT then FET, from the palm outwards.
TEST(ControllerSetup, chains_move_their_own_joints)
{
    const twd_controller_config config = controller_config({mid_a(), "cpg-c", true});
    ASSERT_EQ(config.fingers, 2);
    EXPECT_EQ(config.finger[0].joint[0], aai);
    EXPECT_EQ(config.finger[0].joint[1], fei);
    EXPECT_EQ(config.finger[1].joint[0], ot);
    EXPECT_EQ(config.finger[1].joint[1], fet);
    EXPECT_EQ(config.finger[0].gravity.moving, 2);
}

// Held distal joints change the gravity table: a bent finger's centre of mass lies elsewhere. Expected: another moment
// of the last moving link; the same of the first, which carries the same weight at the same joint.
TEST(ControllerSetup, held_angles_reach_the_gravity_table)
{
    const auto bent_setup = test::load_setup("mid-a", {{"hand.index_distal_deg", "20"}});
    const auto straight = controller_config({mid_a(), "cpg-c", true}).finger[0].gravity;
    const auto bent = controller_config({bent_setup, "cpg-c", true}).finger[0].gravity;
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_EQ(bent.joint[0].moment_nm[axis], straight.joint[0].moment_nm[axis]) << axis;
    const twd_num change_nm = bent.joint[1].moment_nm[1] - straight.joint[1].moment_nm[1];
    EXPECT_GT(std::abs(twd_num_to_double(change_nm)), 1e-5);
}

// The squared norm of the learner's input is the set-up's 10 for each object. Expected: the setting, within the
// map's few per cent.
TEST(ControllerSetup, input_has_the_set_ups_norm)
{
    for (const std::string &name : sim::object_names(TWIDDLE_MODELS)) {
        const LearnerInput input = learner_input(sim::read_object(TWIDDLE_MODELS, name), mid_a().learner);
        double squared_norm = 0;
        for (const double response : input)
            squared_norm += std::pow(response, 2);
        EXPECT_NEAR(squared_norm, 10, 0.5) << name;
    }
}

} // namespace
