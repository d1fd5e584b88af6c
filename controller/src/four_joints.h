/* four_joints.h: the angles and torques of four joints at once, where that fits the controller and its input. Inline,
 * so that the caller keeps its arguments where they are; not installed. */
#ifndef TWIDDLE_FOUR_JOINTS_H
#define TWIDDLE_FOUR_JOINTS_H

#include <twiddle/controller.h>

#include "four_oscillators.h"

#if TWD_FOUR_AT_ONCE

#define twd_four_joints_make TWD_BUILD_NAME(twd_four_joints_make)
#define twd_four_joints_weigh TWD_BUILD_NAME(twd_four_joints_weigh)

/* Fill `four` from a configuration that has been checked. */
void twd_four_joints_make(struct twd_four_joints *four, const struct twd_controller_config *config);

/* Of a trial: `weight` is of each of the model's CPGs. */
void twd_four_joints_weigh(struct twd_four_joints *four, const struct twd_model *model, const twd_num *weight);

/* Comparisons that a value which is not a number fails; without branches. */
static inline bool four_within(struct twd_four a, struct twd_four lower, struct twd_four upper)
{
    int32_t within[4];
    for (int j = 0; j < 4; j++)
        within[j] = (a.of[j] >= lower.of[j]) & (a.of[j] <= upper.of[j]);
    return within[0] & within[1] & within[2] & within[3];
}

/* twd_cpg_tick, if it fits; returns the weighted sum of the oscillators' outputs of each joint. */
static inline struct twd_four four_joints_tick(const struct twd_four_joints *four, struct twd_cpg *cpg)
{
    struct twd_four sum = {{TWD_NUM(0), TWD_NUM(0), TWD_NUM(0), TWD_NUM(0)}};
    twd_num cosine[TWD_MAX_OSCILLATORS + 3];
    four_oscillators_advance(cpg, cosine);
    for (size_t i = 0; i < cpg->oscillators; i++) {
        const twd_num output = four_output(&cpg->oscillator[i], cosine[i]);
        for (int j = 0; j < 4; j++)
            sum.of[j] += twd_mul_short(four->weight[i].of[j], output);
    }
    return sum;
}

/* Write the angles of these fractions of the joint ranges. False if one is saturated; nothing is then written. */
static inline bool four_joints_angle(const struct twd_four_joints *four, struct twd_four fraction, twd_num *angle_rad)
{
    static const struct twd_four zero = {{TWD_NUM(0), TWD_NUM(0), TWD_NUM(0), TWD_NUM(0)}};
    if (!four_within(fraction, zero, twd_four_constants.one)) return false;
    const struct twd_four angle = four_multiply_add(fraction, four->upper_less_lower_rad, four->lower_rad);
    /* Rounding may carry a fraction of 1 past the upper end. */
    four_store(four_smaller(angle, four->upper_rad), angle_rad);
    return true;
}

/* twd_gravity_torque, of two fingers. */
static inline struct twd_four four_gravity_torque(const struct twd_four term_nm[6], struct twd_four sine,
                                                  struct twd_four cosine)
{
    const struct twd_four other_sine = four_swap(sine), other_cosine = four_swap(cosine);
    const struct twd_four of_cosine =
        four_multiply_add(term_nm[2], other_sine, four_multiply_add(term_nm[1], other_cosine, term_nm[0]));
    const struct twd_four of_sine =
        four_multiply_add(term_nm[5], other_sine, four_multiply_add(term_nm[4], other_cosine, term_nm[3]));
    return four_subtract(four_multiply(of_cosine, cosine), four_multiply(of_sine, sine));
}

/* Write the torques of twd_controller_torque. False if they must be computed one by one, since an input may not be
 * usable, an angle may lie beyond half a turn, or a torque lies beyond its limit; nothing is then written. */
static inline bool four_joints_torque(const struct twd_four_joints *four, const twd_num *desired_angle_rad,
                                      const twd_num *angle_rad, const twd_rate *velocity_rad_s, twd_num *torque_nm)
{
    const struct twd_four desired = four_load(desired_angle_rad);
    const struct twd_four angle = four_load(angle_rad);
    const struct twd_four velocity = four_load(velocity_rad_s);
    const struct twd_four angle_square = four_multiply(angle, angle);
    const struct twd_four square_sum = four_add(four_multiply(desired, desired), four_multiply(velocity, velocity));

    struct twd_four sine, cosine;
    four_sine_cosine(angle, angle_square, &sine, &cosine);
    const struct twd_four gravity_nm = four_gravity_torque(four->gravity_nm, sine, cosine);
    const struct twd_four driven_nm =
        four_multiply_add(four->stiffness_nm_per_rad, four_subtract(desired, angle), gravity_nm);
    const struct twd_four torque = four_subtract(driven_nm, four_multiply(four->damping_nms_per_rad, velocity));

    /* As four_within, and with one decision for all. */
    int32_t fits[4];
    for (int j = 0; j < 4; j++)
        fits[j] = (angle_square.of[j] <= twd_four_constants.largest_angle_square.of[j]) &
                  (square_sum.of[j] <= twd_four_constants.largest_square_sum.of[j]) &
                  (torque.of[j] >= four->lower_limit_nm.of[j]) & (torque.of[j] <= four->upper_limit_nm.of[j]);
    if (!(fits[0] & fits[1] & fits[2] & fits[3])) return false;
    four_store(torque, torque_nm);
    return true;
}

#endif

#endif
