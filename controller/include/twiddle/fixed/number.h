/* fixed/number.h: the numbers of the fixed build (number.h): 32-bit words, exact and the same on every core.
 *
 * With TWD_STRICT_TYPES, for C++ alone, each format is a class without `*` and `/` (fixed/strict.hpp), and a compiler
 * finds every place that forgets a format; the code below is the same, since a cast to a format makes a number of its
 * word and a cast to int32_t gives the word back. The largest negative word is no number (convert.h); no operation
 * makes it. A right shift of a negative word is taken to keep the sign, as all compilers that we know do; a test holds
 * them to it. */
#ifndef TWIDDLE_FIXED_NUMBER_H
#define TWIDDLE_FIXED_NUMBER_H

#if defined(TWD_STRICT_TYPES)
#include <twiddle/fixed/strict.hpp>
#endif

TWD_BEGIN_DECLARATIONS

#if !defined(TWD_STRICT_TYPES)
typedef int32_t twd_num;
typedef int32_t twd_wide;
typedef int32_t twd_rate;
typedef int32_t twd_small;
#endif

/* Bits behind the point. */
#define TWD_NUM_BITS 28
#define TWD_WIDE_BITS 24
#define TWD_RATE_BITS 20
#define TWD_SMALL_BITS 34

/* A constant of each type, rounded to nearest. A compiler whose double has 24 bits (avr-gcc) rounds it to these before;
 * a half added to such a number could round it once more, so what the truncation leaves over decides. */
#define TWD_FIXED_WORD(value, one)                                                                                     \
    ((int32_t)((value) * (one)) + (int32_t)(2.0 * ((value) * (one) - (double)(int32_t)((value) * (one)))))
#define TWD_NUM(value) ((twd_num)TWD_FIXED_WORD(value, 268435456.0))
#define TWD_WIDE(value) ((twd_wide)TWD_FIXED_WORD(value, 16777216.0))
#define TWD_RATE(value) ((twd_rate)TWD_FIXED_WORD(value, 1048576.0))
#define TWD_SMALL(value) ((twd_small)TWD_FIXED_WORD(value, 17179869184.0))

/* A constant with more than 24 significant bits, given as its word too, so that it is the same wherever it is compiled;
 * the strict compile holds one against the other. */
#if defined(TWD_STRICT_TYPES)
#define TWD_NUM_CONSTANT(value, word) (twd_strict::checked(TWD_NUM(value), word))
#define TWD_WIDE_CONSTANT(value, word) (twd_strict::checked(TWD_WIDE(value), word))
#define TWD_RATE_CONSTANT(value, word) (twd_strict::checked(TWD_RATE(value), word))
#define TWD_SMALL_CONSTANT(value, word) (twd_strict::checked(TWD_SMALL(value), word))
#else
#define TWD_NUM_CONSTANT(value, word) ((twd_num)(word))
#define TWD_WIDE_CONSTANT(value, word) ((twd_wide)(word))
#define TWD_RATE_CONSTANT(value, word) ((twd_rate)(word))
#define TWD_SMALL_CONSTANT(value, word) ((twd_small)(word))
#endif

/* The largest product of a filter's rate and the tick (fixed/filter.h), and the largest sum of the moments of a
 * finger's links, N m: no torque that they cause leaves the range. */
#define TWD_LARGEST_RATE_TIMES_TICK TWD_NUM(1.375)
#define TWD_LARGEST_MOMENT_NM TWD_NUM(4)

/* Cores without a multiplication of 32 by 32 bits to 64 put it together from pieces of 16. */
#if defined(__ARM_ARCH_6M__)
#define TWD_MULTIPLIES_BY_PIECES
#endif

/* Cores whose multiplication can leave out the low word; compilers do not use it for the C below. */
#if defined(__GNUC__) && defined(__ARM_FEATURE_DSP) && defined(__thumb2__)
#define TWD_HAS_SMMUL
#endif

/* The low 16 bits of `word`. */
static inline uint32_t twd_low_half(int32_t word)
{
#if defined(__GNUC__) && defined(__ARM_ARCH_6M__)
    /* One instruction, for which compilers take two; of a constant they know the half. */
    if (__builtin_constant_p(word)) return (uint32_t)word & 0xFFFFU;
    uint32_t half;
    __asm__("uxth %0, %1" : "=l"(half) : "l"(word));
    return half;
#else
    return (uint32_t)word & 0xFFFFU;
#endif
}

