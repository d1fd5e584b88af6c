// agent.hpp: what acts, moves the hand and learns, whatever numbers it computes with and wherever it does so.
//
// Everything here is in doubles. An agent of another number type rounds what it is given to its own numbers, and what
// it gives is exactly what it holds.
#pragma once

#include "settings/joints.hpp"
#include "settings/setup.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace twiddle::engine
{

// One value in [0, 1] a parameter of the model (models.hpp).
using Parameters = std::vector<double>;

// The responses of the learner's input map to an object.
using LearnerInput = std::vector<double>;

// The share of each CPG in the joint outputs, in the order C, M, S; absent ones have 0. They sum to 1.
constexpr std::size_t expert_count = 3;
using ExpertWeights = std::array<double, expert_count>;

// What a controller reads of a hand.
struct JointReadings {
    JointVector angle_rad{};
    JointVector velocity_rad_s{};
};

// What a controller asks for.
struct JointCommands {
    // Of the last tick.
    JointVector desired_rad{};
    JointVector torque_nm{};
};

// What a controller is made of.
struct ControllerSetup {
    settings::Setup setup;
    // "cpg-s", "cpg-m", "cpg-c" or "cpg-h".
    std::string model;
    bool with_centre = true;
};

// What an agent is made of: a controller and a learner.
struct AgentSetup {
    ControllerSetup controller;
    // Length of the training.
    std::uint32_t trials = 0;
    std::uint64_t seed = 0;
};

// Turns parameters into torques. Each trial: start, then torque at every substep.
class Controller
{
  public:
    Controller() = default;
    Controller(const Controller &) = delete;
    Controller &operator=(const Controller &) = delete;
    virtual ~Controller() = default;

    // Throws std::invalid_argument if the parameters are refused.
    virtual void start(const Parameters &parameters) = 0;

    // The torques for `readings`; with `tick` the pattern generators advance before by one control step. The commands
    // stay until the next call.
    virtual const JointCommands &torque(const JointReadings &readings, bool tick) = 0;
};

// What a trial starts with.
struct TrialStart {
    // The critic's estimate of the reward.
    double value = 0;
    // Half-range of the exploration noise in force.
    double noise = 0;
    ExpertWeights weight{};
};

// What a learner has come to.
struct LearnerState {
    std::uint32_t trials = 0;
    // The parameters without noise.
    Parameters policy;
    // [units][inputs]
    std::vector<std::vector<double>> actor_weights;
    // [inputs]
    std::vector<double> critic_weights;
    std::array<std::uint32_t, 4> random_state{};
};

// Each trial: act, torque at every substep (not at all for a trial that is only recalled), learn. All may throw
// std::runtime_error; the trial then has not been learned from.
class Agent
{
  public:
    Agent() = default;
    Agent(const Agent &) = delete;
    Agent &operator=(const Agent &) = delete;
    virtual ~Agent() = default;

    virtual TrialStart act(const LearnerInput &input) = 0;

    // As Controller's.
    virtual const JointCommands &torque(const JointReadings &readings, bool tick) = 0;

    // Returns the TD error.
    virtual double learn(double reward) = 0;

    virtual LearnerState state(const LearnerInput &input) = 0;
};

// How a training run makes its agent. Throws std::runtime_error for a set-up that the agent refuses.
using AgentMaker = std::function<std::unique_ptr<Agent>(const AgentSetup &)>;

} // namespace twiddle::engine
