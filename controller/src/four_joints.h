/* four_joints.h: the torques of four joints at once, where that fits the controller and its input. Inline, so that the
 * caller keeps its arguments where they are; not installed. */
#ifndef TWIDDLE_FOUR_JOINTS_H
#define TWIDDLE_FOUR_JOINTS_H

#include <twiddle/controller.h>

#if TWD_FOUR_JOINTS

#define twd_four_joints_make TWD_BUILD_NAME(twd_four_joints_make)
#define twd_four_constants TWD_BUILD_NAME(twd_four_constants)

/* Each number four times. */
struct twd_four_constants {
    /* Polynomials of float/phase.h, the highest power first. */
    struct twd_four twice_half_sine[5];
    struct twd_four half_cosine[5];
    struct twd_four half;
    struct twd_four one;
    /* What is larger than the square of an angle of [-pi, pi] or a sum of two usable numbers' squares is left to others,
     * and so is some of what is just as large. */
    struct twd_four largest_angle_square;
    struct twd_four largest_square_sum;
};

/* In another file than its user: compilers that see the numbers build each four from one, in twice the instructions. */
extern const struct twd_four_constants twd_four_constants;

/* Fill `four` from a configuration that has been checked. */
void twd_four_joints_make(struct twd_four_joints *four, const struct twd_controller_config *config);

/* Each loop below is one instruction, or two in the double build: GCC 12 finds so at -O2. */

static inline struct twd_four load(const twd_num *number)
{
    struct twd_four loaded;
    for (int j = 0; j < 4; j++)
        loaded.of[j] = number[j];
    return loaded;
}

static inline struct twd_four add(struct twd_four a, struct twd_four b)
{
    struct twd_four sum;
    for (int j = 0; j < 4; j++)
        sum.of[j] = a.of[j] + b.of[j];
    return sum;
}

static inline struct twd_four subtract(struct twd_four a, struct twd_four b)
{
    struct twd_four difference;
    for (int j = 0; j < 4; j++)
        difference.of[j] = a.of[j] - b.of[j];
    return difference;
}

static inline struct twd_four multiply(struct twd_four a, struct twd_four b)
{
    struct twd_four product;
    for (int j = 0; j < 4; j++)
        product.of[j] = twd_mul(a.of[j], b.of[j]);
    return product;
}

/* The number of the finger's other joint. */
static inline struct twd_four of_other(struct twd_four a)
{
    const struct twd_four other = {{a.of[1], a.of[0], a.of[3], a.of[2]}};
    return other;
}

/* sum * x + term */
static inline struct twd_four next_sum(struct twd_four sum, struct twd_four x, struct twd_four term)
{
    struct twd_four next;
    for (int j = 0; j < 4; j++)
        next.of[j] = twd_mul(sum.of[j], x.of[j]) + term.of[j];
    return next;
}

/* twd_sine_cosine_of_angle, of angles with these squares. */
static inline void find_sines(struct twd_four angle, struct twd_four square, struct twd_four *sine,
                              struct twd_four *cosine)
{
    const struct twd_four_constants *const constant = &twd_four_constants;
    struct twd_four sum = constant->twice_half_sine[0];
    sum = next_sum(sum, square, constant->twice_half_sine[1]);
    sum = next_sum(sum, square, constant->twice_half_sine[2]);
    sum = next_sum(sum, square, constant->twice_half_sine[3]);
    sum = next_sum(sum, square, constant->twice_half_sine[4]);
    const struct twd_four twice_half_sine = add(angle, multiply(multiply(sum, square), angle));

    sum = constant->half_cosine[0];
    sum = next_sum(sum, square, constant->half_cosine[1]);
    sum = next_sum(sum, square, constant->half_cosine[2]);
    sum = next_sum(sum, square, constant->half_cosine[3]);
    sum = next_sum(sum, square, constant->half_cosine[4]);
    const struct twd_four half_cosine = add(constant->one, multiply(sum, square));
    const struct twd_four half_sine = multiply(twice_half_sine, constant->half);

    *sine = multiply(twice_half_sine, half_cosine);
    *cosine = subtract(multiply(half_cosine, half_cosine), multiply(half_sine, half_sine));
}

/* twd_gravity_torque, of two fingers. */
static inline struct twd_four gravity_torque(const struct twd_four term_nm[6], struct twd_four sine,
                                             struct twd_four cosine)
{
    const struct twd_four other_sine = of_other(sine), other_cosine = of_other(cosine);
    const struct twd_four of_cosine =
        add(add(term_nm[0], multiply(term_nm[1], other_cosine)), multiply(term_nm[2], other_sine));
    const struct twd_four of_sine =
        add(add(term_nm[3], multiply(term_nm[4], other_cosine)), multiply(term_nm[5], other_sine));
    return subtract(multiply(of_cosine, cosine), multiply(of_sine, sine));
}

/* Write the torques of twd_controller_torque, if `four` fits. False if they must be computed one by one, since an input
 * may not be usable, an angle may lie beyond half a turn, or a torque lies beyond its limit; nothing is then
 * written. */
static inline bool twd_four_joints_torque(const struct twd_four_joints *four, const twd_num *desired_angle_rad,
                                          const twd_num *angle_rad, const twd_rate *velocity_rad_s, twd_num *torque_nm)
{
    const struct twd_four desired = load(desired_angle_rad);
    const struct twd_four angle = load(angle_rad);
    const struct twd_four velocity = load(velocity_rad_s);
    const struct twd_four angle_square = multiply(angle, angle);
    const struct twd_four square_sum = add(multiply(desired, desired), multiply(velocity, velocity));

    struct twd_four sine, cosine;
    find_sines(angle, angle_square, &sine, &cosine);
    const struct twd_four gravity_nm = gravity_torque(four->gravity_nm, sine, cosine);
    const struct twd_four driven_nm = add(gravity_nm, multiply(four->stiffness_nm_per_rad, subtract(desired, angle)));
    const struct twd_four torque = subtract(driven_nm, multiply(four->damping_nms_per_rad, velocity));

    /* Comparisons that a value which is not a number fails; without branches. */
    int32_t fits[4];
    for (int j = 0; j < 4; j++)
        fits[j] = (angle_square.of[j] <= twd_four_constants.largest_angle_square.of[j]) &
                  (square_sum.of[j] <= twd_four_constants.largest_square_sum.of[j]) &
                  (torque.of[j] >= four->lower_limit_nm.of[j]) & (torque.of[j] <= four->upper_limit_nm.of[j]);
    if (!(fits[0] & fits[1] & fits[2] & fits[3])) return false;
    for (int j = 0; j < 4; j++)
        torque_nm[j] = torque.of[j];
    return true;
}

#endif

#endif