/* floor(a b / 2^32) */
static inline int32_t twd_high_word_of_pieces(int32_t a, int32_t b)
{
    const uint32_t a_low = twd_low_half(a);
    const uint32_t b_low = twd_low_half(b);
    const int32_t a_high = a >> 16;
    const int32_t b_high = b >> 16;
    /* Neither sum overflows: |a_high b_low| is at most 2^15 (2^16 - 1), and what is added below 2^16. */
    const int32_t first = a_high * (int32_t)b_low + (int32_t)((a_low * b_low) >> 16);
    const int32_t second = (int32_t)a_low * b_high + (int32_t)twd_low_half(first);
    return a_high * b_high + (first >> 16) + (second >> 16);
}

static inline int32_t twd_high_word(int32_t a, int32_t b)
{
#if defined(TWD_MULTIPLIES_BY_PIECES)
    return twd_high_word_of_pieces(a, b);
#elif defined(TWD_HAS_SMMUL)
    int32_t high;
    __asm__("smmul %0, %1, %2" : "=r"(high) : "r"(a), "r"(b));
    return high;
#else
    return (int32_t)(((int64_t)a * b) >> 32);
#endif
}

/* sum + floor(a b / 2^32), where that is one word */
static inline int32_t twd_add_high_word(int32_t sum, int32_t a, int32_t b)
{
#if defined(TWD_HAS_SMMUL)
    int32_t result;
    __asm__("smmla %0, %1, %2, %3" : "=r"(result) : "r"(a), "r"(b), "r"(sum));
    return result;
#else
    return sum + twd_high_word(a, b);
#endif
}

/* a b */
static inline int64_t twd_product_of_pieces(int32_t a, int32_t b)
{
    const uint32_t high = (uint32_t)twd_high_word_of_pieces(a, b);
    return (int64_t)(((uint64_t)high << 32) | ((uint32_t)a * (uint32_t)b));
}

static inline int64_t twd_product(int32_t a, int32_t b)
{
#if defined(TWD_MULTIPLIES_BY_PIECES)
    return twd_product_of_pieces(a, b);
#else
    return (int64_t)a * b;
#endif
}

/* floor(a a / 2^32) */
static inline int32_t twd_high_word_of_square_of_pieces(int32_t a)
{
    const uint32_t low = twd_low_half(a);
    const int32_t high = a >> 16;
    const int32_t mixed = high * (int32_t)low + (int32_t)((low * low) >> 17);
    return high * high + (mixed >> 15);
}

static inline int32_t twd_high_word_of_square(int32_t a)
{
#if defined(TWD_MULTIPLIES_BY_PIECES)
    return twd_high_word_of_square_of_pieces(a);
#else
    return (int32_t)(((int64_t)a * a) >> 32);
#endif
}

/* floor(a factor / 2^(16 + shift)), for a factor of at most 2^16 and a shift of 0 to 16: cheaper than
 * twd_high_word on cores that multiply by pieces, and as cheap on the others. */
static inline int32_t twd_scaled_by_pieces(int32_t a, uint32_t factor, unsigned shift)
{
    const uint32_t low = twd_low_half(a);
    const int32_t high = a >> 16;
    return (high * (int32_t)factor + (int32_t)((low * factor) >> 16)) >> shift;
}

/* sum + floor(a short_word / 2^32), for a word from 0 to 2^30 whose lowest 14 bits are 0. */
static inline int32_t twd_add_mul_short(int32_t sum, int32_t a, uint32_t short_word)
{
#if defined(TWD_MULTIPLIES_BY_PIECES)
    return sum + twd_scaled_by_pieces(a, short_word >> 14, 2);
#else
    return twd_add_high_word(sum, a, (int32_t)short_word);
#endif
}

/* A factor from 0 to below a half, of 16 bits behind its leading zeros: as cores with a long multiplication use it, in
 * units of 2^-32, and as cores that multiply by pieces do. */
#if defined(TWD_MULTIPLIES_BY_PIECES)
typedef struct {
    uint16_t digits;
    uint16_t shift; /* 1..16; digits are in units of 2^-(16 + shift) */
} twd_factor;
#else
typedef int32_t twd_factor;
#endif

/* The factor nearest to `value`, in [0, 1/2), with as many leading zeros. */
static inline twd_factor twd_factor_of_num(twd_num value)
{
    uint32_t word = (uint32_t)(int32_t)value;
    uint16_t shift = 0;
    while (word < ((uint32_t)1 << (TWD_NUM_BITS - 2)) && shift < 15) {
        word *= 2;
        shift++;
    }
    const uint32_t rounded = (word + ((uint32_t)1 << 10)) >> 11;
    const uint32_t digits = rounded > UINT16_MAX ? UINT16_MAX : rounded;
#if defined(TWD_MULTIPLIES_BY_PIECES)
    const twd_factor factor = {(uint16_t)digits, (uint16_t)(shift + 1U)};
    return factor;
#else
    return (int32_t)(digits << (15 - shift));
#endif
}

