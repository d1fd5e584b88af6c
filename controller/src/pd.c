#include <twiddle/pd.h>

#include "checks.h"

enum twd_error twd_pd_stable(const struct twd_pd *pd, twd_num inertia_kg_m2, twd_num period_s, struct twd_pd *stable)
{
    if (!(period_s > TWD_NUM(0)) || period_s > TWD_NUM(0.1)) return TWD_ERROR_TICK;
    if (!(inertia_kg_m2 > TWD_NUM(0)) || !twd_is_usable(inertia_kg_m2)) return TWD_ERROR_RANGE;
    const enum twd_error error = twd_check_pd(pd);
    if (error != TWD_OK) return error;

    const twd_num damping = pd->damping_nms_per_rad + twd_mul(period_s, pd->stiffness_nm_per_rad);
    const twd_num divisor = TWD_NUM(1) + twd_div(twd_mul(period_s, damping), inertia_kg_m2);
    if (!twd_is_usable(divisor)) return TWD_ERROR_RANGE;

    stable->stiffness_nm_per_rad = twd_div(pd->stiffness_nm_per_rad, divisor);
    stable->damping_nms_per_rad = twd_div(damping, divisor);
    stable->torque_limit_nm = pd->torque_limit_nm;
    return TWD_OK;
}
