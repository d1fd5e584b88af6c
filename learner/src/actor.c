#include <twiddle/actor.h>

#include <twiddle/elementary.h>

enum twd_error twd_actor_init(struct twd_actor *actor, size_t units, size_t inputs, twd_num weight_range,
                              struct twd_random *random)
{
    if (units < 1 || units > TWD_MAX_UNITS) return TWD_ERROR_LEARNER_SIZE;
    if (inputs < 1 || inputs > TWD_MAX_INPUTS) return TWD_ERROR_LEARNER_SIZE;
    if (!twd_within(weight_range, TWD_NUM(0), TWD_NUM(1))) return TWD_ERROR_RANGE;

    actor->units = (uint8_t)units;
    actor->inputs = (uint8_t)inputs;
    for (size_t j = 0; j < TWD_MAX_UNITS; j++) {
        for (size_t i = 0; i < TWD_MAX_INPUTS; i++) {
            const bool used = j < units && i < inputs;
            actor->weight[j][i] = used ? twd_random_symmetric(random, weight_range) : TWD_NUM(0);
        }
        actor->output[j] = TWD_NUM(0);
        actor->explored[j] = TWD_NUM(0);
        actor->learned_value[j] = TWD_NUM(0);
    }
    return TWD_OK;
}

twd_num twd_actor_unit(const struct twd_actor *actor, size_t unit, const twd_num *input)
{
    twd_wide activation = TWD_WIDE(0);
    for (size_t i = 0; i < actor->inputs; i++) {
        if (input[i] == TWD_NUM(0)) continue; /* most inputs are silent */
        activation = twd_wide_add(activation, twd_wide_product(actor->weight[unit][i], input[i]));
    }
    return twd_sigmoid(activation);
}

void twd_actor_activate(struct twd_actor *actor, const twd_num *input)
{
    for (size_t j = 0; j < actor->units; j++)
        actor->output[j] = twd_actor_unit(actor, j, input);
}

void twd_actor_explore(struct twd_actor *actor, const struct twd_exploration *exploration, struct twd_random *random)
{
    const twd_num clip = exploration->clip;
    for (size_t j = 0; j < actor->units; j++) {
        const twd_num noise = twd_random_symmetric(random, exploration->half_range);
        const bool silent = j + exploration->silent_units >= actor->units;
        const twd_num unclipped = silent ? actor->output[j] : actor->output[j] + noise;
        actor->explored[j] = twd_clamp(unclipped, clip, TWD_NUM(1) - clip);
        const bool learns_from_unclipped = silent || exploration->learned_value == TWD_LEARN_FROM_UNCLIPPED;
        actor->learned_value[j] = learns_from_unclipped ? unclipped : actor->explored[j];
    }
}

void twd_actor_learn(struct twd_actor *actor, const twd_num *input, twd_num rate, twd_wide td_error)
{
    const twd_wide gain = twd_wide_mul(rate, td_error);
    for (size_t j = 0; j < actor->units; j++) {
        const twd_num output = actor->output[j];
        const twd_num slope = twd_mul(output, TWD_NUM(1) - output);
        const twd_num step = twd_num_mul_wide(twd_mul(actor->learned_value[j] - output, slope), gain);
        for (size_t i = 0; i < actor->inputs; i++) {
            if (input[i] == TWD_NUM(0)) continue;
            actor->weight[j][i] = twd_add_saturated(actor->weight[j][i], twd_mul_saturated(step, input[i]));
        }
    }
}
