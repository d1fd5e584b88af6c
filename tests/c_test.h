/* c_test.h: what all C tests share: cmocka with the headers it asks for, values by number build, comparisons in double
 * precision, and a seeded generator that is not the library's.
 *
 * The tests run on chips as well: they print by cmocka alone, keep large objects static, use less than 4 KiB of stack,
 * and know an int of 16 bits and a double of 24 (AVR). */
#ifndef TWIDDLE_C_TEST_H
#define TWIDDLE_C_TEST_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <float.h>
#include <math.h>
#include <string.h>

#include <twiddle/convert.h>
#include <twiddle/number.h>

/* The value for this number build. */
#if defined(TWD_NUMBER_DOUBLE)
#define BY_NUMBER(double_value, float_value, fixed_value) (double_value)
#elif defined(TWD_NUMBER_FIXED)
#define BY_NUMBER(double_value, float_value, fixed_value) (fixed_value)
#else
#define BY_NUMBER(double_value, float_value, fixed_value) (float_value)
#endif

/* Steps of the fixed build's numbers, for its tolerances: a conversion to a number errs by half a step. */
#define NUM_STEP (1.0 / 268435456.0) /* twd_num, 2^-28 */
#define WIDE_STEP (1.0 / 16777216.0) /* twd_wide, 2^-24 */
#define RATE_STEP (1.0 / 1048576.0)  /* twd_rate, 2^-20 */

/* What the expected values themselves err by, for each unit of size: nothing to speak of, but where double has 24
 * bits. */
#if DBL_MANT_DIG >= 53
#define REFERENCE_ERROR 0.0
#else
#define REFERENCE_ERROR 2e-6
#endif

/* Chips are slower than hosts: with -DTWD_TEST_THINNING=n, random cases are about n times fewer. */
#ifndef TWD_TEST_THINNING
#define TWD_TEST_THINNING 1
#endif
#define CASES(count) ((int32_t)(((count) + TWD_TEST_THINNING - 1L) / TWD_TEST_THINNING))

/* Assert that two values differ by at most `tolerance`; a value that is not a number fails. */
static inline void assert_close(double actual, double expected, double tolerance)
{
    const double difference = fabs(actual - expected);
    if (!(difference <= tolerance + REFERENCE_ERROR * (1.0 + fabs(expected)))) {
        print_error("got %.12g, expected %.12g within %g\n", actual, expected, tolerance);
        fail();
    }
}

static inline void assert_num_close(twd_num actual, double expected, double tolerance)
{
    assert_close(twd_num_to_double(actual), expected, tolerance);
}

static inline void assert_wide_close(twd_wide actual, double expected, double tolerance)
{
    assert_close(twd_wide_to_double(actual), expected, tolerance);
}

/* Assert that the largest of many errors, of values of size 1, keeps its bound. */
static inline void assert_bound(double largest_error, double bound)
{
    assert_close(largest_error, 0.0, bound);
}

/* Fill an object with a pattern, and assert later that a function which refused has written nothing to it. */
static inline void mark(void *object, size_t size)
{
    memset(object, 0x5A, size);
}

static inline void assert_marked(const void *object, size_t size)
{
    const unsigned char *const byte = object;
    for (size_t i = 0; i < size; i++)
        assert_int_equal(byte[i], 0x5A);
}

/* A checksum of an object (32-bit FNV-1a), to tell whether it changed without a second one of its size. */
static inline uint32_t checksum(const void *object, size_t size)
{
    const unsigned char *const byte = object;
    uint32_t hash = UINT32_C(2166136261);
    for (size_t i = 0; i < size; i++)
        hash = (hash ^ byte[i]) * UINT32_C(16777619);
    return hash;
}

/* Numerical Recipes' 64-bit linear congruential generator: the next number, uniform in [lower, upper). */
static inline double uniform(uint64_t *random, double lower, double upper)
{
    *random = *random * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return lower + (upper - lower) * ((double)(*random >> 32) / 4294967296.0);
}

#endif
