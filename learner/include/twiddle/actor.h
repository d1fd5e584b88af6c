/* actor.h: a layer of sigmoid units that explore by noise; experts and selector are made of the same units.
 *
 * PA_j = sum_i w_ji x_i, y_j = 1 / (1 + exp(-PA_j)) (Ciancio et al. 2011, eqs. 1 and 2), explored y_j^N = y_j + N (eq.
 * 3), and dw_ji = eta_A S (y_j^N - y_j) y_j (1 - y_j) x_i (eq. 8). y^N is clipped to [clip, 1 - clip] before it acts;
 * the clipped value is also what is learned from, unless the exploration says otherwise. */
#ifndef TWIDDLE_ACTOR_H
#define TWIDDLE_ACTOR_H

#include <twiddle/detail/learner_names.h>
#include <twiddle/error.h>
#include <twiddle/learner_limits.h>
#include <twiddle/random.h>

#include <stddef.h>

TWD_BEGIN_DECLARATIONS

/* Which y^N the weights learn from, where the clip changes it; the paper knows no clip. */
enum twd_learned_value {
    /* The value that acted. */
    TWD_LEARN_FROM_CLIPPED = 0,
    /* Output and noise, as eqs. 3 and 8 print it. */
    TWD_LEARN_FROM_UNCLIPPED = 1
};

/* How a layer explores. */
struct twd_exploration {
    /* Of the uniform noise, [0, 1]. */
    twd_num half_range;
    /* What acts stays in [clip, 1 - clip]; [0, 0.5). */
    twd_num clip;
    /* So many units, the last ones, act without noise, and so do not learn. */
    size_t silent_units;
    enum twd_learned_value learned_value;
};

/* The layer. */
struct twd_actor {
    /* 1..TWD_MAX_UNITS */
    uint8_t units;
    /* 1..TWD_MAX_INPUTS */
    uint8_t inputs;
    /* w_ji */
    twd_num weight[TWD_MAX_UNITS][TWD_MAX_INPUTS];
    /* y_j of the last activation, (0, 1). */
    twd_num output[TWD_MAX_UNITS];
    /* y_j^N of the last exploration, [clip, 1 - clip]. */
    twd_num explored[TWD_MAX_UNITS];
    /* y_j^N that learn uses. */
    twd_num learned_value[TWD_MAX_UNITS];
};

/* Make a layer with weights drawn uniformly from [-weight_range, weight_range), unit by unit; weight_range in [0, 1].
 * Errors: sizes beyond the arrays, a weight_range outside its range; then nothing is drawn. */
enum twd_error twd_actor_init(struct twd_actor *actor, size_t units, size_t inputs, twd_num weight_range,
                              struct twd_random *random);

/* y_j of unit `unit` for `input`, [inputs], (0, 1); leaves the layer as it was. */
twd_num twd_actor_unit(const struct twd_actor *actor, size_t unit, const twd_num *input);

/* Compute `output` from `input`, [inputs]. */
void twd_actor_activate(struct twd_actor *actor, const twd_num *input);

/* Compute `explored` and `learned_value` from `output`: one draw a unit, also for a silent one, uniform in
 * [-half_range, half_range), then the clip. */
void twd_actor_explore(struct twd_actor *actor, const struct twd_exploration *exploration, struct twd_random *random);

/* Change the weights for TD error `td_error`, after activate and explore on the same `input`. */
void twd_actor_learn(struct twd_actor *actor, const twd_num *input, twd_num rate, twd_wide td_error);

TWD_END_DECLARATIONS

#endif
