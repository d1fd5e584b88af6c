/* detail/four.h: numbers of four joints or oscillators side by side, for processors that compute with four at once.
 *
 * Two fingers of two joints each, as the iCub hand's index and thumb, then cost little more than one joint. Angles and
 * torques are the same to the last bit; only hosts pay the memory. */
#ifndef TWIDDLE_DETAIL_FOUR_H
#define TWIDDLE_DETAIL_FOUR_H

#include <twiddle/limits.h>
#include <twiddle/number.h>

/* Whether the library computes so. The fixed build does not: its long products have no such instructions. */
#if !defined(TWD_NUMBER_FIXED) && (defined(__x86_64__) || defined(__aarch64__) || defined(_M_X64) || defined(_M_ARM64))
#define TWD_FOUR_AT_ONCE 1
#else
#define TWD_FOUR_AT_ONCE 0
#endif

#if TWD_FOUR_AT_ONCE

TWD_BEGIN_DECLARATIONS

/* Aligned, where a compiler can be told, so that it can be an operand; memory of malloc is aligned so, too. */
struct twd_four {
#if defined(__GNUC__)
    __attribute__((aligned(16)))
#endif
    twd_num of[4];
};

/* What the filters of amplitudes and centres need (filter.h). Four numbers are of one oscillator: its amplitude, its
 * amplitude's velocity, its centre, its centre's velocity. */
struct twd_four_filters {
    /* From the number itself. */
    struct twd_four from_same;
    /* From the velocity of a value, and from the value of a velocity. */
    struct twd_four from_other;
    /* R, 0, C, 0 of each oscillator. */
    struct twd_four target[TWD_MAX_OSCILLATORS];
};

/* What four joints need, worked out by twd_controller_init and, of a trial, twd_controller_start. */
struct twd_four_joints {
    /* Whether there are four joints, and two fingers: one whose joints are 0 and 1, one whose joints are 2 and 3. The
     * rest is written only then. */
    bool fit;
    struct twd_four lower_rad;
    struct twd_four upper_rad;
    struct twd_four upper_less_lower_rad;
    /* Of each oscillator's output in each joint's. */
    struct twd_four weight[TWD_MAX_OSCILLATORS];
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
