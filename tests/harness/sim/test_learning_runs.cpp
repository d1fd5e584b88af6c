// Short learning runs on the simulated hand, against their own beginning and against an agent that does not learn.
#include "fixtures.hpp"

#include "experiment/training.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace twiddle::experiment
{

namespace
{

constexpr std::uint32_t trials = 1000;
constexpr std::uint32_t window = 100;

record::RunSpecification specification(std::uint64_t seed, const std::vector<settings::Override> &overrides)
{
    record::RunSpecification run;
    run.object = "small-sphere";
    run.model = "cpg-c";
    run.seed = seed;
    run.trials = trials;
    run.hand = "welded";
    run.stepper = "fast";
    run.number = "float";
    run.setup = "mid-a";
    run.settings = sim::default_setup(overrides).settings;
    return run;
}

struct Learned {
    double first_rad = 0; // mean rotation of the first 100 trials
    double last_rad = 0;  // and of the last 100
};

Learned learn(std::uint64_t seed)
{
    Training training(specification(seed, {}), TWIDDLE_MODELS);
    Learned learned;
    for (std::uint32_t trial = 0; trial < trials; trial++) {
        const double rotation_rad = training.run_trial().rotation_rad;
        if (trial < window) learned.first_rad += rotation_rad / window;
        if (trial >= trials - window) learned.last_rad += rotation_rad / window;
    }
    return learned;
}

// Mean of the last 100 trials of an agent whose rates are 0, under the same noise schedule. Its earlier trials cannot
// change it, so their rotations need no simulation.
double last_without_learning_rad(std::uint64_t seed)
{
    Training training(specification(seed, {{"learner.actor_rate", "0"}, {"learner.critic_rate", "0"}}), TWIDDLE_MODELS);
    for (std::uint32_t trial = 0; trial < trials - window; trial++)
        training.recall_trial(0);
    double last_rad = 0;
    for (std::uint32_t trial = 0; trial < window; trial++)
        last_rad += training.run_trial().rotation_rad / window;
    return last_rad;
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

} // namespace

// Over five seeds of 1,000 trials, the median rotation of the last 100 trials is at least twice that of the first 100,
// and above that of an agent that does not learn.
TEST(Learning, cpg_c_learns_to_turn_the_small_sphere)
{
    std::vector<double> first_rad, last_rad, untrained_rad;
    for (std::uint64_t seed = 1; seed <= 5; seed++) {
        const Learned learned = learn(seed);
        first_rad.push_back(learned.first_rad);
        last_rad.push_back(learned.last_rad);
        untrained_rad.push_back(last_without_learning_rad(seed));
        std::printf("seed %d: first 100 trials %.3f rad, last 100 %.3f rad; without learning %.3f rad\n", int(seed),
                    first_rad.back(), last_rad.back(), untrained_rad.back());
    }
    EXPECT_GE(median(last_rad), 2 * median(first_rad));
    EXPECT_GT(median(last_rad), median(untrained_rad));
}

} // namespace twiddle::experiment
