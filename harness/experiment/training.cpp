#include "training.hpp"

#include "sim/hand_model.hpp"
#include "sim/object.hpp"
#include "sim/setup.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace twiddle::experiment
{

namespace
{

sim::Setup setup_of(const record::RunSpecification &specification)
{
    return sim::setup_from_settings(specification.settings, specification.setup, "the run's settings");
}

TrialWorld make_trial_world(const record::RunSpecification &specification, const std::filesystem::path &models_dir)
{
    const sim::HandHold hold = specification.hand == "full" ? sim::HandHold::full : sim::HandHold::welded;
    return TrialWorld(sim::stepper_of_name(specification.stepper),
                      sim::read_hand_model(models_dir / "icub_right_hand.urdf"),
                      sim::read_object(models_dir, specification.object), setup_of(specification), hold);
}

AgentSetup agent_setup(const record::RunSpecification &specification)
{
    const sim::Setup setup = setup_of(specification);
    const twd_model &model = find_model(specification.model);
    return {setup.name, controller_config(setup, model, specification.centre),
            learner_config(setup.learner, model, specification.centre, specification.trials, specification.seed)};
}

} // namespace

TrialRunner make_trial_runner(const record::RunSpecification &specification, const std::filesystem::path &models_dir)
{
    return TrialRunner(make_trial_world(specification, models_dir), find_model(specification.model),
                       specification.centre);
}

Training::Training(const record::RunSpecification &specification, const std::filesystem::path &models_dir,
                   const AgentMaker &make_agent)
    : model_(&find_model(specification.model)), with_centre_(specification.centre),
      world_(make_trial_world(specification, models_dir)), agent_(make_agent(agent_setup(specification)))
{
    const sim::LearnerSetup &learner = world_.setup().learner;
    input_ = learner_input(sim::read_object(models_dir, specification.object), learner);
    reward_per_rad_ = learner.reward_per_rad;
}

TrialRow Training::run_trial()
{
    TrialRow row = act();
    TrialResult result =
        world_.run([this](sim::World &world, int substeps) { return agent_->advance(world, substeps); },
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
    const TrialStart start = agent_->act(input_);
    TrialRow row;
    row.trial = trials_ + 1;
    row.value = start.value;
    row.noise = start.noise;
    row.weight = start.weight;
    return row;
}

void Training::learn(TrialRow &row)
{
    const twd_wide reward = twd_wide_from_double(row.rotation_rad * reward_per_rad_);
    row.reward = shown_wide(reward);
    row.td_error = shown_wide(agent_->learn(reward));
    ++trials_;
}

record::Policy Training::policy()
{
    const LearnerState state = agent_->state(input_);
    record::Policy policy;
    policy.model = model_->name;
    policy.centre = with_centre_;
    policy.trials = state.trials;
    policy.random_state = state.random_state;

    const std::vector<std::string> names = parameter_names(*model_, with_centre_);
    for (std::size_t i = 0; i < state.policy.size(); ++i) {
        policy.parameters.emplace_back(names.at(i), twd_num_to_double(state.policy[i]));
    }
    std::transform(state.critic_weights.begin(), state.critic_weights.end(), std::back_inserter(policy.critic_weights),
                   twd_wide_to_double);
    for (const std::vector<twd_num> &weights : state.actor_weights) {
        std::vector<double> &row = policy.actor_weights.emplace_back();
        std::transform(weights.begin(), weights.end(), std::back_inserter(row), twd_num_to_double);
    }
    return policy;
}

} // namespace twiddle::experiment
