#include "engine/engine.hpp"
#include "engine/models.hpp"
#include "setups.hpp"
#include "sim/object.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using namespace twiddle;
using namespace twiddle::engine;

AgentSetup cpg_h()
{
    return {{test::load_setup("paper"), "cpg-h", true}, 10, 3};
}

// An agent of each number type, in one program, and what it sees of the small sphere.
struct Trained {
    std::unique_ptr<Agent> agent;
    LearnerInput input;
};

std::vector<Trained> one_of_each()
{
    std::vector<Trained> all;
    for (const std::string &number : number_names()) {
        const Engine &engine = engine_of_number(number);
        const sim::ObjectSpec sphere = sim::read_object(TWIDDLE_MODELS, "small-sphere");
        all.push_back({engine.make_agent(cpg_h()), engine.learner_input(sphere, test::load_setup("paper").learner)});
    }
    return all;
}

// The number types are told apart by name; a name that is none is refused.
TEST(Engine, number_types_are_known_by_name)
{
    EXPECT_EQ(number_names(), (std::vector<std::string>{"float", "double", "fixed"}));
    EXPECT_NE(engine_of_number("float").make_agent, engine_of_number("fixed").make_agent);
    EXPECT_THROW(engine_of_number("half"), std::out_of_range);
}

// A reward is rounded to the numbers that the library holds. Expected: 0.1 as a float, and in units of 2^-24.
TEST(Engine, rewards_are_the_librarys_numbers)
{
    EXPECT_EQ(engine_of_number("float").rounded_reward(0.1), static_cast<double>(0.1F));
    EXPECT_EQ(engine_of_number("double").rounded_reward(0.1), 0.1);
    EXPECT_EQ(engine_of_number("fixed").rounded_reward(0.1), 1677722 / 16777216.0);
}

// Agents of all three types act, move and learn alike, but for rounding. Expected: the double's numbers.
TEST(Engine, number_types_agree_in_one_program)
{
    const std::vector<Trained> all = one_of_each();
    const Trained &exact = all[1];
    for (int trial = 0; trial < 10; ++trial) {
        const TrialStart expected = exact.agent->act(exact.input);
        const JointReadings readings = {{0.1, 0.02, 0.3, 0.4}, {1, -2, 3, -4}};
        std::vector<JointCommands> commands;
        for (int substep = 0; substep < 10; ++substep) {
            commands.push_back(exact.agent->torque(readings, substep % 5 == 0));
        }
        const double td_error = exact.agent->learn(0.5 + 0.1 * trial);
        for (const std::size_t other : {std::size_t{0}, std::size_t{2}}) {
            const Trained &rounded = all[other];
            const TrialStart start = rounded.agent->act(rounded.input);
            EXPECT_NEAR(start.value, expected.value, 1e-5);
            EXPECT_NEAR(start.noise, expected.noise, 1e-6);
            for (std::size_t expert = 0; expert < expert_count; ++expert) {
                EXPECT_NEAR(start.weight[expert], expected.weight[expert], 1e-5);
            }
            for (int substep = 0; substep < 10; ++substep) {
                const JointCommands found = rounded.agent->torque(readings, substep % 5 == 0);
                for (std::size_t joint = 0; joint < joint_count; ++joint) {
                    EXPECT_NEAR(found.desired_rad[joint], commands[substep].desired_rad[joint], 1e-4);
                    EXPECT_NEAR(found.torque_nm[joint], commands[substep].torque_nm[joint], 1e-4);
                }
            }
            EXPECT_NEAR(rounded.agent->learn(0.5 + 0.1 * trial), td_error, 1e-5);
        }
    }
}

// Desired angles change with a tick alone; the torque follows the readings at every substep.
TEST(Engine, torque_ticks_only_when_told)
{
    const auto controller = engine_of_number("double").make_controller(cpg_h().controller);
    controller->start(Parameters(parameter_count("cpg-h", true), 0.4));
    const JointCommands first = controller->torque({}, true);
    const JointCommands same = controller->torque({{0.1, 0, 0, 0}, {}}, false);
    EXPECT_EQ(same.desired_rad, first.desired_rad);
    EXPECT_NE(same.torque_nm[fei], first.torque_nm[fei]);
    EXPECT_NE(controller->torque({}, true).desired_rad, first.desired_rad);
}

} // namespace
