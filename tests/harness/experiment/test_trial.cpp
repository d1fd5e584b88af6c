#include "experiment/training.hpp"
#include "experiment/trajectory.hpp"
#include "experiment/trial.hpp"
#include "sim/hand_model.hpp"

#include "setups.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{

using namespace twiddle;
using namespace twiddle::experiment;

TrialRunner runner(const std::string &object, const std::string &model, bool with_centre = true)
{
    return TrialRunner(TrialWorld(sim::Stepper::fast, sim::read_hand_model(TWIDDLE_MODELS "/icub_right_hand.urdf"),
                                  sim::read_object(TWIDDLE_MODELS, object), test::load_setup("mid-a"),
                                  sim::HandHold::welded),
                       engine::engine_of_number(TWIDDLE_NUMBER), model, with_centre);
}

engine::Parameters random_parameters(std::size_t count, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0.01, 0.99);
    engine::Parameters parameters;
    for (std::size_t i = 0; i < count; ++i) {
        parameters.push_back(uniform(random));
    }
    return parameters;
}

// A trial depends on its parameters alone, not on the trials before, to the last bit of every joint angle. Expected:
// the trial in a runner of its own.
TEST(Trial, trial_does_not_depend_on_earlier_ones)
{
    for (const char *object : {"small-sphere", "medium-cylinder", "large-cube"}) {
        TrialRunner used = runner(object, "cpg-c");
        for (unsigned seed = 1; seed <= 4; ++seed) {
            const engine::Parameters parameters = random_parameters(12, seed);
            TrialRunner fresh = runner(object, "cpg-c");
            const Trajectory expected = record_trajectory(fresh, parameters);
            const Trajectory found = record_trajectory(used, parameters);
            for (std::size_t i = 0; i < expected.rows.size(); ++i) {
                ASSERT_EQ(found.rows.at(i).observation.angle_rad, expected.rows[i].observation.angle_rad)
                    << object << ", seed " << seed << ", step " << i + 1;
            }
            EXPECT_EQ(found.result.rotation_rad, expected.result.rotation_rad) << object << ", seed " << seed;
        }
    }
}

// Watching a trial does not change it, and its record ends at the rotation that counts.
TEST(Trial, watched_trial_is_the_same)
{
    TrialRunner trials = runner("small-sphere", "cpg-h");
    const engine::Parameters parameters = random_parameters(22, 5);
    const double rotation_rad = trials.run(parameters).rotation_rad;
    const Trajectory trajectory = record_trajectory(trials, parameters);
    EXPECT_EQ(trajectory.result.rotation_rad, rotation_rad);
    ASSERT_EQ(trajectory.rows.size(), 300U);
    EXPECT_EQ(trajectory.rows.back().observation.object_rad, rotation_rad);
    EXPECT_EQ(trajectory.rows.front().sample.step, 1);
}

// Desired angles stay in the paper's joint ranges and torques in the limit of 1 N m; the desired angle of AAI starts at
// its middle. Expected: ranges in degrees as the paper prints them.
TEST(Trial, commands_stay_in_range)
{
    TrialRunner trials = runner("large-cylinder", "cpg-c");
    const Trajectory trajectory = record_trajectory(trials, random_parameters(12, 6));
    const double deg = 3.14159265358979 / 180;
    const JointVector lower_deg = {0, -15, 0, 0};
    const JointVector upper_deg = {90, 15, 90, 130};
    for (const TrajectoryRow &row : trajectory.rows) {
        for (std::size_t i = 0; i < joint_count; ++i) {
            EXPECT_GE(row.sample.desired_rad[i], lower_deg[i] * deg - 1e-6);
            EXPECT_LE(row.sample.desired_rad[i], upper_deg[i] * deg + 1e-6);
            EXPECT_LE(std::abs(row.sample.torque_nm[i]), 1);
        }
        EXPECT_GE(row.observation.finger_clearance_m, trajectory.min_finger_clearance_m);
    }
    EXPECT_NEAR(trajectory.rows.front().sample.desired_rad[aai], 0, 1 * deg);
}

// CPG-S drives all joints by one oscillator: without centre, all desired angles are the same fraction of their ranges.
TEST(Trial, one_oscillator_moves_all_joints_alike)
{
    TrialRunner trials = runner("small-cube", "cpg-s", false);
    const Trajectory trajectory = record_trajectory(trials, {0.4});
    const double deg = 3.14159265358979 / 180;
    for (const TrajectoryRow &row : trajectory.rows) {
        const double fraction = row.sample.desired_rad[fei] / (90 * deg);
        EXPECT_NEAR(row.sample.desired_rad[aai], (-15 + 30 * fraction) * deg, 1e-5);
        EXPECT_NEAR(row.sample.desired_rad[fet], 90 * deg * fraction, 1e-5);
        EXPECT_NEAR(row.sample.desired_rad[ot], 130 * deg * fraction, 1e-5);
    }
}

// engine::Parameters that are too few or out of [0, 1] are refused before anything moves.
TEST(Trial, wrong_parameters_are_refused)
{
    TrialRunner trials = runner("small-sphere", "cpg-s");
    EXPECT_THROW(trials.run({0.5}), std::invalid_argument);
    EXPECT_THROW(trials.run({0.5, 1.5}), std::invalid_argument);
    EXPECT_THROW(trials.run({0.5, std::numeric_limits<double>::quiet_NaN()}), std::invalid_argument);
}

// A state that is not a number, or out of all proportion, is a fault; the ends of the joints' ranges are not.
TEST(Trial, impossible_states_are_told_from_possible_ones)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    const JointVector rest{};
    EXPECT_TRUE(is_possible({1.57, -0.26, 1.57, 2.27}, {100, -100, 0, 0}, -30));
    for (const double bad : {nan, infinite, -infinite}) {
        EXPECT_FALSE(is_possible({0, 0, bad, 0}, rest, 0));
        EXPECT_FALSE(is_possible(rest, {bad, 0, 0, 0}, 0));
        EXPECT_FALSE(is_possible(rest, rest, bad));
    }
    EXPECT_FALSE(is_possible({0, 100, 0, 0}, rest, 0));
    EXPECT_FALSE(is_possible(rest, rest, 1e6));
}

} // namespace
