#include "training.hpp"

#include "sim/hand_model.hpp"
#include "sim/object.hpp"
#include "sim/setup.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace twiddle::experiment
{

namespace
{

sim::Setup setup_of(const record::RunSpecification &specification)
{
    return sim::setup_from_settings(specification.settings, specification.setup, "the run's settings");
}

} // namespace

TrialRunner make_trial_runner(const record::RunSpecification &specification, const std::filesystem::path &models_dir)
{
    const sim::HandHold hold = specification.hand == "full" ? sim::HandHold::full : sim::HandHold::welded;
    return TrialRunner(sim::stepper_of_name(specification.stepper),
                       sim::read_hand_model(models_dir / "icub_right_hand.urdf"),
                       sim::read_object(models_dir, specification.object), setup_of(specification), hold,
                       find_model(specification.model), specification.centre);
}

Training::Training(const record::RunSpecification &specification, const std::filesystem::path &models_dir)
    : model_(&find_model(specification.model)), with_centre_(specification.centre),
      runner_(make_trial_runner(specification, models_dir))
{
    const sim::LearnerSetup learner = setup_of(specification).learner;
    input_ = learner_input(sim::read_object(models_dir, specification.object), learner);
    reward_per_rad_ = learner.reward_per_rad;
    const twd_agent_config config =
        agent_config(learner, *model_, with_centre_, specification.trials, specification.seed);
    const twd_error error = twd_agent_init(&agent_, &config);
    if (error != TWD_OK)
        throw std::runtime_error("the learner refuses set-up '" + specification.setup + "': " + twd_error_text(error));
    parameters_.resize(config.units);
}

TrialRow Training::run_trial()
{
    TrialRow row = act();
    TrialResult result = runner_.run(parameters_);
    row.rotation_rad = result.rotation_rad;
    row.fault = std::move(result.fault);
    learn(row);
    return row;
}

TrialRow Training::recall_trial(double rotation_rad)
{
    TrialRow row = act();
    runner_.start(parameters_);
    row.rotation_rad = rotation_rad;
    learn(row);
    return row;
}

TrialRow Training::act()
{
    twd_agent_act(&agent_, input_.data(), parameters_.data());
    TrialRow row;
    row.trial = agent_.trial + 1;
    row.value = shown_wide(agent_.value);
    row.noise = shown_num(agent_.noise);
    return row;
}

void Training::learn(TrialRow &row)
{
    row.weight = runner_.weights();
    const twd_wide reward = twd_wide_from_double(row.rotation_rad * reward_per_rad_);
    row.reward = shown_wide(reward);
    row.td_error = shown_wide(twd_agent_learn(&agent_, reward));
}

record::Policy Training::policy() const
{
    record::Policy policy;
    policy.model = model_->name;
    policy.centre = with_centre_;
    policy.trials = agent_.trial;

    Parameters parameters(agent_.config.units);
    twd_agent_policy(&agent_, input_.data(), parameters.data());
    const std::vector<std::string> names = parameter_names(*model_, with_centre_);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        policy.parameters.emplace_back(names.at(i), twd_num_to_double(parameters[i]));
    }
    const std::size_t inputs = agent_.config.inputs;
    std::transform(agent_.critic.weight, agent_.critic.weight + inputs, std::back_inserter(policy.critic_weights),
                   twd_wide_to_double);
    for (std::size_t unit = 0; unit < parameters.size(); ++unit) {
        const twd_num *weights = agent_.actor.weight[unit];
        std::vector<double> &row = policy.actor_weights.emplace_back();
        std::transform(weights, weights + inputs, std::back_inserter(row), twd_num_to_double);
    }
    std::copy(std::begin(agent_.random.state), std::end(agent_.random.state), policy.random_state.begin());
    return policy;
}

} // namespace twiddle::experiment
