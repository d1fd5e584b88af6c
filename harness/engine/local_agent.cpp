// The library's engine: an agent of its controller and its learner, in this process.
#include "control_loop.hpp"
#include "controller_setup.hpp"
#include "library_numbers.hpp"
#include "number_engines.hpp"

#include <twiddle/learner.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace twiddle::engine::TWD_BUILD_NAMESPACE
{

namespace
{

class LocalAgent final : public Agent
{
  public:
    explicit LocalAgent(const AgentSetup &setup) : loop_(setup.controller)
    {
        const twd_learner_config config = learner_config(setup);
        const twd_error error = twd_learner_init(&learner_, &config);
        if (error != TWD_OK)
            throw std::runtime_error("the learner refuses set-up '" + setup.controller.setup.name +
                                     "': " + twd_error_text(error));
        parameters_.resize(config.units);
    }

    TrialStart act(const LearnerInput &input) override
    {
        twd_learner_act(&learner_, library_numbers(input).data(), parameters_.data());
        loop_.start_with(parameters_);
        return {twd_wide_to_double(learner_.value), twd_num_to_double(learner_.noise), loop_.weights()};
    }

    const JointCommands &torque(const JointReadings &readings, bool tick) override
    {
        return loop_.torque(readings, tick);
    }

    double learn(double reward) override
    {
        return twd_wide_to_double(twd_learner_learn(&learner_, twd_wide_from_double(reward)));
    }

    LearnerState state(const LearnerInput &input) override
    {
        LearnerState state;
        state.trials = learner_.trial;
        std::vector<twd_num> policy(learner_.config.units);
        twd_learner_policy(&learner_, library_numbers(input).data(), policy.data());
        state.policy = doubles_of(policy.data(), policy.size(), twd_num_to_double);
        const std::size_t inputs = learner_.config.inputs;
        for (std::size_t unit = 0; unit < learner_.config.units; ++unit) {
            state.actor_weights.push_back(doubles_of(learner_.actor.weight[unit], inputs, twd_num_to_double));
        }
        state.critic_weights = doubles_of(learner_.critic.weight, inputs, twd_wide_to_double);
        std::copy(std::begin(learner_.random.state), std::end(learner_.random.state), state.random_state.begin());
        return state;
    }

  private:
    ControlLoop loop_;
    twd_learner learner_{};
    std::vector<twd_num> parameters_; // of the current trial
};

std::unique_ptr<Controller> make_controller(const ControllerSetup &setup)
{
    return std::make_unique<ControlLoop>(setup);
}

std::unique_ptr<Agent> make_agent(const AgentSetup &setup)
{
    return std::make_unique<LocalAgent>(setup);
}

double rounded_reward(double reward)
{
    return twd_wide_to_double(twd_wide_from_double(reward));
}

} // namespace

const Engine engine = {make_controller, make_agent, learner_input, rounded_reward};

} // namespace twiddle::engine::TWD_BUILD_NAMESPACE
