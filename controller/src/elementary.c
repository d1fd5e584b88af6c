#include <twiddle/elementary.h>

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
