/* pd.h: the proportional-derivative law of one joint.
 *
 * T = g(q) + Kp (desired - actual) - Kd velocity (Ciancio et al. 2011, eq. 16; the paper prints + Kd q', and a damping
 * term needs the minus), limited to what the motor can give. */
#ifndef TWIDDLE_PD_H
#define TWIDDLE_PD_H

#include <twiddle/number.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Gains and limit of one joint. */
struct twd_pd {
    twd_num stiffness_nm_per_rad; /* Kp, > 0 */
    twd_num damping_nms_per_rad;  /* Kd, >= 0 */
    twd_num torque_limit_nm;      /* |T| is at most this, > 0 */
};

/* The torque in N m before the limit is applied. */
twd_num twd_pd_torque(const struct twd_pd *pd, twd_num desired_rad, twd_num actual_rad, twd_num velocity_rad_s,
                      twd_num gravity_nm);

#ifdef __cplusplus
}
#endif
#endif
