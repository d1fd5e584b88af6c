#include <twiddle/filter.h>

#include <twiddle/elementary.h>

struct twd_filter_step twd_filter_step_make(twd_num rate_per_s, twd_num tick_s)
{
    /* With error d = y - Y and velocity v = y' / (a/2), both solve d' = (a/2) v, v' = -(a/2) (d + 2 v), whose
     * transition over k = a h / 2 is exp(-k) times [1 + k, k; -k, 1 - k]. */
    const twd_num k = twd_mul(rate_per_s, twd_mul(tick_s, TWD_NUM(0.5)));
    const twd_num decay = twd_exp_negative(k);
    const twd_num mixed = twd_mul(decay, k);
    const struct twd_filter_step step = {decay + mixed, mixed, -mixed, decay - mixed};
    return step;
}
