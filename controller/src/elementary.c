#include <twiddle/elementary.h>

/* The polynomial of degree 9 and least maximum relative error for exp(-x) on [0, 1]: Remez exchange in 40-digit
 * arithmetic; relative error 5.3e-13, and 1.9e-12 after its constant, 1 - 5.3e-13, is set to 1 for exp(0) = 1. */
static twd_num exp_negative_of_unit(twd_num x)
{
    twd_num sum = TWD_NUM_CONSTANT(-1.6619642866597087e-6, -446);
    sum = twd_mul(sum, x) + TWD_NUM_CONSTANT(2.2625368560862606e-5, 6073);
    sum = twd_mul(sum, x) + TWD_NUM_CONSTANT(-0.00019589573271623721, -52585);
    sum = twd_mul(sum, x) + TWD_NUM_CONSTANT(0.0013870894479902698, 372344);
    sum = twd_mul(sum, x) + TWD_NUM_CONSTANT(-0.0083325257261433896, -2236745);
    sum = twd_mul(sum, x) + TWD_NUM_CONSTANT(0.041666443492117840, 11184751);
    sum = twd_mul(sum, x) + TWD_NUM_CONSTANT(-0.16666663085656620, -44739233);
    sum = twd_mul(sum, x) + TWD_NUM_CONSTANT(0.49999999704698583, 134217727);
    sum = twd_mul(sum, x) + TWD_NUM_CONSTANT(-0.99999999990416946, -268435456);
    return twd_mul(sum, x) + TWD_NUM(1);
}

twd_num twd_exp_negative(twd_wide value)
{
    /* The argument in parts of 32, for number formats that do not reach 32. */
    twd_num part = twd_clamp(twd_num_mul_wide(TWD_NUM(0.03125), value), TWD_NUM(0), TWD_NUM(1));
    /* Its whole part is taken out in powers of two: exp(-16), exp(-8), ... exp(-1). */
    static const twd_num power[] = {
        TWD_NUM_CONSTANT(1.1253517471925911e-7, 30), TWD_NUM_CONSTANT(3.3546262790251185e-4, 90050),
        TWD_NUM_CONSTANT(0.018315638888734180, 4916567), TWD_NUM_CONSTANT(0.13533528323661269, 36328788),
        TWD_NUM_CONSTANT(0.36787944117144232, 98751886)};
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

twd_num twd_exp_negative_of_num(twd_num value)
{
    const bool below_one = value >= TWD_NUM(0) && value < TWD_NUM(1);
    return below_one ? exp_negative_of_unit(value) : twd_exp_negative(twd_wide_of_num(value));
}

twd_num twd_sigmoid(twd_wide value)
{
    const bool negative = value < TWD_WIDE(0);
    /* Clamped first, since the fixed build's largest negative word has no opposite. */
    const twd_wide size = negative ? -twd_wide_clamp(value, TWD_WIDE(-32), TWD_WIDE(0)) : value;
    const twd_num upper = twd_div(TWD_NUM(1), TWD_NUM(1) + twd_exp_negative(size));
    return negative ? TWD_NUM(1) - upper : upper;
}
