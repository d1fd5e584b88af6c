#include <twiddle/critic.h>

enum twd_error twd_critic_init(struct twd_critic *critic, size_t inputs)
{
    if (inputs < 1 || inputs > TWD_MAX_INPUTS) return TWD_ERROR_LEARNER_SIZE;
    critic->inputs = (uint8_t)inputs;
    for (size_t i = 0; i < TWD_MAX_INPUTS; i++)
        critic->weight[i] = TWD_WIDE(0);
    return TWD_OK;
}

twd_wide twd_critic_value(const struct twd_critic *critic, const twd_num *input)
{
    twd_wide value = TWD_WIDE(0);
    for (size_t i = 0; i < critic->inputs; i++)
        value = twd_wide_add(value, twd_wide_mul(input[i], critic->weight[i]));
    return value;
}

twd_wide twd_critic_learn(struct twd_critic *critic, const twd_num *input, twd_num rate, twd_wide reward)
{
    const twd_wide td_error = twd_wide_subtract(reward, twd_critic_value(critic, input));
    const twd_wide step = twd_wide_mul(rate, td_error);
    for (size_t i = 0; i < critic->inputs; i++)
        critic->weight[i] = twd_wide_add(critic->weight[i], twd_wide_mul(input[i], step));
    return td_error;
}
