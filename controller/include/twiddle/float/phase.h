/* float/phase.h: phases, sines and cosines of the float and double builds (phase.h). */
#ifndef TWIDDLE_FLOAT_PHASE_H
#define TWIDDLE_FLOAT_PHASE_H

TWD_BEGIN_DECLARATIONS

/* The first two functions are the only places where the two scales meet: numbers, and phases of 2^32 a turn. */

/* The phase of `turns` in [-0.5, 0.5), rounded towards zero. */
static inline twd_phase twd_phase_of_signed_turns(twd_num turns)
{
    return (uint32_t)(int32_t)(turns * TWD_NUM(4294967296.0));
}

/* A phase as quarter turns in [-2, 2). */
static inline twd_num twd_quarters_of_phase(twd_phase phase)
{
    return (twd_num)(int32_t)phase * TWD_NUM(1.0 / 1073741824.0);
}

/* The phase of `turns`, any value in (-0.5, 0.5); values beyond are clamped to just inside. */
static inline twd_phase twd_phase_from_turns(twd_num turns)
{
    /* The largest number below a half that a float holds, so that the limits are the same in every number build. */
    const twd_num limit = TWD_NUM(0.499999970197677612);
    return twd_phase_of_signed_turns(twd_clamp(turns, -limit, limit));
}

/* The phase of `angle_rad`, in [-pi, pi]; values beyond are clamped. */
static inline twd_phase twd_phase_from_angle(twd_num angle_rad)
{
    return twd_phase_from_turns(twd_mul(angle_rad, TWD_NUM(0.15915494309189535)));
}

/* The phase that a frequency advances in a tick. */
static inline twd_phase twd_phase_from_frequency(twd_num frequency_hz, twd_small tick_s)
{
    return twd_phase_from_turns(twd_mul(frequency_hz, tick_s));
}

/* What turns a rate into the phase of a tick, in units of 2^-32 turn. */
typedef twd_num twd_turn_gain;

static inline twd_turn_gain twd_turn_gain_of_tick(twd_small tick_s)
{
    return twd_mul(tick_s, TWD_NUM(683565275.57643159)); /* 2^32 / (2 pi) */
}

static inline twd_phase twd_phase_from_rates(twd_wide rate_rad_s, twd_wide last_rate_rad_s, twd_turn_gain gain)
{
    /* The largest number below 2^31 that a float holds. */
    const twd_num limit = TWD_NUM(2147483520);
    const twd_num extrapolated = rate_rad_s + twd_mul(rate_rad_s - last_rate_rad_s, TWD_NUM(0.5));
    return (uint32_t)(int32_t)twd_clamp(twd_mul(extrapolated, gain), -limit, limit);
}

/* The phase of `fraction` of a turn, in [0, 1]; 1 wraps to 0. */
static inline twd_phase twd_phase_from_fraction(twd_num fraction)
{
    const twd_num turns = twd_clamp(fraction, TWD_NUM(0), TWD_NUM(1));
    return twd_phase_of_signed_turns(turns < TWD_NUM(0.5) ? turns : turns - TWD_NUM(1));
}

/* Of u^2, from u^8 down: the polynomial of least maximum error for sin(pi/2 u) on [-1, 1] in u, u^3, ... u^9, less u.
 * Remez exchange in 40-digit arithmetic; maximum error 3.4e-9. */
#define TWD_SINE_4 TWD_NUM(0.00015082056718197074)
#define TWD_SINE_3 TWD_NUM(-0.0046722279289435442)
#define TWD_SINE_2 TWD_NUM(0.079688480544303229)
#define TWD_SINE_1 TWD_NUM(-0.64596335986686903)
#define TWD_SINE_0 TWD_NUM(0.5707962900224310)

/* sin(2 pi phase / 2^32). Error at most 1e-8 (double), 2e-7 (float). */
static inline twd_num twd_sin(twd_phase phase)
{
    /* The second and third quarter are folded onto the first and fourth: sin(theta) = sin(half a turn - theta). */
    const twd_phase folded = phase + TWD_QUARTER_TURN < TWD_HALF_TURN ? phase : TWD_HALF_TURN - phase;

    /* One u stands apart, so that the rounded sum is a small part of the result. */
    const twd_num u = twd_quarters_of_phase(folded);
    const twd_num square = twd_mul(u, u);
    twd_num sum = TWD_SINE_4;
    sum = twd_mul(sum, square) + TWD_SINE_3;
    sum = twd_mul(sum, square) + TWD_SINE_2;
    sum = twd_mul(sum, square) + TWD_SINE_1;
    sum = twd_mul(sum, square) + TWD_SINE_0;
    return u + twd_mul(sum, u);
}

/* cos(2 pi phase / 2^32), same error as twd_sin. */
static inline twd_num twd_cos(twd_phase phase)
{
    return twd_sin(phase + TWD_QUARTER_TURN);
}

