/* oscillator.h: one amplitude- and centre-controlled phase oscillator.
 *
 * With a centre x = c + r cos(theta) (Ciancio et al. 2011, eq. 15); without it, Ijspeert's original,
 * x = r (1 + cos(theta)) (eq. 11). No function here allocates, blocks or fails; all may be called from an interrupt. */
#ifndef TWIDDLE_OSCILLATOR_H
#define TWIDDLE_OSCILLATOR_H

#include <twiddle/filter.h>
#include <twiddle/number.h>
#include <twiddle/phase.h>

TWD_BEGIN_DECLARATIONS

/* The state of one oscillator, and its targets: R and C of one trial. */
struct twd_oscillator {
    /* theta, turns, 2^32 = one; wraps by itself. */
    twd_phase phase;
    /* r, of the joint's range, 0..0.5. */
    struct twd_filter amplitude;
    /* c, of the joint's range, 0..1; unused without centre. */
    struct twd_filter centre;
    /* R */
    twd_num amplitude_target;
    /* C */
    twd_num centre_target;
    /* Coupling sum of the coming tick as far as it is known, rad/s; 0 between two ticks. */
    twd_wide pull;
    /* Coupling sum of the last tick, rad/s. */
    twd_wide last_pull;
    /* x after the last tick, of the joint's range, not saturated. */
    twd_num output;
};

/* x = c + r cos(theta) */
static inline twd_num twd_oscillator_output_with_centre(twd_num centre, twd_num amplitude, twd_phase phase)
{
    return centre + twd_mul_short(amplitude, twd_cos(phase));
}

/* x = r (1 + cos(theta)) */
static inline twd_num twd_oscillator_output_without_centre(twd_num amplitude, twd_phase phase)
{
    return twd_mul_short(amplitude, TWD_NUM(1) + twd_cos(phase));
}

TWD_END_DECLARATIONS

#endif
