#include "training.hpp"

#include "engine/models.hpp"
#include "settings/setup.hpp"
#include "sim/hand_model.hpp"
#include "sim/object.hpp"

#include <algorithm>
#include <utility>

namespace twiddle::experiment
{

namespace
{

settings::Setup setup_of(const record::RunSpecification &specification)
{
    return settings::setup_from_settings(specification.settings, specification.setup, "the run's settings");
}

TrialWorld make_trial_world(const record::RunSpecification &specification, const std::filesystem::path &models_dir)
{
    const sim::HandHold hold = specification.hand == "full" ? sim::HandHold::full : sim::HandHold::welded;
    return TrialWorld(sim::stepper_of_name(specification.stepper),
                      sim::read_hand_model(models_dir / "icub_right_hand.urdf"),
                      sim::read_object(models_dir, specification.object), setup_of(specification), hold);
}

engine::AgentSetup agent_setup(const record::RunSpecification &specification)
{
    return {
        {setup_of(specification), specification.model, specification.centre}, specification.trials, specification.seed};
}

} // namespace

TrialRunner make_trial_runner(const record::RunSpecification &specification, const std::filesystem::path &models_dir)
{
    return TrialRunner(make_trial_world(specification, models_dir), engine::engine_of_number(specification.number),
                       specification.model, specification.centre);
}

Training::Training(const record::RunSpecification &specification, const std::filesystem::path &models_dir)
    : Training(specification, models_dir, engine::engine_of_number(specification.number).make_agent)
{
}

Training::Training(const record::RunSpecification &specification, const std::filesystem::path &models_dir,
                   const engine::AgentMaker &make_agent)
    : model_(specification.model), with_centre_(specification.centre),
      engine_(&engine::engine_of_number(specification.number)), world_(make_trial_world(specification, models_dir)),
      agent_(make_agent(agent_setup(specification)))
{
    const settings::LearnerSetup &learner = world_.setup().learner;
    input_ = engine_->learner_input(sim::read_object(models_dir, specification.object), learner);
    reward_per_rad_ = learner.reward_per_rad;
}

TrialRow Training::run_trial()
{
    TrialRow row = act();
    TrialResult result =
        world_.run([this](const engine::JointReadings &readings,
                          bool tick) -> const engine::JointCommands & { return agent_->torque(readings, tick); },
                   [](const StepSample &, const sim::World &) {});
    row.rotation_rad = result.rotation_rad;
    row.fault = std::move(result.fault);
    learn(row);
    return row;
}

TrialRow Training::recall_trial(double rotation_rad)
{
    TrialRow row = act();
    row.rotation_rad = rotation_rad;
    learn(row);
    return row;
}

TrialRow Training::act()
{
    const engine::TrialStart start = agent_->act(input_);
    TrialRow row;
    row.trial = trials_ + 1;
    row.value = start.value;
    row.noise = start.noise;
    row.weight = start.weight;
    return row;
}

void Training::learn(TrialRow &row)
{
    row.reward = engine_->rounded_reward(row.rotation_rad * reward_per_rad_);
    row.td_error = agent_->learn(row.reward);
    ++trials_;
}

record::Policy Training::policy()
{
    const engine::LearnerState state = agent_->state(input_);
    record::Policy policy;
    policy.model = model_;
    policy.centre = with_centre_;
    policy.trials = state.trials;
    policy.random_state = state.random_state;

    const std::vector<std::string> names = engine::parameter_names(model_, with_centre_);
    for (std::size_t i = 0; i < state.policy.size(); ++i) {
        policy.parameters.emplace_back(names.at(i), state.policy[i]);
    }
    policy.critic_weights = state.critic_weights;
    policy.actor_weights = state.actor_weights;
    return policy;
}

} // namespace twiddle::experiment
