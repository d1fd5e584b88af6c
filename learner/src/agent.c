#include <twiddle/agent.h>

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

static enum twd_error check(const struct twd_agent_config *config)
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

enum twd_error twd_agent_init(struct twd_agent *agent, const struct twd_agent_config *config)
{
    const enum twd_error error = check(config);
    if (error != TWD_OK) return error;

    agent->config = *config;
    twd_random_seed(&agent->random, agent->config.seed);
    /* These fail on sizes and ranges only, which are checked by now. */
    (void)twd_actor_init(&agent->actor, agent->config.units, agent->config.inputs, agent->config.weight_range,
                         &agent->random);
    (void)twd_critic_init(&agent->critic, agent->config.inputs);
    for (size_t i = 0; i < TWD_MAX_INPUTS; i++)
        agent->input[i] = TWD_NUM(0);
    agent->noise = agent->config.noise.start;
    agent->value = TWD_WIDE(0);
    agent->trial = 0;
    return TWD_OK;
}

static bool is_all_zero(const struct twd_random *random)
{
    return (random->state[0] | random->state[1] | random->state[2] | random->state[3]) == 0;
}

enum twd_error twd_agent_restore(struct twd_agent *agent, const struct twd_agent_snapshot *snapshot)
{
    if (!snapshot->actor_weight || !snapshot->critic_weight || !snapshot->input) return TWD_ERROR_NULL;
    if (is_all_zero(&snapshot->random)) return TWD_ERROR_RANGE;
    const enum twd_error error = twd_agent_init(agent, &snapshot->config);
    if (error != TWD_OK) return error;

    const twd_num *weight = snapshot->actor_weight;
    for (size_t j = 0; j < agent->config.units; j++)
        for (size_t i = 0; i < agent->config.inputs; i++)
            agent->actor.weight[j][i] = *weight++;
    for (size_t i = 0; i < agent->config.inputs; i++) {
        agent->critic.weight[i] = snapshot->critic_weight[i];
        agent->input[i] = snapshot->input[i];
    }
    agent->random = snapshot->random;
    agent->trial = snapshot->trial;
    return TWD_OK;
}

void twd_agent_act(struct twd_agent *agent, const twd_num *input, twd_num *parameter)
{
    for (size_t i = 0; i < agent->config.inputs; i++)
        agent->input[i] = input[i];
    agent->noise = twd_noise_half_range(&agent->config.noise, agent->trial);
    agent->value = twd_critic_value(&agent->critic, agent->input);
    twd_actor_activate(&agent->actor, agent->input);
    const struct twd_exploration exploration = {agent->noise, agent->config.clip, agent->config.silent_units,
                                                agent->config.learned_value};
    twd_actor_explore(&agent->actor, &exploration, &agent->random);
    for (size_t j = 0; j < agent->config.units; j++)
        parameter[j] = agent->actor.explored[j];
}

twd_wide twd_agent_learn(struct twd_agent *agent, twd_wide reward)
{
    const twd_wide earned = twd_wide_is_finite(reward) ? reward : TWD_WIDE(0);
    const twd_wide td_error = twd_critic_learn(&agent->critic, agent->input, agent->config.critic_rate, earned);
    twd_actor_learn(&agent->actor, agent->input, agent->config.actor_rate, td_error);
    agent->trial++;
    return td_error;
}

void twd_agent_policy(const struct twd_agent *agent, const twd_num *input, twd_num *parameter)
{
    for (size_t j = 0; j < agent->config.units; j++)
        parameter[j] = twd_actor_unit(&agent->actor, j, input);
}
