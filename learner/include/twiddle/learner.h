/* learner.h: the actor-critic learner of one run: act at a trial's start, learn from its reward at its end. It can be
 * made anew, or from constants that an earlier one left.
 *
 * It knows inputs, parameters in (0, 1) and rewards; neither joints nor objects. The same seed and the same
 * rewards give the same parameters. */
#ifndef TWIDDLE_LEARNER_H
#define TWIDDLE_LEARNER_H

#include <twiddle/actor.h>
#include <twiddle/critic.h>
#include <twiddle/detail/learner_names.h>
#include <twiddle/error.h>
#include <twiddle/random.h>

TWD_BEGIN_DECLARATIONS

/* How far exploration reaches at each trial: the half-range of the uniform noise falls linearly from `start` to `end`
 * over the first `decay_fraction` of the training and stays there. */
struct twd_noise_schedule {
    twd_num start;          /* half-range at trial 0, [0, 1]; the paper's is 0.5 */
    twd_num end;            /* half-range after the decay, [0, 1]; the paper's is 0.05 */
    twd_num decay_fraction; /* (0, 1]; the paper's is 0.6 */
    uint32_t trials;        /* length of the training, 1..2^31 - 1 */
};

/* The half-range in force at `trial`, from 0. */
twd_num twd_noise_half_range(const struct twd_noise_schedule *schedule, uint32_t trial);

/* All that a learner needs to know. Copied by init. */
struct twd_learner_config {
    size_t units;         /* parameters of the model (twd_model_parameters) */
    size_t inputs;        /* units of the input map */
    twd_num actor_rate;   /* eta_A, [0, 1]; the paper's is 0.1 */
    twd_num critic_rate;  /* eta_E, [0, 1]; the paper's is 0.1 */
    twd_num weight_range; /* initial actor weights are uniform in +- this, [0, 1] */
    twd_num clip;         /* explored values stay in [clip, 1 - clip]; [0, 0.5) */
    struct twd_noise_schedule noise;
    size_t silent_units; /* so many units, the last ones, act without noise and so do not learn; 0..units */
    enum twd_learned_value learned_value;
    uint64_t seed;
};

/* The learner. Fields may be read. */
struct twd_learner {
    struct twd_learner_config config;
    struct twd_random random;
    struct twd_actor actor;
    struct twd_critic critic;
    twd_num input[TWD_MAX_INPUTS]; /* what the current trial acts on */
    twd_num noise;                 /* half-range of the current trial */
    twd_wide value;                /* E of the current trial, before its reward */
    uint32_t trial;                /* trials learned from so far */
};

/* What a learner has come to, as constants: const, in flash. Pointers refer to arrays as long as `config` says. */
struct twd_learner_snapshot {
    struct twd_learner_config config;
    struct twd_random random;
    uint32_t trial;                /* trials learned from so far */
    const twd_num *actor_weight;   /* [units][inputs], unit by unit */
    const twd_wide *critic_weight; /* [inputs] */
    const twd_num *input;          /* [inputs] what the trials acted on: for twd_learner_act and twd_learner_policy */
};

/* Make an untrained learner. Draws: the weights unit by unit. Errors: sizes beyond the arrays, a field out of range. */
enum twd_error twd_learner_init(struct twd_learner *learner, const struct twd_learner_config *config);

/* Make the learner that `snapshot` was taken of: the next trial is what it would have been there. Errors: those of init,
 * a null table, an all-zero random state. */
enum twd_error twd_learner_restore(struct twd_learner *learner, const struct twd_learner_snapshot *snapshot);

/* Start a trial on `input`, [inputs]: writes the explored parameters, [units]. */
void twd_learner_act(struct twd_learner *learner, const twd_num *input, twd_num *parameter);

/* End the trial that act started with its reward; returns the TD error S. A reward that is not finite counts as 0. */
twd_wide twd_learner_learn(struct twd_learner *learner, twd_wide reward);

/* The learned policy: the parameters for `input` without noise, [units]; leaves the learner as it was. */
void twd_learner_policy(const struct twd_learner *learner, const twd_num *input, twd_num *parameter);

TWD_END_DECLARATIONS

#endif
