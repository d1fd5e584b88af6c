/* actor.h: a layer of sigmoid units that explore by noise; experts and selector are made of the same units.
 *
 * PA_j = sum_i w_ji x_i, y_j = 1 / (1 + exp(-PA_j)) (Ciancio et al. 2011, eqs. 1 and 2), explored y_j^N = y_j + N (eq. 3), and
 * dw_ji = eta_A S (y_j^N - y_j) y_j (1 - y_j) x_i (eq. 8). y^N is clipped to [clip, 1 - clip]; the clipped
 * value is what acts and what is learned from. */
#ifndef TWIDDLE_ACTOR_H
#define TWIDDLE_ACTOR_H

#include <twiddle/error.h>
#include <twiddle/learner_config.h>
#include <twiddle/random.h>

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The layer. */
struct twd_actor {
    uint8_t units;                                 /* 1..TWD_MAX_UNITS */
    uint8_t inputs;                                /* 1..TWD_MAX_INPUTS */
    twd_num weight[TWD_MAX_UNITS][TWD_MAX_INPUTS]; /* w_ji */
    twd_num output[TWD_MAX_UNITS];                 /* y_j of the last activation, (0, 1) */
    twd_num explored[TWD_MAX_UNITS];               /* y_j^N of the last exploration, [clip, 1 - clip] */
};

/* Make a layer with weights drawn uniformly from [-weight_range, weight_range), unit by unit; weight_range in [0, 1].
 * Errors: sizes beyond the arrays, a weight_range outside its range; then nothing is drawn. */
enum twd_error twd_actor_init(struct twd_actor *actor, size_t units, size_t inputs, twd_num weight_range,
                              struct twd_random *random);

/* y_j of unit `unit` for `input`, [inputs], (0, 1); leaves the layer as it was. */
twd_num twd_actor_unit(const struct twd_actor *actor, size_t unit, const twd_num *input);

/* Compute `output` from `input`, [inputs]. */
void twd_actor_activate(struct twd_actor *actor, const twd_num *input);

/* Compute `explored` from `output`: one draw a unit, uniform in [-half_range, half_range), then the clip. */
void twd_actor_explore(struct twd_actor *actor, twd_num half_range, twd_num clip, struct twd_random *random);

/* Change the weights for TD error `td_error`, after activate and explore on the same `input`. */
void twd_actor_learn(struct twd_actor *actor, const twd_num *input, twd_num rate, twd_num td_error);

#ifdef __cplusplus
}
#endif
#endif
