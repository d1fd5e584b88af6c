/* elementary.h: the elementary functions that the controller and the learner need, without libm.
 *
 * Each is a polynomial with a stated error, the same in every number build, so that a result
 * depends on no platform's library. All may be called from an interrupt. */
#ifndef TWIDDLE_ELEMENTARY_H
#define TWIDDLE_ELEMENTARY_H

#include <twiddle/number.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sin(2 pi phase / 2^32) by an odd polynomial on the folded phase. Error at most 1e-8 (double), 2e-7 (float). */
twd_num twd_sin(twd_phase phase);

/* cos(2 pi phase / 2^32), same error as twd_sin. */
twd_num twd_cos(twd_phase phase);

/* The phase of `turns`, any value in (-0.5, 0.5); values beyond are clamped to just inside. */
twd_phase twd_phase_from_turns(twd_num turns);

/* The phase of `angle_rad`, in [-pi, pi]; values beyond are clamped. */
twd_phase twd_phase_from_angle(twd_num angle_rad);

/* The phase of `fraction` of a turn, in [0, 1]; 1 wraps to 0. */
twd_phase twd_phase_from_fraction(twd_num fraction);

/* exp(-value) for value >= 0; a negative value counts as 0, one above 32 as 32 (1.3e-14). Relative error at most
 * 1e-11 (double), 1e-6 (float). */
twd_num twd_exp_negative(twd_num value);

/* The logistic function 1 / (1 + exp(-value)), any value. Error at most 1e-11 (double), 2e-7 (float). */
twd_num twd_sigmoid(twd_num value);

#ifdef __cplusplus
}
#endif
#endif
