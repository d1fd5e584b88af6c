/* joint_range.h: how far a joint turns, and what a fraction of that is as an angle. */
#ifndef TWIDDLE_JOINT_RANGE_H
#define TWIDDLE_JOINT_RANGE_H

#include <twiddle/detail/controller_names.h>
#include <twiddle/number.h>

TWD_BEGIN_DECLARATIONS

/* Both angles in [-pi, pi]. */
struct twd_joint_range {
    /* The angle of fraction 0. */
    twd_num lower_rad;
    /* The angle of fraction 1; above lower_rad. */
    twd_num upper_rad;
};

/* A fraction of the range, saturated to [0, 1], as an angle in [lower_rad, upper_rad]; what is no number counts as
 * 0. */
twd_num twd_joint_range_angle(const struct twd_joint_range *range, twd_num fraction);

TWD_END_DECLARATIONS

#endif
