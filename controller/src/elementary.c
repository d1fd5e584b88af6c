#include <twiddle/elementary.h>

#define QUARTER_TURN UINT32_C(0x40000000)
#define HALF_TURN UINT32_C(0x80000000)

/* The first two functions are the only places where the two scales meet: numbers, and phases of 2^32 a turn. */

/* Turns in [-0.5, 0.5) to a phase, rounded towards zero. */
static twd_phase phase_of_turns(twd_num turns)
{
    return (uint32_t)(int32_t)(turns * TWD_NUM(4294967296.0));
}

/* A phase in [0, 2^30] to quarter turns in [0, 1]. */
static twd_num quarters_of_phase(twd_phase phase)
{
    return (twd_num)(int32_t)phase * TWD_NUM(1.0 / 1073741824.0);
}

/* The polynomial of least maximum error for sin(pi/2 u) on [0, 1] in u, u^3, ... u^9: Remez exchange in 40-digit
 * arithmetic; maximum error 3.4e-9. One u stands apart, so that the rounded sum is a small part of the result. */
static twd_num sine_of_quarters(twd_num u)
{
    const twd_num square = twd_mul(u, u);
    twd_num sum = TWD_NUM(0.00015082056718197074);
    sum = twd_mul(sum, square) + TWD_NUM(-0.0046722279289435442);
    sum = twd_mul(sum, square) + TWD_NUM(0.079688480544303229);
    sum = twd_mul(sum, square) + TWD_NUM(-0.64596335986686903);
    sum = twd_mul(sum, square) + TWD_NUM(0.5707962900224310);
    return u + twd_mul(sum, u);
}

twd_num twd_sin(twd_phase phase)
{
    /* The second and third quarter are folded onto the first and fourth: sin(theta) = sin(half a turn - theta). */
    if (phase + QUARTER_TURN >= HALF_TURN) phase = HALF_TURN - phase;

    if (phase <= QUARTER_TURN) return sine_of_quarters(quarters_of_phase(phase));
    return -sine_of_quarters(quarters_of_phase(0U - phase));
}

twd_num twd_cos(twd_phase phase)
{
    return twd_sin(phase + QUARTER_TURN);
}

twd_phase twd_phase_from_turns(twd_num turns)
{
    /* The largest number below a half that a float holds, so that the limits are the same in every number build. */
    const twd_num limit = TWD_NUM(0.499999970197677612);
    return phase_of_turns(twd_clamp(turns, -limit, limit));
}

twd_phase twd_phase_from_angle(twd_num angle_rad)
{
    return twd_phase_from_turns(twd_mul(angle_rad, TWD_NUM(0.15915494309189535)));
}

twd_phase twd_phase_from_fraction(twd_num fraction)
{
    const twd_num turns = twd_clamp(fraction, TWD_NUM(0), TWD_NUM(1));
    return phase_of_turns(turns < TWD_NUM(0.5) ? turns : turns - TWD_NUM(1));
}

/* The polynomial of degree 9 and least maximum relative error for exp(-x) on [0, 1]: Remez exchange in 40-digit
 * arithmetic; relative error 5.3e-13, and 1.9e-12 after its constant, 1 - 5.3e-13, is set to 1 for exp(0) = 1. */
static twd_num exp_negative_of_unit(twd_num x)
{
    twd_num sum = TWD_NUM(-1.6619642866597087e-6);
    sum = twd_mul(sum, x) + TWD_NUM(2.2625368560862606e-5);
    sum = twd_mul(sum, x) + TWD_NUM(-0.00019589573271623721);
    sum = twd_mul(sum, x) + TWD_NUM(0.0013870894479902698);
    sum = twd_mul(sum, x) + TWD_NUM(-0.0083325257261433896);
    sum = twd_mul(sum, x) + TWD_NUM(0.041666443492117840);
    sum = twd_mul(sum, x) + TWD_NUM(-0.16666663085656620);
    sum = twd_mul(sum, x) + TWD_NUM(0.49999999704698583);
    sum = twd_mul(sum, x) + TWD_NUM(-0.99999999990416946);
    return twd_mul(sum, x) + TWD_NUM(1);
}

twd_num twd_exp_negative(twd_num value)
{
    /* The argument in parts of 32, for number formats that do not reach 32. */
    twd_num part = twd_clamp(twd_mul(value, TWD_NUM(1.0 / 32.0)), TWD_NUM(0), TWD_NUM(1));
    /* Its whole part is taken out in powers of two: exp(-16), exp(-8), ... exp(-1). */
    static const twd_num power[] = {TWD_NUM(1.1253517471925911e-7), TWD_NUM(3.3546262790251185e-4),
                                    TWD_NUM(0.018315638888734180), TWD_NUM(0.13533528323661269),
                                    TWD_NUM(0.36787944117144232)};
    twd_num whole = TWD_NUM(1);
    twd_num bit = TWD_NUM(0.5);
    for (int k = 0; k < 5; k++) {
        if (part >= bit) {
            part -= bit;
            whole = twd_mul(whole, power[k]);
        }
        bit = twd_mul(bit, TWD_NUM(0.5));
    }
    /* What is left is in [0, 1/32]; five doublings need no constant 32. */
    for (int doubling = 0; doubling < 5; doubling++)
        part += part;
    return twd_mul(whole, exp_negative_of_unit(part));
}

twd_num twd_sigmoid(twd_num value)
{
    const bool negative = value < TWD_NUM(0);
    const twd_num upper = twd_div(TWD_NUM(1), TWD_NUM(1) + twd_exp_negative(negative ? -value : value));
    return negative ? TWD_NUM(1) - upper : upper;
}