/* Both sine and cosine, same error as twd_sin, for less than the two of them apart. */
static inline void twd_sine_cosine(twd_phase phase, twd_num *sine, twd_num *cosine)
{
    /* What is left from the nearest quarter turn, at most an eighth of a turn, needs shorter polynomials in u: for
     * sin(pi/2 u) and cos(pi/2 u) on [-1/2, 1/2], Remez exchange as above; maximum errors 1.3e-9 and 5.4e-11. */
    const twd_phase quarters = (phase + TWD_EIGHTH_TURN) / TWD_QUARTER_TURN;
    const twd_num u = twd_quarters_of_phase(phase - quarters * TWD_QUARTER_TURN);
    const twd_num square = twd_mul(u, u);
    twd_num sum = TWD_NUM(-0.0045922890596582436);
    sum = twd_mul(sum, square) + TWD_NUM(0.079675902961940704);
    sum = twd_mul(sum, square) + TWD_NUM(-0.64596293816607918);
    sum = twd_mul(sum, square) + TWD_NUM(0.57079630508540079);
    const twd_num near_sine = u + twd_mul(sum, u);

    sum = TWD_NUM(0.00090402167188929938);
    sum = twd_mul(sum, square) + TWD_NUM(-0.020860288508877817);
    sum = twd_mul(sum, square) + TWD_NUM(0.25366924403005243);
    sum = twd_mul(sum, square) + TWD_NUM(-1.2337005433534884);
    const twd_num near_cosine = TWD_NUM(1) + twd_mul(sum, square);

    /* A quarter turn makes the sine a cosine, and the cosine a negative sine. */
    const twd_num unsigned_sine = quarters & 1U ? near_cosine : near_sine;
    const twd_num unsigned_cosine = quarters & 1U ? near_sine : near_cosine;
    *sine = quarters & 2U ? -unsigned_sine : unsigned_sine;
    *cosine = (quarters + 1U) & 2U ? -unsigned_cosine : unsigned_cosine;
}

/* Of s = q^2, from s^4 down: 2 sin(q/2) = q + q s P(s), and cos(q/2) = 1 + s Q(s), for q in [-pi, pi]. Remez exchange
 * as above; maximum errors 3.5e-11 and 2.4e-10. */
#define TWD_TWICE_HALF_SINE_4 TWD_NUM(-2.328778711855352757e-11)
#define TWD_TWICE_HALF_SINE_3 TWD_NUM(1.0751022989878610528e-8)
#define TWD_TWICE_HALF_SINE_2 TWD_NUM(-3.1001256311243996619e-6)
#define TWD_TWICE_HALF_SINE_1 TWD_NUM(0.00052083315597946410088)
#define TWD_TWICE_HALF_SINE_0 TWD_NUM(-0.041666666516167478764)
#define TWD_HALF_COSINE_4 TWD_NUM(-2.5465923197961348023e-10)
#define TWD_HALF_COSINE_3 TWD_NUM(9.6726118157782759278e-8)
#define TWD_HALF_COSINE_2 TWD_NUM(-0.000021700630481591523375)
#define TWD_HALF_COSINE_1 TWD_NUM(0.0026041650455037417046)
#define TWD_HALF_COSINE_0 TWD_NUM(-0.12499999887389313841)

/* Sine and cosine of `angle_rad`, in [-pi, pi]; values beyond are clamped. Error at most 1e-8 (double), 3e-7 (float).
 * Half the angle needs no folding, and sin(q) = 2 sin(q/2) cos(q/2), cos(q) = cos^2(q/2) - sin^2(q/2). Without a
 * floating-point unit, to fold takes less time than so many products. */
#if defined(__x86_64__) || defined(__aarch64__) || defined(_M_X64) || defined(_M_ARM64) || defined(__ARM_FP) ||        \
    defined(__riscv_flen)
static inline void twd_sine_cosine_of_angle(twd_num angle_rad, twd_num *sine, twd_num *cosine)
{
    const twd_num half_turn_rad = TWD_NUM(3.14159265358979324);
    const twd_num angle = twd_clamp(angle_rad, -half_turn_rad, half_turn_rad);
    const twd_num square = twd_mul(angle, angle);
    twd_num sum = TWD_TWICE_HALF_SINE_4;
    sum = twd_mul(sum, square) + TWD_TWICE_HALF_SINE_3;
    sum = twd_mul(sum, square) + TWD_TWICE_HALF_SINE_2;
    sum = twd_mul(sum, square) + TWD_TWICE_HALF_SINE_1;
    sum = twd_mul(sum, square) + TWD_TWICE_HALF_SINE_0;
    const twd_num twice_half_sine = angle + twd_mul(twd_mul(sum, square), angle);

    sum = TWD_HALF_COSINE_4;
    sum = twd_mul(sum, square) + TWD_HALF_COSINE_3;
    sum = twd_mul(sum, square) + TWD_HALF_COSINE_2;
    sum = twd_mul(sum, square) + TWD_HALF_COSINE_1;
    sum = twd_mul(sum, square) + TWD_HALF_COSINE_0;
    const twd_num half_cosine = TWD_NUM(1) + twd_mul(sum, square);

    const twd_num half_sine = twd_mul(twice_half_sine, TWD_NUM(0.5));

    *sine = twd_mul(twice_half_sine, half_cosine);
    *cosine = twd_mul(half_cosine, half_cosine) - twd_mul(half_sine, half_sine);
}
#else
static inline void twd_sine_cosine_of_angle(twd_num angle_rad, twd_num *sine, twd_num *cosine)
{
    twd_sine_cosine(twd_phase_from_angle(angle_rad), sine, cosine);
}
#endif

TWD_END_DECLARATIONS

#endif