/* The factor in units of 2^-32, the same on every core; one to subtract by is negative where it is kept so. */
static inline int32_t twd_factor_word(twd_factor factor)
{
#if defined(TWD_MULTIPLIES_BY_PIECES)
    return (int32_t)((uint32_t)factor.digits << (16U - factor.shift));
#else
    return factor;
#endif
}

/* sum + floor(a factor) */
static inline int32_t twd_add_mul_factor(int32_t sum, int32_t a, twd_factor factor)
{
#if defined(TWD_MULTIPLIES_BY_PIECES)
    return sum + twd_scaled_by_pieces(a, factor.digits, factor.shift);
#else
    return twd_add_high_word(sum, a, factor);
#endif
}

/* A factor to subtract by: kept as its negative where it is a word. */
static inline twd_factor twd_factor_to_subtract(twd_num value)
{
#if defined(TWD_MULTIPLIES_BY_PIECES)
    return twd_factor_of_num(value);
#else
    return -twd_factor_of_num(value);
#endif
}

/* sum + floor(-a factor), for a factor to subtract by */
static inline int32_t twd_subtract_mul_factor(int32_t sum, int32_t a, twd_factor factor)
{
#if defined(TWD_MULTIPLIES_BY_PIECES)
    return twd_add_mul_factor(sum, -a, factor);
#else
    return twd_add_mul_factor(sum, a, factor);
#endif
}

/* product / 2^bits, rounded to nearest, a half upwards */
static inline int64_t twd_rounded(int64_t product, unsigned bits)
{
    return (product + ((int64_t)1 << (bits - 1U))) >> bits;
}

static inline int32_t twd_saturated_word(int64_t value)
{
    if (value > INT32_MAX) return INT32_MAX;
    return value < -INT32_MAX ? -INT32_MAX : (int32_t)value;
}

/* numerator / denominator, rounded to nearest, a half away from 0; saturated; a denominator of 0 counts as the smallest
 * number. */
static inline int32_t twd_quotient_word(int64_t numerator, int32_t denominator)
{
    const uint64_t size = numerator < 0 ? 0U - (uint64_t)numerator : (uint64_t)numerator;
    const uint32_t divisor = denominator < 0 ? 0U - (uint32_t)denominator : (uint32_t)denominator;
    const uint64_t quotient = divisor == 0 ? size : (size + divisor / 2U) / divisor;
    const int32_t limited = quotient > INT32_MAX ? INT32_MAX : (int32_t)quotient;
    return (numerator < 0) != (denominator < 0) ? -limited : limited;
}

/* The operations, as float/number.h describes them. */

static inline twd_num twd_mul(twd_num a, twd_num b)
{
    return (twd_num)(int32_t)twd_rounded(twd_product((int32_t)a, (int32_t)b), TWD_NUM_BITS);
}

static inline twd_num twd_mul_short(twd_num a, twd_num b)
{
    return (twd_num)(int32_t)((uint32_t)twd_high_word((int32_t)a, (int32_t)b) << 4);
}

static inline twd_num twd_mul_saturated(twd_num a, twd_num b)
{
    return (twd_num)twd_saturated_word(twd_rounded(twd_product((int32_t)a, (int32_t)b), TWD_NUM_BITS));
}

static inline twd_num twd_add_saturated(twd_num a, twd_num b)
{
    return (twd_num)twd_saturated_word((int64_t)(int32_t)a + (int32_t)b);
}

static inline twd_num twd_subtract_saturated(twd_num a, twd_num b)
{
    return (twd_num)twd_saturated_word((int64_t)(int32_t)a - (int32_t)b);
}

static inline twd_num twd_div(twd_num a, twd_num b)
{
    return (twd_num)twd_quotient_word((int64_t)(int32_t)a * ((int64_t)1 << TWD_NUM_BITS), (int32_t)b);
}

static inline twd_num twd_ratio(int32_t part, int32_t whole)
{
    return (twd_num)twd_quotient_word((int64_t)part * ((int64_t)1 << TWD_NUM_BITS), whole);
}

static inline twd_wide twd_wide_product(twd_num a, twd_num b)
{
    return (twd_wide)twd_high_word((int32_t)a, (int32_t)b);
}

static inline twd_wide twd_wide_mul(twd_num a, twd_wide b)
{
    return (twd_wide)twd_saturated_word(twd_rounded(twd_product((int32_t)a, (int32_t)b), TWD_NUM_BITS));
}

