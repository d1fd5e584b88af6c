// A run's exported header against the run itself: what the library makes of the constants is what the program had in
// memory.
#include "exported.h"

#include "engine/controller_setup.hpp"
#include "engine/library_models.hpp"
#include "engine/library_numbers.hpp"
#include "record/csv_columns.hpp"
#include "record/policy_json.hpp"
#include "record/run_json.hpp"
#include "settings/joints.hpp"

#include <twiddle/convert.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace
{

using namespace twiddle;
using namespace twiddle::engine;
using namespace twiddle::engine::TWD_BUILD_NAMESPACE;

const std::filesystem::path runs = TWIDDLE_RUNS;

bool is_of_this_build(const exported &run)
{
    return std::string(run.number) == TWD_NUMBER_NAME;
}

// All runs, and those that were trained by this build's library.
std::vector<exported> all_runs()
{
    std::vector<exported> all;
    for (int run = 0; run < EXPORTED_RUNS; ++run) {
        all.push_back(exported_in_c(run));
    }
    return all;
}

std::vector<exported> own_runs()
{
    std::vector<exported> own;
    for (const exported &run : all_runs()) {
        if (is_of_this_build(run)) own.push_back(run);
    }
    return own;
}

record::RunSpecification specification_of(const exported &run)
{
    return record::read_run(runs / run.folder / "run.json").specification;
}

settings::Setup setup_of(const record::RunSpecification &specification)
{
    return settings::setup_from_settings(specification.settings, specification.setup, "the run's settings");
}

template <class Number> bool same(const Number *a, const Number *b, std::size_t count)
{
    return std::memcmp(a, b, count * sizeof *a) == 0;
}

void expect_equal(const twd_cpg_config &ours, const twd_cpg_config &theirs)
{
    EXPECT_EQ(ours.with_centre, theirs.with_centre);
    EXPECT_EQ(ours.tick_s, theirs.tick_s);
    EXPECT_EQ(ours.amplitude_rate_per_s, theirs.amplitude_rate_per_s);
    EXPECT_EQ(ours.centre_rate_per_s, theirs.centre_rate_per_s);
    EXPECT_EQ(ours.return_lag, theirs.return_lag);
    EXPECT_EQ(ours.centre_start, theirs.centre_start);
}

void expect_equal(const twd_finger &ours, const twd_finger &theirs)
{
    EXPECT_TRUE(same(ours.joint, theirs.joint, 2));
    EXPECT_EQ(ours.gravity.moving, theirs.gravity.moving);
    EXPECT_TRUE(same(ours.gravity.direction, theirs.gravity.direction, 3));
    EXPECT_TRUE(same(ours.gravity.joint, theirs.gravity.joint, 2));
    EXPECT_TRUE(same(ours.gravity.pair_energy_j[0], theirs.gravity.pair_energy_j[0], 9));
}

// The controller's configuration is, to the bit, the one that the run had of its settings.
TEST(Export, controller_is_the_runs)
{
    for (const exported &run : own_runs()) {
        SCOPED_TRACE(run.folder);
        const record::RunSpecification specification = specification_of(run);
        const twd_controller_config theirs =
            controller_config({setup_of(specification), specification.model, specification.centre});
        twd_controller_config ours{};
        ASSERT_EQ(twd_setup_config(&run.skill->setup, &ours), TWD_OK);
        EXPECT_EQ(ours.model, theirs.model);
        expect_equal(ours.oscillators, theirs.oscillators);
        EXPECT_EQ(ours.phase_start, theirs.phase_start);
        EXPECT_EQ(ours.saturation, theirs.saturation);
        EXPECT_TRUE(same(&ours.ranges, &theirs.ranges, 1));
        ASSERT_EQ(ours.joints, theirs.joints);
        EXPECT_TRUE(same(ours.joint, theirs.joint, theirs.joints));
        ASSERT_EQ(ours.fingers, theirs.fingers);
        for (int f = 0; f < theirs.fingers; ++f) {
            expect_equal(ours.finger[f], theirs.finger[f]);
        }
    }
}

// The desired angles of a played skill are, to the last digit, those of `twiddle replay`.
TEST(Export, skill_moves_as_the_replay)
{
    for (const exported &run : own_runs()) {
        SCOPED_TRACE(run.folder);
        std::vector<std::string> names;
        for (const std::string joint : joint_names) {
            names.push_back("desired_" + joint + "_rad");
        }
        const auto replayed = record::read_csv_columns(runs / run.folder / "trajectory.csv", names);
        twd_controller controller{};
        ASSERT_EQ(twd_skill_start(run.skill, &controller), TWD_OK);
        ASSERT_EQ(replayed[0].size(), run.skill->trial_ticks);
        for (int tick = 0; tick < run.skill->trial_ticks; ++tick) {
            std::array<twd_num, TWD_MAX_JOINTS> desired_rad{};
            twd_controller_tick(&controller, desired_rad.data());
            for (std::size_t i = 0; i < joint_count; ++i) {
                ASSERT_EQ(twd_num_to_double(desired_rad[i]), replayed[i][tick]) << tick;
            }
        }
    }
}

// The learner as it is after the run's trials, from its seed and the rotations that it was rewarded for.
twd_learner trained_again(const exported &run, const std::vector<twd_num> &input)
{
    const record::RunSpecification specification = specification_of(run);
    const settings::LearnerSetup learner = setup_of(specification).learner;
    const twd_learner_config config =
        learner_config({{setup_of(specification), specification.model, specification.centre},
                        specification.trials,
                        specification.seed});
    twd_learner trained{};
    EXPECT_EQ(twd_learner_init(&trained, &config), TWD_OK);
    const auto columns = record::read_csv_columns(runs / run.folder / "trials.csv", {"rotation_rad"});
    for (const double rotation_rad : columns[0]) {
        std::array<twd_num, TWD_MAX_UNITS> parameter{};
        twd_learner_act(&trained, input.data(), parameter.data());
        (void)twd_learner_learn(&trained, twd_wide_from_double(rotation_rad * learner.reward_per_rad));
    }
    return trained;
}

// A learner that is restored from the constants draws, for 50 more trials, to the bit what the run's own would have.
TEST(Export, learner_goes_on_as_the_runs)
{
    for (const exported &run : own_runs()) {
        SCOPED_TRACE(run.folder);
        const record::RunSpecification specification = specification_of(run);
        const settings::LearnerSetup learner = setup_of(specification).learner;
        const std::vector<twd_num> input =
            library_numbers(learner_input(sim::read_object(TWIDDLE_MODELS, specification.object), learner));
        twd_learner theirs = trained_again(run, input);
        twd_learner ours{};
        ASSERT_EQ(twd_learner_restore(&ours, run.learner), TWD_OK);
        EXPECT_EQ(ours.trial, specification.trials);
        EXPECT_EQ(run.reward_per_rad, twd_wide_from_double(learner.reward_per_rad));
        for (int trial = 0; trial < 50; ++trial) {
            std::array<twd_num, TWD_MAX_UNITS> a{};
            std::array<twd_num, TWD_MAX_UNITS> b{};
            twd_learner_act(&ours, run.learner->input, a.data());
            twd_learner_act(&theirs, input.data(), b.data());
            ASSERT_EQ(a, b) << trial;
            const twd_wide reward = twd_wide_of_num(a[0] - a[1]);
            ASSERT_EQ(twd_learner_learn(&ours, reward), twd_learner_learn(&theirs, reward)) << trial;
        }
    }
}

// In any number build a run of any other is the same to within rounding: its parameters are those of policy.json, its
// constants are accepted, and the policy that its weights give is the learned one.
TEST(Export, runs_of_other_number_types_are_taken)
{
    for (const exported &run : all_runs()) {
        SCOPED_TRACE(run.folder);
        const record::Policy policy = record::read_policy(runs / run.folder / "policy.json");
        twd_controller controller{};
        ASSERT_EQ(twd_skill_start(run.skill, &controller), TWD_OK);
        twd_learner learner{};
        ASSERT_EQ(twd_learner_restore(&learner, run.learner), TWD_OK);
        EXPECT_TRUE(same(learner.random.state, policy.random_state.data(), 4));
        EXPECT_EQ(learner.trial, policy.trials);
        std::array<twd_num, TWD_MAX_UNITS> parameter{};
        twd_learner_policy(&learner, run.learner->input, parameter.data());
        ASSERT_EQ(run.skill->parameters, policy.parameters.size());
        for (std::size_t i = 0; i < policy.parameters.size(); ++i) {
            EXPECT_NEAR(twd_num_to_double(run.skill->parameter[i]), policy.parameters[i].second, 6e-8) << i;
            EXPECT_NEAR(twd_num_to_double(parameter[i]), policy.parameters[i].second, 1e-5) << i;
        }
    }
}

} // namespace
