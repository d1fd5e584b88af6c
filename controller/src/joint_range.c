#include <twiddle/joint_range.h>

twd_num twd_joint_range_angle(const struct twd_joint_range *range, twd_num fraction)
{
    const twd_num saturated = twd_clamp(fraction, TWD_NUM(0), TWD_NUM(1));
    const twd_num angle_rad = range->lower_rad + twd_mul(saturated, range->upper_rad - range->lower_rad);
    /* Rounding may carry a fraction of 1 past the upper end. */
    return twd_clamp(angle_rad, range->lower_rad, range->upper_rad);
}
