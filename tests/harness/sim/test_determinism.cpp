// A trial depends on its parameters alone: not on the trials before it, nor on whether the world is new.
#include "fixtures.hpp"

#include "experiment/trial.hpp"
#include "sim/object.hpp"

#include <gtest/gtest.h>

namespace twiddle::experiment
{

namespace
{

engine::Parameters random_parameters(std::mt19937_64 &random)
{
    engine::Parameters parameters(22);
    for (double &p : parameters)
        p = std::uniform_real_distribution<double>(0.01, 0.99)(random);
    return parameters;
}

// Every number that the run leaves behind, so that two runs can be compared bit for bit.
std::vector<double> trace(TrialRunner &runner, const engine::Parameters &parameters)
{
    std::vector<double> numbers;
    const auto result = runner.run_observed(parameters, [&](const StepSample &sample, const sim::World &world) {
        const sim::Observation seen = world.observe();
        for (std::size_t j = 0; j < joint_count; j++) {
            numbers.insert(numbers.end(), {sample.desired_rad[j], sample.torque_nm[j], seen.angle_rad[j]});
        }
        numbers.insert(numbers.end(), {seen.object_rad, seen.index_contact_n, seen.thumb_contact_n});
    });
    EXPECT_EQ(result.fault, "");
    numbers.push_back(result.rotation_rad);
    return numbers;
}

} // namespace

class Determinism : public testing::TestWithParam<sim::Stepper>
{
};

// A trial after resets equals the same trial in a world of its own, bit for bit, for all nine objects, in both orders.
TEST_P(Determinism, a_trial_after_a_reset_equals_the_trial_in_a_fresh_world)
{
    const sim::HandModel hand = sim::icub_hand();
    const settings::Setup setup = sim::default_setup();
    std::mt19937_64 random(20111);
    for (const std::string &name : sim::object_names(TWIDDLE_MODELS)) {
        const sim::ObjectSpec object = sim::read_object(TWIDDLE_MODELS, name);
        const auto fresh = [&] {
            return TrialRunner(TrialWorld(GetParam(), hand, object, setup, sim::HandHold::welded),
                               engine::engine_of_number(TWIDDLE_NUMBER), "cpg-h", true);
        };
        const engine::Parameters first = random_parameters(random), second = random_parameters(random);
        TrialRunner alone_first = fresh(), alone_second = fresh(), forwards = fresh(), backwards = fresh();
        const auto expected_first = trace(alone_first, first), expected_second = trace(alone_second, second);
        EXPECT_EQ(trace(forwards, first), expected_first) << name;
        EXPECT_EQ(trace(forwards, second), expected_second) << name;
        EXPECT_EQ(trace(backwards, second), expected_second) << name;
        EXPECT_EQ(trace(backwards, first), expected_first) << name;
    }
}

// The same holds with all 19 joints movable.
TEST(FullHand, a_reset_equals_a_rebuild_with_the_full_hand)
{
    const sim::HandModel hand = sim::icub_hand();
    const sim::ObjectSpec object = sim::read_object(TWIDDLE_MODELS, "small-sphere");
    const auto fresh = [&] {
        return TrialRunner(TrialWorld(sim::Stepper::reference, hand, object, sim::default_setup(), sim::HandHold::full),
                           engine::engine_of_number(TWIDDLE_NUMBER), "cpg-h", true);
    };
    std::mt19937_64 random(20112);
    const engine::Parameters first = random_parameters(random), second = random_parameters(random);
    TrialRunner alone = fresh(), after = fresh();
    const auto expected = trace(alone, second);
    trace(after, first);
    EXPECT_EQ(trace(after, second), expected);
}

INSTANTIATE_TEST_SUITE_P(Sim, Determinism, testing::Values(sim::Stepper::reference, sim::Stepper::fast),
                         [](const auto &stepper) {
                             return sim::stepper_names()[static_cast<int>(stepper.param)] + "_stepper";
                         });

} // namespace twiddle::experiment
