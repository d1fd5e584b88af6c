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
    /* Half-range at trial 0, [0, 1]; the paper's is 0.5. */
    twd_num start;
    /* Half-range after the decay, [0, 1]; the paper's is 0.05. */
    twd_num end;
    /* (0, 1]; the paper's is 0.6. */
    twd_num decay_fraction;
    /* Length of the training, 1..2^31 - 1. */
    uint32_t trials;
};

/* The half-range in force at `trial`, from 0. */
twd_num twd_noise_half_range(const struct twd_noise_schedule *schedule, uint32_t trial);

/* All that a learner needs to know. Copied by init. */
struct twd_learner_config {
    /* Parameters of the model (twd_model_parameters). */
    size_t units;
    /* Units of the input map. */
    size_t inputs;
    /* eta_A, [0, 1]; the paper's is 0.1. */
    twd_num actor_rate;
    /* eta_E, [0, 1]; the paper's is 0.1. */
    twd_num critic_rate;
    /* Initial actor weights are uniform in +- this, [0, 1]. */
    twd_num weight_range;
    /* Explored values stay in [clip, 1 - clip]; [0, 0.5). */
    twd_num clip;
    struct twd_noise_schedule noise;
    /* So many units, the last ones, act without noise and so do not learn; 0..units. */
    size_t silent_units;
    enum twd_learned_value learned_value;
    uint64_t seed;
};

/* The learner. Fields may be read. */
struct twd_learner {
    struct twd_learner_config config;
    struct twd_random random;
    struct twd_actor actor;
    struct twd_critic critic;
    /* What the current trial acts on. */
    twd_num input[TWD_MAX_INPUTS];
    /* Half-range of the current trial. */
    twd_num noise;
    /* E of the current trial, before its reward. */
    twd_wide value;
    /* Trials learned from so far. */
    uint32_t trial;
};

/* What a learner has come to, as constants: const, in flash. Pointers refer to arrays as long as `config` says. */
struct twd_learner_snapshot {
    struct twd_learner_config config;
    struct twd_random random;
    /* Trials learned from so far. */
    uint32_t trial;
    /* [units][inputs], unit by unit. */
    const twd_num *actor_weight;
    /* [inputs] */
    const twd_wide *critic_weight;
    /* [inputs]: what the trials acted on: for twd_learner_act and twd_learner_policy. */
    const twd_num *input;
};

/* Make an untrained learner. Draws: the weights unit by unit. Errors: sizes beyond the arrays, a field out of range. */
enum twd_error twd_learner_init(struct twd_learner *learner, const struct twd_learner_config *config);

/* Make the learner that `snapshot` was taken of: the next trial is what it would have been there. Errors: those of
 * init, a null table, an all-zero random state. */
enum twd_error twd_learner_restore(struct twd_learner *learner, const struct twd_learner_snapshot *snapshot);

/* Start a trial on `input`, [inputs]: writes the explored parameters, [units]. */
void twd_learner_act(struct twd_learner *learner, const twd_num *input, twd_num *parameter);

/* End the trial that act started with its reward; returns the TD error S. A reward that is not finite counts as 0. */
twd_wide twd_learner_learn(struct twd_learner *learner, twd_wide reward);

/* The learned policy: the parameters for `input` without noise, [units]; leaves the learner as it was. */
void twd_learner_policy(const struct twd_learner *learner, const twd_num *input, twd_num *parameter);

TWD_END_DECLARATIONS

#endif
