#include <twiddle/critic.h>

enum twd_error twd_critic_init(struct twd_critic *critic, size_t inputs)
{
    if (inputs < 1 || inputs > TWD_MAX_INPUTS) return TWD_ERROR_LEARNER_SIZE;
    critic->inputs = (uint8_t)inputs;
    for (size_t i = 0; i < TWD_MAX_INPUTS; i++)
        critic->weight[i] = TWD_NUM(0);
    return TWD_OK;
}

twd_num twd_critic_value(const struct twd_critic *critic, const twd_num *input)
{
    twd_num value = TWD_NUM(0);
    for (size_t i = 0; i < critic->inputs; i++)
        value += twd_mul(critic->weight[i], input[i]);
    return value;
}

twd_num twd_critic_learn(struct twd_critic *critic, const twd_num *input, twd_num rate, twd_num reward)
{
    const twd_num td_error = reward - twd_critic_value(critic, input);
    const twd_num step = twd_mul(rate, td_error);
    for (size_t i = 0; i < critic->inputs; i++)
        critic->weight[i] += twd_mul(step, input[i]);
    return td_error;
}
