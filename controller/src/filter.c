#include <twiddle/filter.h>

#include <twiddle/elementary.h>

struct twd_filter_step twd_filter_step_make(twd_rate rate_per_s, twd_small tick_s)
{
    /* With error d = y - Y and velocity v = y' / (a/2), both solve d' = (a/2) v, v' = -(a/2) (d + 2 v), whose
     * transition over k = a h / 2 is exp(-k) times [1 + k, k; -k, 1 - k]. */
    const twd_num k = twd_num_mul_rate_small(rate_per_s, twd_small_half(tick_s));
    return twd_filter_step_of_decay(k, twd_exp_negative_of_num(k));
}
