/* convert.h: numbers of the library from and to double, for hosts, tests and chips with double arithmetic.
 *
 * In the fixed build a value is rounded to nearest and stays at the ends of its type's range; what is not finite
 * becomes the one word that is no number, which a set-up refuses and a tick counts as an input that is not usable. */
#ifndef TWIDDLE_CONVERT_H
#define TWIDDLE_CONVERT_H

#include <twiddle/number.h>

TWD_BEGIN_DECLARATIONS

#if defined(TWD_NUMBER_FIXED)

#define TWD_NO_NUMBER_WORD INT32_MIN

/* `value` in units of 1 / `one`. */
static inline int32_t twd_word_from_double(double value, double one)
{
    const double scaled = value * one;
    /* An infinity less itself is not a number. */
    if (!(value - value <= 0)) return TWD_NO_NUMBER_WORD;
    if (scaled >= (double)INT32_MAX) return INT32_MAX;
    if (scaled <= -(double)INT32_MAX) return -INT32_MAX;
    return (int32_t)(scaled < 0 ? scaled - 0.5 : scaled + 0.5);
}

static inline twd_num twd_num_from_double(double value)
{
    return (twd_num)twd_word_from_double(value, 268435456.0);
}

static inline twd_wide twd_wide_from_double(double value)
{
    return (twd_wide)twd_word_from_double(value, 16777216.0);
}

static inline twd_rate twd_rate_from_double(double value)
{
    return (twd_rate)twd_word_from_double(value, 1048576.0);
}

static inline twd_small twd_small_from_double(double value)
{
    return (twd_small)twd_word_from_double(value, 17179869184.0);
}

static inline double twd_num_to_double(twd_num value)
{
    return (double)(int32_t)value / 268435456.0;
}

static inline double twd_wide_to_double(twd_wide value)
{
    return (double)(int32_t)value / 16777216.0;
}

static inline double twd_rate_to_double(twd_rate value)
{
    return (double)(int32_t)value / 1048576.0;
}

static inline double twd_small_to_double(twd_small value)
{
    return (double)(int32_t)value / 17179869184.0;
}

#else

static inline twd_num twd_num_from_double(double value)
{
    return (twd_num)value;
}

static inline twd_wide twd_wide_from_double(double value)
{
    return (twd_wide)value;
}

static inline twd_rate twd_rate_from_double(double value)
{
    return (twd_rate)value;
}

static inline twd_small twd_small_from_double(double value)
{
    return (twd_small)value;
}

static inline double twd_num_to_double(twd_num value)
{
    return (double)value;
}

static inline double twd_wide_to_double(twd_wide value)
{
    return (double)value;
}

static inline double twd_rate_to_double(twd_rate value)
{
    return (double)value;
}

static inline double twd_small_to_double(twd_small value)
{
    return (double)value;
}

#endif

TWD_END_DECLARATIONS

#endif
