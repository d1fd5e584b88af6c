/* controller_test.h: what the controller's tests share beside c_test.h: phases. */
#ifndef TWIDDLE_CONTROLLER_TEST_H
#define TWIDDLE_CONTROLLER_TEST_H

#include "c_test.h"

#include <twiddle/phase.h>

#define PI 3.14159265358979323846

/* The bound that phase.h states for sines and cosines. */
#define SINE_BOUND BY_NUMBER(1e-8, 2e-7, 4e-6)

/* What a filter may be off its closed form for a step of 1, beside rounding. In the fixed build its factors have 16
 * bits: half a step is up to 2^-16 of 1 - e, and 1.44 x 2^-16 of the rate and of e k; the response moves by at most
 * 0.54 and 0.37 of these. */
#define FILTER_ERROR BY_NUMBER(0.0, 0.0, 2e-5)

/* A phase as turns in [-0.5, 0.5). */
static inline double signed_turns(twd_phase phase)
{
    return (double)(int32_t)phase / 4294967296.0;
}

/* Any phase. */
static inline twd_phase uniform_phase(uint64_t *random)
{
    return (twd_phase)(uniform(random, 0.0, 1.0) * 4294967296.0);
}

#endif
