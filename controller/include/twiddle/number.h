/* number.h: the one number type of the library, and its operations.
 *
 * The build chooses it: TWD_NUMBER_FLOAT (default) or TWD_NUMBER_DOUBLE. Sums, differences and comparisons are
 * native; products and quotients are named functions, so that a build with another number format
 * has one place to define them. Nothing here calls libm. */
#ifndef TWIDDLE_NUMBER_H
#define TWIDDLE_NUMBER_H

#include <stdbool.h>
#include <stdint.h>

#if defined(TWD_NUMBER_DOUBLE)
typedef double twd_num;
#define TWD_NUMBER_NAME "double"
#else
#ifndef TWD_NUMBER_FLOAT
#define TWD_NUMBER_FLOAT
#endif
typedef float twd_num;
#define TWD_NUMBER_NAME "float"
#endif

/* A constant of type twd_num. */
#define TWD_NUM(value) ((twd_num)(value))

/* An angle on the circle: 2^32 is one turn, and overflow is the wrap-around. */
typedef uint32_t twd_phase;

/* a * b */
static inline twd_num twd_mul(twd_num a, twd_num b)
{
    return a * b;
}

/* a / b, b not zero */
static inline twd_num twd_div(twd_num a, twd_num b)
{
    return a / b;
}

/* part / whole for |part| <= whole, whole > 0, both below 2^24 where the result must be exact to the last bit of a
 * float */
static inline twd_num twd_ratio(int32_t part, int32_t whole)
{
    return (twd_num)part / (twd_num)whole;
}

/* The nearest value to `value` in [lower, upper]; a value that is not a number becomes `lower`. */
static inline twd_num twd_clamp(twd_num value, twd_num lower, twd_num upper)
{
    const twd_num raised = value > lower ? value : lower;
    return raised < upper ? raised : upper;
}

/* Whether `value` lies in [lower, upper]; false if it is not a number. */
static inline bool twd_within(twd_num value, twd_num lower, twd_num upper)
{
    return value >= lower && value <= upper;
}

#endif
