#include <twiddle/pd.h>

#include "checks.h"

enum twd_error twd_pd_stable(const struct twd_pd *pd, twd_small inertia_kg_m2, twd_small period_s,
                             struct twd_pd *stable)
{
    if (!(period_s > TWD_SMALL(0)) || period_s > TWD_SMALL(0.1)) return TWD_ERROR_TICK;
    if (!(inertia_kg_m2 > TWD_SMALL(0)) || !twd_small_is_usable(inertia_kg_m2)) return TWD_ERROR_RANGE;
    const enum twd_error error = twd_check_pd(pd);
    if (error != TWD_OK) return error;

    const twd_num damping =
        twd_add_saturated(pd->damping_nms_per_rad, twd_num_mul_small(pd->stiffness_nm_per_rad, period_s));
    const twd_wide added = twd_wide_div_small(twd_small_mul(damping, period_s), inertia_kg_m2);
    const twd_wide divisor = twd_wide_add(TWD_WIDE(1), added);
    if (!twd_wide_is_usable(divisor)) return TWD_ERROR_RANGE;

    stable->stiffness_nm_per_rad = twd_num_div_wide(pd->stiffness_nm_per_rad, divisor);
    stable->damping_nms_per_rad = twd_num_div_wide(damping, divisor);
    stable->torque_limit_nm = pd->torque_limit_nm;
    return TWD_OK;
}
