#include "agent.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace twiddle::experiment
{

namespace
{

class LocalAgent : public Agent
{
  public:
    explicit LocalAgent(const AgentSetup &setup) : loop_(setup.controller, setup.name), parameters_(setup.learner.units)
    {
        const twd_error error = twd_learner_init(&learner_, &setup.learner);
        if (error != TWD_OK)
            throw std::runtime_error("the learner refuses set-up '" + setup.name + "': " + twd_error_text(error));
    }

    TrialStart act(const LearnerInput &input) override
    {
        twd_learner_act(&learner_, input.data(), parameters_.data());
        loop_.start(parameters_);
        return {shown_wide(learner_.value), shown_num(learner_.noise), loop_.weights()};
    }

    StepCommands advance(sim::World &world, int substeps) override
    {
        return loop_.advance(world, substeps);
    }

    twd_wide learn(twd_wide reward) override
    {
        return twd_learner_learn(&learner_, reward);
    }

    LearnerState state(const LearnerInput &input) override
    {
        LearnerState state;
        state.trials = learner_.trial;
        state.policy.resize(learner_.config.units);
        twd_learner_policy(&learner_, input.data(), state.policy.data());
        const std::size_t inputs = learner_.config.inputs;
        for (std::size_t unit = 0; unit < learner_.config.units; ++unit) {
            const twd_num *weights = learner_.actor.weight[unit];
            state.actor_weights.emplace_back(weights, weights + inputs);
        }
        state.critic_weights.assign(learner_.critic.weight, learner_.critic.weight + inputs);
        std::copy(std::begin(learner_.random.state), std::end(learner_.random.state), state.random_state.begin());
        return state;
    }

  private:
    ControlLoop loop_;
    twd_learner learner_{};
    Parameters parameters_; // of the current trial
};

} // namespace

std::unique_ptr<Agent> make_local_agent(const AgentSetup &setup)
{
    return std::make_unique<LocalAgent>(setup);
}

} // namespace twiddle::experiment
