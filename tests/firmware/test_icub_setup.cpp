// The constants that images are made with (firmware/support/icub_setup.h) are the set-up `paper` as the harness reads
// it.
extern "C" {
#include "icub_setup.h"
}

#include "engine/controller_setup.hpp"

#include <twiddle/convert.h>

#include "setups.hpp"

#include <gtest/gtest.h>

namespace
{

using namespace twiddle;
namespace library = twiddle::engine::TWD_BUILD_NAMESPACE;

// Constants are written with seven digits.
void expect_close(twd_num ours, twd_num theirs, const char *what)
{
    EXPECT_NEAR(twd_num_to_double(ours), twd_num_to_double(theirs), 1e-7) << what;
}

void expect_equal(const twd_gravity &ours, const twd_gravity &theirs)
{
    ASSERT_EQ(ours.moving, theirs.moving);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            expect_close(ours.pair_energy_j[i][j], theirs.pair_energy_j[i][j], "energy");
        }
    }
}

// Every setting, and the gravity of both fingers as init made it of their held joints.
TEST(IcubSetup, controller_is_the_papers)
{
    const settings::Setup setup = test::load_setup("paper");
    const twd_controller_config theirs = library::controller_config({setup, "cpg-h", true});
    twd_controller_config ours;
    ASSERT_EQ(icub_controller_config(&ours), TWD_OK);

    EXPECT_EQ(ours.model, theirs.model);
    EXPECT_EQ(ours.oscillators.with_centre, theirs.oscillators.with_centre);
    EXPECT_EQ(ours.oscillators.tick_s, theirs.oscillators.tick_s);
    EXPECT_EQ(ours.oscillators.amplitude_rate_per_s, theirs.oscillators.amplitude_rate_per_s);
    EXPECT_EQ(ours.oscillators.centre_rate_per_s, theirs.oscillators.centre_rate_per_s);
    EXPECT_EQ(ours.oscillators.return_lag, theirs.oscillators.return_lag);
    EXPECT_EQ(ours.oscillators.centre_start, theirs.oscillators.centre_start);
    EXPECT_EQ(ours.phase_start, theirs.phase_start);
    EXPECT_EQ(ours.saturation, theirs.saturation);
    expect_close(ours.ranges.frequency_lower_hz, theirs.ranges.frequency_lower_hz, "lower frequency");
    expect_close(ours.ranges.frequency_upper_hz, theirs.ranges.frequency_upper_hz, "upper frequency");
    expect_close(ours.ranges.lone_frequency_hz, theirs.ranges.lone_frequency_hz, "lone frequency");
    expect_close(ours.ranges.amplitude_upper, theirs.ranges.amplitude_upper, "amplitude");
    expect_close(ours.ranges.centre_lower, theirs.ranges.centre_lower, "lower centre");
    expect_close(ours.ranges.centre_upper, theirs.ranges.centre_upper, "upper centre");
    ASSERT_EQ(ours.joints, theirs.joints);
    for (int i = 0; i < ours.joints; ++i) {
        expect_close(ours.joint[i].range.lower_rad, theirs.joint[i].range.lower_rad, "lower angle");
        expect_close(ours.joint[i].range.upper_rad, theirs.joint[i].range.upper_rad, "upper angle");
        expect_close(ours.joint[i].pd.stiffness_nm_per_rad, theirs.joint[i].pd.stiffness_nm_per_rad, "stiffness");
        expect_close(ours.joint[i].pd.damping_nms_per_rad, theirs.joint[i].pd.damping_nms_per_rad, "damping");
        expect_close(ours.joint[i].pd.torque_limit_nm, theirs.joint[i].pd.torque_limit_nm, "torque limit");
    }
    ASSERT_EQ(ours.fingers, theirs.fingers);
    for (int i = 0; i < ours.fingers; ++i) {
        EXPECT_EQ(ours.finger[i].joint[0], theirs.finger[i].joint[0]);
        EXPECT_EQ(ours.finger[i].joint[1], theirs.finger[i].joint[1]);
        expect_equal(ours.finger[i].gravity, theirs.finger[i].gravity);
    }
}

TEST(IcubSetup, learner_is_the_papers)
{
    const settings::Setup setup = test::load_setup("paper");
    const twd_learner_config theirs = library::learner_config({{setup, "cpg-h", true}, 40, 7});
    const twd_learner_config ours = icub_learner_config(40, 7);

    EXPECT_EQ(ours.units, theirs.units);
    EXPECT_EQ(ours.inputs, theirs.inputs);
    expect_close(ours.actor_rate, theirs.actor_rate, "actor rate");
    expect_close(ours.critic_rate, theirs.critic_rate, "critic rate");
    expect_close(ours.weight_range, theirs.weight_range, "weight range");
    expect_close(ours.clip, theirs.clip, "clip");
    expect_close(ours.noise.start, theirs.noise.start, "noise at the start");
    expect_close(ours.noise.end, theirs.noise.end, "noise at the end");
    expect_close(ours.noise.decay_fraction, theirs.noise.decay_fraction, "decay");
    EXPECT_EQ(ours.noise.trials, theirs.noise.trials);
    EXPECT_EQ(ours.silent_units, theirs.silent_units);
    EXPECT_EQ(ours.learned_value, theirs.learned_value);
    EXPECT_EQ(ours.seed, theirs.seed);

    twd_num input[TWD_INPUTS];
    icub_small_sphere(input);
    const engine::LearnerInput sphere =
        library::learner_input(sim::read_object(TWIDDLE_MODELS, "small-sphere"), setup.learner);
    for (std::size_t i = 0; i < sphere.size(); ++i) {
        expect_close(input[i], twd_num_from_double(sphere[i]), "input");
    }
}

} // namespace
