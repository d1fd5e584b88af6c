#include <twiddle/gate.h>

void twd_gate_normalise(const twd_num *activation, size_t count, twd_num *weight)
{
    twd_num sum = TWD_NUM(0);
    for (size_t k = 0; k < count; k++)
        sum = twd_add_saturated(sum, activation[k]);

    const bool all_silent = !(sum > TWD_NUM(0));
    for (size_t k = 0; k < count; k++)
        weight[k] = all_silent ? twd_ratio(1, (int32_t)count) : twd_div(activation[k], sum);
}

twd_num twd_gate_remap(twd_num fraction, twd_num lower_rad, twd_num upper_rad)
{
    const twd_num saturated = twd_clamp(fraction, TWD_NUM(0), TWD_NUM(1));
    const twd_num angle_rad = lower_rad + twd_mul(saturated, upper_rad - lower_rad);
    /* Rounding may carry a fraction of 1 past the upper end. */
    return twd_clamp(angle_rad, lower_rad, upper_rad);
}
