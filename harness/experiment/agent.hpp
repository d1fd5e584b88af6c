// agent.hpp: who acts, moves the hand and learns in a training run: the C library in this process, or a chip elsewhere.
#pragma once

#include "control_loop.hpp"
#include "controller_setup.hpp"
#include "number.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace twiddle::experiment
{

// What an agent is made of.
struct AgentSetup {
    std::string name; // of the set-up, for sentences
    twd_controller_config controller{};
    twd_learner_config learner{};
};

// What a trial starts with.
struct TrialStart {
    Shown value = 0; // the critic's estimate of the reward
    Shown noise = 0; // half-range of the exploration noise in force
    ExpertWeights weight{};
};

// What a learner has come to.
struct LearnerState {
    std::uint32_t trials = 0;
    Parameters policy;                               // the parameters without noise
    std::vector<std::vector<twd_num>> actor_weights; // [units][inputs]
    std::vector<twd_wide> critic_weights;            // [inputs]
    std::array<std::uint32_t, 4> random_state{};
};

// Each trial: act, advance once a control step (not at all for a trial that is only recalled), learn. All may throw
// std::runtime_error; the trial then has not been learned from.
class Agent
{
  public:
    virtual ~Agent() = default;

    virtual TrialStart act(const LearnerInput &input) = 0;

    // Move `world` through one control step of `substeps` substeps.
    virtual StepCommands advance(sim::World &world, int substeps) = 0;

    // Returns the TD error.
    virtual twd_wide learn(twd_wide reward) = 0;

    virtual LearnerState state(const LearnerInput &input) = 0;
};

// How a training run makes its agent. Throws std::runtime_error for a set-up that the agent refuses.
using AgentMaker = std::function<std::unique_ptr<Agent>(const AgentSetup &)>;

// An agent in this process.
std::unique_ptr<Agent> make_local_agent(const AgentSetup &setup);

} // namespace twiddle::experiment
