/* fixed/phase.h: phases, sines and cosines of the fixed build (phase.h). */
#ifndef TWIDDLE_FIXED_PHASE_H
#define TWIDDLE_FIXED_PHASE_H

TWD_BEGIN_DECLARATIONS

/* The largest turns below a half. */
#define TWD_LARGEST_HALF ((int32_t)0x07FFFFFF)

static inline twd_phase twd_phase_from_turns(twd_num turns)
{
    const twd_num limit = (twd_num)TWD_LARGEST_HALF;
    return (uint32_t)(int32_t)twd_clamp(turns, -limit, limit) << 4;
}

static inline twd_phase twd_phase_from_angle(twd_num angle_rad)
{
    const twd_num half_turn_rad = (twd_num)INT32_C(843314856); /* pi, rounded down */
    const int32_t word = (int32_t)twd_clamp(angle_rad, -half_turn_rad, half_turn_rad);
    /* 8 / (2 pi) of the word, and 2^1 before and 2^2 after the multiplication; the factor is 2^32 / pi. */
    return (uint32_t)twd_high_word(word * 2, INT32_C(1367130551)) << 2;
}

static inline twd_phase twd_phase_from_frequency(twd_num frequency_hz, twd_small tick_s)
{
    const int64_t product = twd_product((int32_t)frequency_hz, (int32_t)tick_s);
    return (uint32_t)twd_saturated_word(twd_rounded(product, TWD_NUM_BITS + TWD_SMALL_BITS - 32));
}

/* What turns a rate into the phase of a tick: 2^32 times half a tick's turns a rad/s, over 2^(TWD_WIDE_BITS + 3). */
typedef int32_t twd_turn_gain;

static inline twd_turn_gain twd_turn_gain_of_tick(twd_small tick_s)
{
    /* tick / (2 pi) 2^32 / 2 2^32 / 2^27, from a word of 2^34 a second. */
    return (int32_t)twd_rounded(twd_product((int32_t)tick_s, INT32_C(1367130551)), 31);
}

static inline twd_phase twd_phase_from_rates(twd_wide rate_rad_s, twd_wide last_rate_rad_s, twd_turn_gain gain)
{
    const uint32_t rate = (uint32_t)(int32_t)rate_rad_s;
    /* Eight times an extrapolated rate below 16 rad/s fills the word. */
    const uint32_t eight = (3U * rate - (uint32_t)(int32_t)last_rate_rad_s) << 2;
    return (uint32_t)twd_high_word((int32_t)eight, gain) << 1;
}

static inline twd_phase twd_phase_from_fraction(twd_num fraction)
{
    return (uint32_t)(int32_t)twd_clamp(fraction, TWD_NUM(0), TWD_NUM(1)) << 4;
}

static inline twd_num twd_cos_inline(twd_phase phase)
{
    /* s, half turns from the nearest multiple of half a turn, in [-1/2, 1/2), is the phase without its sign, and s^2
     * fits 2^-32 a unit. The polynomial needs only 16 bits of it. */
    const int32_t square = twd_high_word_of_square((int32_t)(phase << 1));
    const uint32_t short_square = (uint32_t)square & UINT32_C(0xFFFFC000);

    /* cos(pi s) = (1/4 - s^2) Q(s^2), so that the zeros are exact; Q(0) = 4 makes cos(0) = 1. Q is the cubic polynomial
     * of least maximum error, with the 16 bits of s^2, whose coefficients have 16 bits, too, which are cheap to load
     * and to multiply by: found by trying those around the best one; maximum error 3.0e-6. In units of 2^-28. */
    int32_t sum = -INT32_C(0x03C00000);
    sum = twd_add_mul_short(INT32_C(0x14880000), sum, short_square);
    sum = twd_add_mul_short(-INT32_C(0x3BD60000), sum, short_square);
    sum = twd_add_mul_short(INT32_C(0x40000000), sum, short_square);
    const int32_t cosine = twd_high_word(INT32_C(0x40000000) - square, sum);

    /* The second and the third quarter turn are the first and the last with the other sign. */
    const int32_t sign = (int32_t)(phase ^ (phase << 1)) >> 31;
    return (twd_num)((cosine ^ sign) - sign);
}

#if defined(TWD_MULTIPLIES_BY_PIECES)
/* Not inline: the many registers of its pieces are better off on their own. */
twd_num twd_cos(twd_phase phase);
#else
static inline twd_num twd_cos(twd_phase phase)
{
    return twd_cos_inline(phase);
}
#endif

static inline twd_num twd_sin(twd_phase phase)
{
    return twd_cos(phase - TWD_QUARTER_TURN);
}

static inline void twd_sine_cosine(twd_phase phase, twd_num *sine, twd_num *cosine)
{
    *sine = twd_sin(phase);
    *cosine = twd_cos(phase);
}

static inline void twd_sine_cosine_of_angle(twd_num angle_rad, twd_num *sine, twd_num *cosine)
{
    twd_sine_cosine(twd_phase_from_angle(angle_rad), sine, cosine);
}

TWD_END_DECLARATIONS

#endif
