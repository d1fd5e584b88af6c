/* filter.h: a critically damped second-order filter, advanced by its exact discrete solution.
 *
 * y'' = a (a/4 (Y - y) - y'), Ciancio et al. 2011, eqs. 13 and 14: amplitude and centre of an oscillator follow their
 * targets this way. The equation is linear with a double pole at -a/2, so a step of any length is a few multiplications
 * without integration error. How the state is kept and multiplied depends on the number build: float/filter.h and
 * fixed/filter.h. The target Y is handed to every function, and is the same from start to start.
 *
 *     twd_filter_start      begin at `value` (y), at rest
 *     twd_filter_velocity   y' / (a/2), in the unit of y; y is the field `value`
 *     twd_filter_advance    one tick towards the target */
#ifndef TWIDDLE_FILTER_H
#define TWIDDLE_FILTER_H

#include <twiddle/detail/controller_names.h>
#include <twiddle/number.h>

#if defined(TWD_NUMBER_FIXED)
#include <twiddle/fixed/filter.h>
#else
#include <twiddle/float/filter.h>
#endif

TWD_BEGIN_DECLARATIONS

/* The constants for rate `rate_per_s` (a, in 1/s) and tick `tick_s`; both positive, their product at most
 * TWD_LARGEST_RATE_TIMES_TICK: 32, and 1.375 in the fixed build. */
struct twd_filter_step twd_filter_step_make(twd_rate rate_per_s, twd_small tick_s);

TWD_END_DECLARATIONS

#endif
