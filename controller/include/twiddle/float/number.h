/* float/number.h: the numbers of the float and double builds (number.h). One type for all quantities, native
 * operations; nothing saturates before infinity. */
#ifndef TWIDDLE_FLOAT_NUMBER_H
#define TWIDDLE_FLOAT_NUMBER_H

TWD_BEGIN_DECLARATIONS

#if defined(TWD_NUMBER_DOUBLE)
typedef double twd_num;
#else
typedef float twd_num;
#endif
typedef twd_num twd_wide;
typedef twd_num twd_rate;
typedef twd_num twd_small;

/* A constant of each type. */
#define TWD_NUM(value) ((twd_num)(value))
#define TWD_WIDE(value) ((twd_wide)(value))
#define TWD_RATE(value) ((twd_rate)(value))
#define TWD_SMALL(value) ((twd_small)(value))

/* A constant with more than 24 significant bits; `word` is for the fixed build. */
#define TWD_NUM_CONSTANT(value, word) TWD_NUM(value)
#define TWD_WIDE_CONSTANT(value, word) TWD_WIDE(value)
#define TWD_RATE_CONSTANT(value, word) TWD_RATE(value)
#define TWD_SMALL_CONSTANT(value, word) TWD_SMALL(value)

/* The set-up refuses, and the tick counts, what is larger, in whatever unit; so no product of two overflows to
 * infinity, and no difference of such products fails to be a number. */
#define TWD_LARGEST_NUM TWD_NUM(1e6)
#define TWD_LARGEST_RATE TWD_RATE(1e6)

/* The largest product of a filter's rate and the tick, and the largest sum of the moments of a finger's links, N m. */
#define TWD_LARGEST_RATE_TIMES_TICK TWD_NUM(32)
#define TWD_LARGEST_MOMENT_NM TWD_NUM(1e6)

/* a * b */
static inline twd_num twd_mul(twd_num a, twd_num b)
{
    return a * b;
}

/* a * b, where the fixed build may round down to a multiple of 2^-24 */
static inline twd_num twd_mul_short(twd_num a, twd_num b)
{
    return a * b;
}

/* a * b; saturated */
static inline twd_num twd_mul_saturated(twd_num a, twd_num b)
{
    return a * b;
}

/* a + b; saturated */
static inline twd_num twd_add_saturated(twd_num a, twd_num b)
{
    return a + b;
}

/* a - b; saturated */
static inline twd_num twd_subtract_saturated(twd_num a, twd_num b)
{
    return a - b;
}

/* a / b, b not zero; saturated */
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

/* a * b as a wide number, where the fixed build rounds down */
static inline twd_wide twd_wide_product(twd_num a, twd_num b)
{
    return a * b;
}

/* a * b; saturated */
static inline twd_wide twd_wide_mul(twd_num a, twd_wide b)
{
    return a * b;
}

/* a + b; saturated */
static inline twd_wide twd_wide_add(twd_wide a, twd_wide b)
{
    return a + b;
}

/* a - b; saturated */
static inline twd_wide twd_wide_subtract(twd_wide a, twd_wide b)
{
    return a - b;
}

/* a / b, b not zero; saturated */
static inline twd_wide twd_wide_div(twd_wide a, twd_wide b)
{
    return a / b;
}

/* a / 2 */
static inline twd_wide twd_wide_half(twd_wide a)
{
    return a * TWD_WIDE(0.5);
}

/* Products and quotients of two types, named after the result; saturated. */
static inline twd_num twd_num_of_wide(twd_wide a)
{
    return a;
}

static inline twd_wide twd_wide_of_num(twd_num a)
{
    return a;
}

static inline twd_num twd_num_mul_wide(twd_num a, twd_wide b)
{
    return a * b;
}

static inline twd_num twd_num_mul_rate(twd_num a, twd_rate b)
{
    return a * b;
}

static inline twd_num twd_num_mul_small(twd_num a, twd_small b)
{
    return a * b;
}

static inline twd_num twd_num_div_wide(twd_num a, twd_wide b)
{
    return a / b;
}

static inline twd_num twd_num_mul_rate_small(twd_rate a, twd_small b)
{
    return a * b;
}

/* The velocity of a joint that turned by a in the period b. */
static inline twd_rate twd_rate_div_small(twd_num a, twd_small b)
{
    return a / b;
}

static inline twd_small twd_small_mul(twd_num a, twd_small b)
{
    return a * b;
}

static inline twd_small twd_small_half(twd_small a)
{
    return a * TWD_SMALL(0.5);
}

static inline twd_wide twd_wide_div_small(twd_small a, twd_small b)
{
    return a / b;
}

/* The nearest value to `value` in [lower, upper]; a value that is not a number becomes `lower`. */
static inline twd_num twd_clamp(twd_num value, twd_num lower, twd_num upper)
{
    const twd_num raised = value > lower ? value : lower;
    return raised < upper ? raised : upper;
}

static inline twd_wide twd_wide_clamp(twd_wide value, twd_wide lower, twd_wide upper)
{
    return twd_clamp(value, lower, upper);
}

/* Whether `value` lies in [lower, upper]; false if it is not a number. */
static inline bool twd_within(twd_num value, twd_num lower, twd_num upper)
{
    return value >= lower && value <= upper;
}

/* False for infinities and for what is not a number: there the difference is not a number. */
static inline bool twd_wide_is_finite(twd_wide value)
{
    return twd_within(value - value, TWD_NUM(0), TWD_NUM(0));
}

/* Whether `value` is a number of a size that the library computes with. */
static inline bool twd_is_usable(twd_num value)
{
    return twd_within(value, -TWD_LARGEST_NUM, TWD_LARGEST_NUM);
}

static inline bool twd_wide_is_usable(twd_wide value)
{
    return twd_within(value, -TWD_LARGEST_NUM, TWD_LARGEST_NUM);
}

static inline bool twd_small_is_usable(twd_small value)
{
    return twd_within(value, -TWD_LARGEST_NUM, TWD_LARGEST_NUM);
}

static inline bool twd_rate_is_usable(twd_rate value)
{
    return twd_within(value, -TWD_LARGEST_RATE, TWD_LARGEST_RATE);
}

TWD_END_DECLARATIONS

#endif
