/* four.h: arithmetic with four numbers at once, for what controller.c and cpg.c compute so. Not installed.
 *
 * Each loop is one instruction, or two in the double build: GCC 12 finds so at -O2. Sums and products are those of the
 * functions that compute one number at a time, in the same order, so the results are the same to the last bit. */
#ifndef TWIDDLE_FOUR_H
#define TWIDDLE_FOUR_H

#include <twiddle/detail/controller_names.h>
#include <twiddle/detail/four.h>
#include <twiddle/phase.h>

#if TWD_FOUR_AT_ONCE

#define twd_four_constants TWD_BUILD_NAME(twd_four_constants)

/* Each number four times. */
struct twd_four_constants {
    /* Polynomials of float/phase.h, the highest power first. */
    struct twd_four sine[5];
    struct twd_four twice_half_sine[5];
    struct twd_four half_cosine[5];
    struct twd_four half;
    struct twd_four one;
    /* What is larger than the square of an angle of [-pi, pi] or a sum of two usable numbers' squares is left to
     * others, and so is some of what is just as large. */
    struct twd_four largest_angle_square;
    struct twd_four largest_square_sum;
};

/* In a file that does not use it: compilers that see the numbers build each four from one, in twice the
 * instructions. */
extern const struct twd_four_constants twd_four_constants;

static inline struct twd_four four_load(const twd_num *number)
{
    struct twd_four loaded;
    for (int j = 0; j < 4; j++)
        loaded.of[j] = number[j];
    return loaded;
}

static inline struct twd_four four_add(struct twd_four a, struct twd_four b)
{
    struct twd_four sum;
    for (int j = 0; j < 4; j++)
        sum.of[j] = a.of[j] + b.of[j];
    return sum;
}

static inline struct twd_four four_subtract(struct twd_four a, struct twd_four b)
{
    struct twd_four difference;
    for (int j = 0; j < 4; j++)
        difference.of[j] = a.of[j] - b.of[j];
    return difference;
}

static inline struct twd_four four_multiply(struct twd_four a, struct twd_four b)
{
    struct twd_four product;
    for (int j = 0; j < 4; j++)
        product.of[j] = twd_mul(a.of[j], b.of[j]);
    return product;
}

/* a * b + c */
static inline struct twd_four four_multiply_add(struct twd_four a, struct twd_four b, struct twd_four c)
{
    struct twd_four sum;
    for (int j = 0; j < 4; j++)
        sum.of[j] = twd_mul(a.of[j], b.of[j]) + c.of[j];
    return sum;
}

/* The first and the second change places, and so do the third and the fourth. */
static inline struct twd_four four_swap(struct twd_four a)
{
    const struct twd_four swapped = {{a.of[1], a.of[0], a.of[3], a.of[2]}};
    return swapped;
}

static inline void four_store(struct twd_four a, twd_num *number)
{
    for (int j = 0; j < 4; j++)
        number[j] = a.of[j];
}

static inline struct twd_four four_smaller(struct twd_four a, struct twd_four b)
{
    struct twd_four smaller;
    for (int j = 0; j < 4; j++)
        smaller.of[j] = a.of[j] < b.of[j] ? a.of[j] : b.of[j];
    return smaller;
}

/* twd_cos, of [4] */
static inline void four_cosine(const twd_phase *phase, twd_num *cosine)
{
    const struct twd_four *const term = twd_four_constants.sine;
    struct twd_four u;
    for (int j = 0; j < 4; j++) {
        const uint32_t sign = (uint32_t)((int32_t)phase[j] >> 31);
        u.of[j] = twd_quarters_of_phase(TWD_QUARTER_TURN - ((phase[j] ^ sign) - sign));
    }
    const struct twd_four square = four_multiply(u, u);
    struct twd_four sum = term[0];
    sum = four_multiply_add(sum, square, term[1]);
    sum = four_multiply_add(sum, square, term[2]);
    sum = four_multiply_add(sum, square, term[3]);
    sum = four_multiply_add(sum, square, term[4]);
    four_store(four_multiply_add(sum, u, u), cosine);
}

/* twd_sine_cosine_of_angle, of angles in [-pi, pi] with these squares. */
static inline void four_sine_cosine(struct twd_four angle, struct twd_four square, struct twd_four *sine,
                                    struct twd_four *cosine)
{
    const struct twd_four_constants *const constant = &twd_four_constants;
    struct twd_four sum = constant->twice_half_sine[0];
    sum = four_multiply_add(sum, square, constant->twice_half_sine[1]);
    sum = four_multiply_add(sum, square, constant->twice_half_sine[2]);
    sum = four_multiply_add(sum, square, constant->twice_half_sine[3]);
    sum = four_multiply_add(sum, square, constant->twice_half_sine[4]);
    const struct twd_four twice_half_sine = four_multiply_add(four_multiply(sum, square), angle, angle);

    sum = constant->half_cosine[0];
    sum = four_multiply_add(sum, square, constant->half_cosine[1]);
    sum = four_multiply_add(sum, square, constant->half_cosine[2]);
    sum = four_multiply_add(sum, square, constant->half_cosine[3]);
    sum = four_multiply_add(sum, square, constant->half_cosine[4]);
    const struct twd_four half_cosine = four_multiply_add(sum, square, constant->one);
    const struct twd_four half_sine = four_multiply(twice_half_sine, constant->half);

    *sine = four_multiply(twice_half_sine, half_cosine);
    *cosine = four_subtract(four_multiply(half_cosine, half_cosine), four_multiply(half_sine, half_sine));
}

#endif

#endif
