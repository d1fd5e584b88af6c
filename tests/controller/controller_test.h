/* controller_test.h: what the controller's tests share: cmocka with the headers it asks for, comparisons in double
 * precision, and a seeded generator that is not the library's. */
#ifndef TWIDDLE_CONTROLLER_TEST_H
#define TWIDDLE_CONTROLLER_TEST_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

#include <twiddle/number.h>

#define PI 3.14159265358979323846

#ifdef TWD_NUMBER_DOUBLE
#define BY_NUMBER(double_value, float_value) (double_value)
#else
#define BY_NUMBER(double_value, float_value) (float_value)
#endif

/* Assert that two numbers differ by at most `tolerance`; a result that is not a number fails. */
static inline void assert_close(twd_num actual, double expected, double tolerance)
{
    const double difference = fabs((double)actual - expected);
    if (!(difference <= tolerance)) {
        print_error("got %.12g, expected %.12g within %g\n", (double)actual, expected, tolerance);
        fail();
    }
}

/* A phase as turns in [-0.5, 0.5). */
static inline double signed_turns(twd_phase phase)
{
    const double turns = (double)phase / 4294967296.0;
    return turns < 0.5 ? turns : turns - 1.0;
}

/* Numerical Recipes' 64-bit linear congruential generator: the next number, uniform in [lower, upper). */
static inline double uniform(uint64_t *random, double lower, double upper)
{
    *random = *random * 6364136223846793005U + 1442695040888963407U;
    return lower + (upper - lower) * ((double)(*random >> 32) / 4294967296.0);
}

/* Any phase. */
static inline twd_phase uniform_phase(uint64_t *random)
{
    return (twd_phase)(uniform(random, 0.0, 1.0) * 4294967296.0);
}

#endif
