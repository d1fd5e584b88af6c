/* critic.h: a linear estimate of the reward, and its error.
 *
 * E = sum_i w_i x_i, S = R - E, dw_i = eta_E S x_i (Ciancio et al. 2011, eqs. 6 and 7). Stable while
 * rate times the squared norm of the input is below 2. */
#ifndef TWIDDLE_CRITIC_H
#define TWIDDLE_CRITIC_H

#include <twiddle/detail/learner_names.h>
#include <twiddle/error.h>
#include <twiddle/learner_limits.h>
#include <twiddle/number.h>

#include <stddef.h>

TWD_BEGIN_DECLARATIONS

/* The estimator. */
struct twd_critic {
    /* 1..TWD_MAX_INPUTS */
    uint8_t inputs;
    /* w_i, 0 at first. */
    twd_wide weight[TWD_MAX_INPUTS];
};

/* Make an estimator of `inputs` inputs that expects 0. Error: more inputs than the array holds, or none. */
enum twd_error twd_critic_init(struct twd_critic *critic, size_t inputs);

/* E, the reward expected for `input`. */
twd_wide twd_critic_value(const struct twd_critic *critic, const twd_num *input);

/* Move the estimate towards `reward`; returns the TD error S before the change. */
twd_wide twd_critic_learn(struct twd_critic *critic, const twd_num *input, twd_num rate, twd_wide reward);

TWD_END_DECLARATIONS

#endif
