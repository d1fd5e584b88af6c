/* joint_range.h: how far a joint turns. */
#ifndef TWIDDLE_JOINT_RANGE_H
#define TWIDDLE_JOINT_RANGE_H

#include <twiddle/number.h>

TWD_BEGIN_DECLARATIONS

/* Both in [-pi, pi]. */
struct twd_joint_range {
    twd_num lower_rad;
    twd_num upper_rad; /* > lower_rad */
};

TWD_END_DECLARATIONS

#endif
