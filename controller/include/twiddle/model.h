/* model.h: which CPGs a controller runs, and how its parameters in (0, 1) are read.
 *
 * The order of parameters: for each CPG nu (if it chooses the frequency), R of each oscillator, C of each oscillator
 * (with centre), phi of each coupling; then, if there are several CPGs, one selector activation a CPG. Where several
 * CPGs choose a frequency, the first one's drives all. */
#ifndef TWIDDLE_MODEL_H
#define TWIDDLE_MODEL_H

#include <twiddle/cpg.h>
#include <twiddle/detail/controller_names.h>
#include <twiddle/error.h>
#include <twiddle/limits.h>

#include <stddef.h>

TWD_BEGIN_DECLARATIONS

/* A model: const, in flash. */
struct twd_model {
    /* For people, e.g. "cpg-h". */
    const char *name;
    /* 1..TWD_MAX_CPGS; more than one are mixed by the selector. */
    uint8_t cpgs;
    /* [cpgs], in the selector's order. */
    const struct twd_topology *topology[TWD_MAX_CPGS];
};

/* The paper's models: each CPG alone, and the hierarchical one with C, M and S in this order. They have 12, 5, 2 and 22
 * parameters; without centre 8, 3, 1 and 15. */
extern const struct twd_model twd_model_c;
extern const struct twd_model twd_model_m;
extern const struct twd_model twd_model_s;
extern const struct twd_model twd_model_h;

/* How many parameters `model` takes. */
size_t twd_model_parameters(const struct twd_model *model, bool with_centre);

/* The one table of ranges: what parameters 0 and 1 mean. Lags always span [0, 1) turn. */
struct twd_parameter_ranges {
    /* nu at 0; > 0. */
    twd_num frequency_lower_hz;
    /* nu at 1; at most 5. */
    twd_num frequency_upper_hz;
    /* nu of a model in which no CPG chooses it. */
    twd_num lone_frequency_hz;
    /* R at 1, of the joint's range, (0, 0.5]; R at 0 is 0. */
    twd_num amplitude_upper;
    /* C at 0, of the joint's range. */
    twd_num centre_lower;
    /* C at 1, of the joint's range. */
    twd_num centre_upper;
};

/* What the parameters of one trial say. */
struct twd_model_drive {
    /* [cpgs] */
    struct twd_cpg_drive cpg[TWD_MAX_CPGS];
    /* [cpgs]: the selector's s_k, summing to 1. */
    twd_num weight[TWD_MAX_CPGS];
};

/* Read `count` parameters, each in [0, 1], into `drive`; on an error `drive` is as it was. */
enum twd_error twd_model_decode(const struct twd_model *model, bool with_centre,
                                const struct twd_parameter_ranges *ranges, const twd_num *parameter, size_t count,
                                struct twd_model_drive *drive);

TWD_END_DECLARATIONS

#endif
