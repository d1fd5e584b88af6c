/* phase.h: phases from turns and angles, and their sine and cosine.
 *
 * Inline, since a control tick spends most of its time here. The sines are polynomials with a stated error, without
 * libm, as long as the number build needs them: float/phase.h and fixed/phase.h. All may be called from an interrupt.
 *
 *     twd_phase_from_turns      turns in (-0.5, 0.5); values beyond are clamped to just inside
 *     twd_phase_from_angle      an angle in [-pi, pi], rad; values beyond are clamped
 *     twd_phase_from_fraction   a fraction of a turn in [0, 1]; 1 wraps to 0
 *     twd_phase_from_frequency  what a frequency (Hz) advances in a tick (s); product below 0.5, clamped to just inside
 *     twd_phase_from_rates      what a rate (rad/s), extrapolated from it and the last one to the middle of the coming
 *                               tick, advances in a tick, given as its twd_turn_gain; clamped in the same way by the
 *                               float builds; the fixed build takes extrapolated rates of at most 15.9 rad/s
 *     twd_sin, twd_cos          sin and cos(2 pi phase / 2^32); error at most 1e-8 (double), 2e-7 (float), 4e-6 (fixed)
 *     twd_sine_cosine           both, for less than the two of them apart; the same error
 *     twd_sine_cosine_of_angle  both of an angle in [-pi, pi], rad; values beyond are clamped; error at most
 *                               1e-8 (double), 3e-7 (float), 4e-6 (fixed) */
#ifndef TWIDDLE_PHASE_H
#define TWIDDLE_PHASE_H

#include <twiddle/detail/controller_names.h>
#include <twiddle/number.h>

#define TWD_EIGHTH_TURN UINT32_C(0x20000000)
#define TWD_QUARTER_TURN UINT32_C(0x40000000)
#define TWD_HALF_TURN UINT32_C(0x80000000)

#if defined(TWD_NUMBER_FIXED)
#include <twiddle/fixed/phase.h>
#else
#include <twiddle/float/phase.h>
#endif

#endif
