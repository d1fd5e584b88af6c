/* elementary.h: the elementary functions that the controller and the learner need, without libm (sines: phase.h).
 *
 * Each is a polynomial with a stated error, the same in every number build, so that a result
 * depends on no platform's library. All may be called from an interrupt. */
#ifndef TWIDDLE_ELEMENTARY_H
#define TWIDDLE_ELEMENTARY_H

#include <twiddle/detail/controller_names.h>
#include <twiddle/number.h>

TWD_BEGIN_DECLARATIONS

/* exp(-value) for value >= 0; a negative value counts as 0, one above 32 as 32 (1.3e-14). Relative error at most
 * 1e-11 (double), 1e-6 (float); error at most 2e-7 (fixed). */
twd_num twd_exp_negative(twd_wide value);

/* The same for a number below 1 at full resolution: error at most 4e-8 (fixed). */
twd_num twd_exp_negative_of_num(twd_num value);

/* The logistic function 1 / (1 + exp(-value)), any value. Error at most 1e-11 (double), 2e-7 (float, fixed). */
twd_num twd_sigmoid(twd_wide value);

TWD_END_DECLARATIONS

#endif
