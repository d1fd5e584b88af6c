/* detail/four_joints.h: the numbers of four joints side by side, for processors that compute with four at once.
 *
 * Two fingers of two joints each, as the iCub hand's index and thumb, then cost little more than one joint. The torques
 * are the same to the last bit; only hosts pay the memory. */
#ifndef TWIDDLE_DETAIL_FOUR_JOINTS_H
#define TWIDDLE_DETAIL_FOUR_JOINTS_H

#include <twiddle/number.h>

/* Whether controllers hold their joints side by side as well. The fixed build's long products have no such
 * instructions. */
#if !defined(TWD_NUMBER_FIXED) && (defined(__x86_64__) || defined(__aarch64__) || defined(_M_X64) || defined(_M_ARM64))
#define TWD_FOUR_JOINTS 1
#else
#define TWD_FOUR_JOINTS 0
#endif

#if TWD_FOUR_JOINTS

TWD_BEGIN_DECLARATIONS

/* A number of each joint. */
struct twd_four {
    twd_num of[4];
};

/* What the torques of four joints need, worked out by twd_controller_init. */
struct twd_four_joints {
    /* Whether there are four joints, and two fingers: one whose joints are 0 and 1, one whose joints are 2 and 3. The
     * rest is written only then. */
    bool fit;
    struct twd_four stiffness_nm_per_rad;
    struct twd_four damping_nms_per_rad;
    struct twd_four lower_limit_nm;
    struct twd_four upper_limit_nm;
    /* Of the torque that holds a joint at angle q whose finger's other joint is at p: cos q times the sum of the first
     * three, times 1, cos p and sin p, less sin q times that of the last three. */
    struct twd_four gravity_nm[6];
};

TWD_END_DECLARATIONS

#endif

#endif
