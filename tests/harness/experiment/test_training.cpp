#include "experiment/training.hpp"

#include "engine/models.hpp"

#include "setups.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace
{

using namespace twiddle;
using namespace twiddle::experiment;

record::RunSpecification specification(const std::string &model, std::uint32_t trials)
{
    record::RunSpecification specification;
    specification.object = "small-sphere";
    specification.model = model;
    specification.seed = 11;
    specification.trials = trials;
    specification.hand = "welded";
    specification.stepper = "fast";
    specification.number = TWIDDLE_NUMBER;
    specification.setup = "mid-a";
    specification.settings = test::load_setup("mid-a", {{"learner.reward_per_rad", "0.5"}}).settings;
    return specification;
}

// In every row the reward is the scaled rotation, the TD error reward minus value, and the mixture's weights sum to 1;
// the first value is 0. Expected: the paper's definitions, within the float's rounding.
TEST(Training, rows_hold_the_papers_definitions)
{
    Training training(specification("cpg-h", 10), TWIDDLE_MODELS);
    for (std::uint32_t trial = 1; trial <= 10; ++trial) {
        const TrialRow row = training.run_trial();
        EXPECT_EQ(row.trial, trial);
        EXPECT_NEAR(row.reward, 0.5 * row.rotation_rad, 1e-6);
        EXPECT_NEAR(row.td_error, row.reward - row.value, 1e-6);
        EXPECT_NEAR(std::accumulate(row.weight.begin(), row.weight.end(), 0.0), 1, 1e-6);
        if (trial == 1) {
            EXPECT_EQ(row.value, 0);
        }
        EXPECT_TRUE(row.fault.empty());
    }
}

// The noise falls from 0.5 at the start to 0.05 at 60 % of the trials and stays there. Expected: the paper's schedule
// at 0, 30, 60 and 90 % of ten trials.
TEST(Training, noise_follows_the_papers_schedule)
{
    Training training(specification("cpg-s", 10), TWIDDLE_MODELS);
    std::vector<double> noise;
    for (int i = 0; i < 10; ++i) {
        noise.push_back(training.recall_trial(0).noise);
    }
    EXPECT_NEAR(noise[0], 0.5, 1e-6);
    EXPECT_NEAR(noise[3], 0.275, 1e-6);
    EXPECT_NEAR(noise[6], 0.05, 1e-6);
    EXPECT_NEAR(noise[9], 0.05, 1e-6);
}

// Recalling recorded rotations leaves the same learner as the trials did. Expected: the trials' rows and policy.
TEST(Training, recalled_trials_teach_the_same)
{
    Training simulated(specification("cpg-h", 8), TWIDDLE_MODELS);
    Training recalled(specification("cpg-h", 8), TWIDDLE_MODELS);
    for (int i = 0; i < 8; ++i) {
        const TrialRow row = simulated.run_trial();
        const TrialRow again = recalled.recall_trial(row.rotation_rad);
        EXPECT_EQ(again.trial, row.trial);
        EXPECT_EQ(again.reward, row.reward);
        EXPECT_EQ(again.value, row.value);
        EXPECT_EQ(again.td_error, row.td_error);
        EXPECT_EQ(again.noise, row.noise);
        EXPECT_EQ(again.weight, row.weight);
    }
    EXPECT_EQ(recalled.policy().parameters, simulated.policy().parameters);
    EXPECT_EQ(recalled.policy().actor_weights, simulated.policy().actor_weights);
    EXPECT_EQ(recalled.policy().critic_weights, simulated.policy().critic_weights);
    EXPECT_EQ(recalled.policy().random_state, simulated.policy().random_state);
}

// The policy has the model's parameters by name, each inside (0, 1), and asking for it changes nothing.
TEST(Training, policy_names_its_parameters)
{
    Training training(specification("cpg-c", 4), TWIDDLE_MODELS);
    training.recall_trial(1);
    const record::Policy policy = training.policy();
    const auto names = engine::parameter_names("cpg-c", true);
    ASSERT_EQ(policy.parameters.size(), names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        EXPECT_EQ(policy.parameters[i].first, names[i]);
        EXPECT_GT(policy.parameters[i].second, 0);
        EXPECT_LT(policy.parameters[i].second, 1);
    }
    EXPECT_EQ(policy.trials, 1U);
    EXPECT_EQ(training.policy().random_state, policy.random_state);
}

} // namespace
