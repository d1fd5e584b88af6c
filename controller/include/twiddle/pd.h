/* pd.h: the proportional-derivative law of one joint.
 *
 * T = g(q) + Kp (desired - actual) - Kd velocity (Ciancio et al. 2011, eq. 16; the paper prints + Kd q', and a damping
 * term needs the minus), limited to what the motor can give. */
#ifndef TWIDDLE_PD_H
#define TWIDDLE_PD_H

#include <twiddle/detail/controller_names.h>
#include <twiddle/error.h>
#include <twiddle/number.h>

TWD_BEGIN_DECLARATIONS

/* Gains and limit of one joint. */
struct twd_pd {
    /* Kp, > 0. */
    twd_num stiffness_nm_per_rad;
    /* Kd, >= 0. */
    twd_num damping_nms_per_rad;
    /* |T| is at most this, > 0. */
    twd_num torque_limit_nm;
};

/* The torque in N m before the limit is applied. */
static inline twd_num twd_pd_torque(const struct twd_pd *pd, twd_num desired_rad, twd_num actual_rad,
                                    twd_rate velocity_rad_s, twd_num gravity_nm)
{
    const twd_num error_rad = twd_subtract_saturated(desired_rad, actual_rad);
    const twd_num driven_nm = twd_add_saturated(gravity_nm, twd_mul_saturated(pd->stiffness_nm_per_rad, error_rad));
    return twd_subtract_saturated(driven_nm, twd_num_mul_rate(pd->damping_nms_per_rad, velocity_rad_s));
}

/* Gains with which the law stays stable at long periods: `stable` gives the torque that `pd` would ask for in the state
 * predicted at the end of the period h = `period_s`, in (0, 0.1] s, of a joint with the effective inertia M =
 * `inertia_kg_m2`, > 0. After Tan, Liu and Turk 2011, "Stable proportional-derivative controllers".
 *
 * An acceleration a that lasts for h leads to the angle q + h v + h^2 a and the velocity v + h a. A joint whose weight
 * is compensated, and whose coupling to other joints is ignored, then has
 *
 *     M a = Kp (desired - q - h v - h^2 a) - Kd (v + h a).
 *
 * Solved for M a, this is a PD law again, with the gains Kp / D and (Kd + h Kp) / D, D = 1 + h (Kd + h Kp) / M. For h
 * to 0 they are those of `pd`. (The paper predicts the angle q + h v, and so has no h^2 Kp in D.) A joint stepped by
 * semi-implicit Euler is stable at any h if its true inertia is at least 3/4 of M. The prediction knows no contact: a
 * joint that is stopped by one presses with Kp / D. The torque limit stays.
 *
 * TWD_ERROR_TICK for the period; TWD_ERROR_RANGE for gains or an inertia out of range, or a D above 1e6 (127 in the
 * fixed build); `stable` is then as it was. `stable` may be `pd` itself. */
enum twd_error twd_pd_stable(const struct twd_pd *pd, twd_small inertia_kg_m2, twd_small period_s,
                             struct twd_pd *stable);

TWD_END_DECLARATIONS

#endif
