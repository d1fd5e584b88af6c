#include <twiddle/learner.h>

twd_num twd_noise_half_range(const struct twd_noise_schedule *schedule, uint32_t trial)
{
    if (trial >= schedule->trials) return schedule->end;
    const twd_num progress = twd_ratio((int32_t)trial, (int32_t)schedule->trials);
    if (progress >= schedule->decay_fraction) return schedule->end;
    const twd_num decayed = twd_div(progress, schedule->decay_fraction);
    return schedule->start + twd_mul(schedule->end - schedule->start, decayed);
}

static bool is_fraction(twd_num value)
{
    return twd_within(value, TWD_NUM(0), TWD_NUM(1));
}

static enum twd_error check(const struct twd_learner_config *config)
{
    const struct twd_noise_schedule *const noise = &config->noise;
    if (config->units < 1 || config->units > TWD_MAX_UNITS) return TWD_ERROR_LEARNER_SIZE;
    if (config->inputs < 1 || config->inputs > TWD_MAX_INPUTS) return TWD_ERROR_LEARNER_SIZE;
    if (!is_fraction(config->actor_rate) || !is_fraction(config->critic_rate)) return TWD_ERROR_RANGE;
    if (!is_fraction(config->weight_range)) return TWD_ERROR_RANGE;
    if (!is_fraction(config->clip) || config->clip >= TWD_NUM(0.5)) return TWD_ERROR_RANGE;
    if (!is_fraction(noise->start) || !is_fraction(noise->end)) return TWD_ERROR_RANGE;
    if (!is_fraction(noise->decay_fraction) || noise->decay_fraction <= TWD_NUM(0)) return TWD_ERROR_RANGE;
    if (config->silent_units > config->units) return TWD_ERROR_RANGE;
    if (config->learned_value != TWD_LEARN_FROM_CLIPPED && config->learned_value != TWD_LEARN_FROM_UNCLIPPED)
        return TWD_ERROR_RANGE;
    if (noise->trials < 1 || noise->trials > INT32_MAX) return TWD_ERROR_RANGE;
    return TWD_OK;
}

enum twd_error twd_learner_init(struct twd_learner *learner, const struct twd_learner_config *config)
{
    const enum twd_error error = check(config);
    if (error != TWD_OK) return error;

    learner->config = *config;
    twd_random_seed(&learner->random, learner->config.seed);
    /* These fail on sizes and ranges only, which are checked by now. */
    (void)twd_actor_init(&learner->actor, learner->config.units, learner->config.inputs, learner->config.weight_range,
                         &learner->random);
    (void)twd_critic_init(&learner->critic, learner->config.inputs);
    for (size_t i = 0; i < TWD_MAX_INPUTS; i++)
        learner->input[i] = TWD_NUM(0);
    learner->noise = learner->config.noise.start;
    learner->value = TWD_WIDE(0);
    learner->trial = 0;
    return TWD_OK;
}

static bool is_all_zero(const struct twd_random *random)
{
    return (random->state[0] | random->state[1] | random->state[2] | random->state[3]) == 0;
}

enum twd_error twd_learner_restore(struct twd_learner *learner, const struct twd_learner_snapshot *snapshot)
{
    if (!snapshot->actor_weight || !snapshot->critic_weight || !snapshot->input) return TWD_ERROR_NULL;
    if (is_all_zero(&snapshot->random)) return TWD_ERROR_RANGE;
    const enum twd_error error = twd_learner_init(learner, &snapshot->config);
    if (error != TWD_OK) return error;

    const twd_num *weight = snapshot->actor_weight;
    for (size_t j = 0; j < learner->config.units; j++)
        for (size_t i = 0; i < learner->config.inputs; i++)
            learner->actor.weight[j][i] = *weight++;
    for (size_t i = 0; i < learner->config.inputs; i++) {
        learner->critic.weight[i] = snapshot->critic_weight[i];
        learner->input[i] = snapshot->input[i];
    }
    learner->random = snapshot->random;
    learner->trial = snapshot->trial;
    return TWD_OK;
}

void twd_learner_act(struct twd_learner *learner, const twd_num *input, twd_num *parameter)
{
    for (size_t i = 0; i < learner->config.inputs; i++)
        learner->input[i] = input[i];
    learner->noise = twd_noise_half_range(&learner->config.noise, learner->trial);
    learner->value = twd_critic_value(&learner->critic, learner->input);
    twd_actor_activate(&learner->actor, learner->input);
    const struct twd_exploration exploration = {learner->noise, learner->config.clip, learner->config.silent_units,
                                                learner->config.learned_value};
    twd_actor_explore(&learner->actor, &exploration, &learner->random);
    for (size_t j = 0; j < learner->config.units; j++)
        parameter[j] = learner->actor.explored[j];
}

twd_wide twd_learner_learn(struct twd_learner *learner, twd_wide reward)
{
    const twd_wide earned = twd_wide_is_finite(reward) ? reward : TWD_WIDE(0);
    const twd_wide td_error = twd_critic_learn(&learner->critic, learner->input, learner->config.critic_rate, earned);
    twd_actor_learn(&learner->actor, learner->input, learner->config.actor_rate, td_error);
    learner->trial++;
    return td_error;
}

void twd_learner_policy(const struct twd_learner *learner, const twd_num *input, twd_num *parameter)
{
    for (size_t j = 0; j < learner->config.units; j++)
        parameter[j] = twd_actor_unit(&learner->actor, j, input);
}
