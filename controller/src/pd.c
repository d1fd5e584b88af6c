#include <twiddle/pd.h>

twd_num twd_pd_torque(const struct twd_pd *pd, twd_num desired_rad, twd_num actual_rad, twd_num velocity_rad_s,
                      twd_num gravity_nm)
{
    return gravity_nm + twd_mul(pd->stiffness_nm_per_rad, desired_rad - actual_rad) -
           twd_mul(pd->damping_nms_per_rad, velocity_rad_s);
}