static inline twd_wide twd_wide_add(twd_wide a, twd_wide b)
{
    return (twd_wide)twd_saturated_word((int64_t)(int32_t)a + (int32_t)b);
}

static inline twd_wide twd_wide_subtract(twd_wide a, twd_wide b)
{
    return (twd_wide)twd_saturated_word((int64_t)(int32_t)a - (int32_t)b);
}

static inline twd_wide twd_wide_div(twd_wide a, twd_wide b)
{
    return (twd_wide)twd_quotient_word((int64_t)(int32_t)a * ((int64_t)1 << TWD_WIDE_BITS), (int32_t)b);
}

static inline twd_wide twd_wide_half(twd_wide a)
{
    return (twd_wide)((int32_t)a >> 1);
}

static inline twd_num twd_num_of_wide(twd_wide a)
{
    return (twd_num)twd_saturated_word((int64_t)(int32_t)a * 16);
}

static inline twd_wide twd_wide_of_num(twd_num a)
{
    return (twd_wide)((int32_t)a >> (TWD_NUM_BITS - TWD_WIDE_BITS));
}

static inline twd_num twd_num_mul_wide(twd_num a, twd_wide b)
{
    return (twd_num)twd_saturated_word(twd_rounded(twd_product((int32_t)a, (int32_t)b), TWD_WIDE_BITS));
}

static inline twd_num twd_num_mul_rate(twd_num a, twd_rate b)
{
    return (twd_num)twd_saturated_word(twd_rounded(twd_product((int32_t)a, (int32_t)b), TWD_RATE_BITS));
}

static inline twd_num twd_num_mul_small(twd_num a, twd_small b)
{
    return (twd_num)twd_saturated_word(twd_rounded(twd_product((int32_t)a, (int32_t)b), TWD_SMALL_BITS));
}

static inline twd_num twd_num_div_wide(twd_num a, twd_wide b)
{
    return (twd_num)twd_quotient_word((int64_t)(int32_t)a * ((int64_t)1 << TWD_WIDE_BITS), (int32_t)b);
}

static inline twd_num twd_num_mul_rate_small(twd_rate a, twd_small b)
{
    const unsigned bits = TWD_RATE_BITS + TWD_SMALL_BITS - TWD_NUM_BITS;
    return (twd_num)twd_saturated_word(twd_rounded(twd_product((int32_t)a, (int32_t)b), bits));
}

static inline twd_rate twd_rate_div_small(twd_num a, twd_small b)
{
    const unsigned bits = TWD_RATE_BITS + TWD_SMALL_BITS - TWD_NUM_BITS;
    return (twd_rate)twd_quotient_word((int64_t)(int32_t)a * ((int64_t)1 << bits), (int32_t)b);
}

static inline twd_small twd_small_mul(twd_num a, twd_small b)
{
    return (twd_small)twd_saturated_word(twd_rounded(twd_product((int32_t)a, (int32_t)b), TWD_NUM_BITS));
}

static inline twd_small twd_small_half(twd_small a)
{
    return (twd_small)((int32_t)a >> 1);
}

static inline twd_wide twd_wide_div_small(twd_small a, twd_small b)
{
    return (twd_wide)twd_quotient_word((int64_t)(int32_t)a * ((int64_t)1 << TWD_WIDE_BITS), (int32_t)b);
}

static inline twd_num twd_clamp(twd_num value, twd_num lower, twd_num upper)
{
    const twd_num raised = value > lower ? value : lower;
    return raised < upper ? raised : upper;
}

static inline twd_wide twd_wide_clamp(twd_wide value, twd_wide lower, twd_wide upper)
{
    const twd_wide raised = value > lower ? value : lower;
    return raised < upper ? raised : upper;
}

static inline bool twd_within(twd_num value, twd_num lower, twd_num upper)
{
    return value >= lower && value <= upper;
}

static inline bool twd_wide_is_finite(twd_wide value)
{
    return (int32_t)value != INT32_MIN;
}

/* A word at an end of its range may have been saturated, and is not used. */
static inline bool twd_word_is_inside(int32_t word)
{
    return word > -INT32_MAX && word < INT32_MAX;
}

static inline bool twd_is_usable(twd_num value)
{
    return twd_word_is_inside((int32_t)value);
}

static inline bool twd_wide_is_usable(twd_wide value)
{
    return twd_word_is_inside((int32_t)value);
}

static inline bool twd_small_is_usable(twd_small value)
{
    return twd_word_is_inside((int32_t)value);
}

static inline bool twd_rate_is_usable(twd_rate value)
{
    return twd_word_is_inside((int32_t)value);
}

TWD_END_DECLARATIONS

#endif
