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
