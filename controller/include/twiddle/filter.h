/* filter.h: a critically damped second-order filter, advanced by its exact discrete solution.
 *
 * y'' = a (a/4 (Y - y) - y'), Ciancio et al. 2011, eqs. 13 and 14: amplitude and centre of an oscillator follow their
 * targets this way. The equation is linear with a double pole at -a/2, so a step of any length is four
 * multiplications without integration error. The velocity is kept divided by a/2, in the unit of y. */
#ifndef TWIDDLE_FILTER_H
#define TWIDDLE_FILTER_H

#include <twiddle/number.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The transition of one tick of h seconds, with k = a h / 2 and e = exp(-k). */
struct twd_filter_step {
    twd_num error_from_error;       /* e (1 + k) */
    twd_num error_from_velocity;    /* e k */
    twd_num velocity_from_error;    /* -e k */
    twd_num velocity_from_velocity; /* e (1 - k) */
};

/* The state. */
struct twd_filter {
    twd_num value;    /* y */
    twd_num velocity; /* y' / (a/2), in the unit of y */
};

/* The constants for rate `rate_per_s` (a, in 1/s) and tick `tick_s`; both positive, their product at most 32. */
struct twd_filter_step twd_filter_step_make(twd_num rate_per_s, twd_num tick_s);

/* Advance `filter` by one tick towards `target`. */
static inline void twd_filter_advance(struct twd_filter *filter, const struct twd_filter_step *step, twd_num target)
{
    const twd_num error = filter->value - target;
    const twd_num velocity = filter->velocity;

    filter->value = target + twd_mul(step->error_from_error, error) + twd_mul(step->error_from_velocity, velocity);
    filter->velocity = twd_mul(step->velocity_from_error, error) + twd_mul(step->velocity_from_velocity, velocity);
}

#ifdef __cplusplus
}
#endif
#endif
