/* The generator against published vectors of its parts, and its map onto real numbers. */
#include "learner_test.h"

#include <twiddle/random.h>

/* Ten outputs from the state 1, 2, 3, 4 equal those of the authors' C code, as the Rust crate rand_xoshiro lists them
 * (src/xoshiro128plusplus.rs, test `reference`; produced with prng.di.unimi.it/xoshiro128plusplus.c). */
static void outputs_equal_the_published_vector(void **state)
{
    static const uint32_t expected[] = {641U,        1573767U,    3222811527U, 3517856514U, 836907274U,
                                        4247214768U, 3867114732U, 1355841295U, 495546011U,  621204420U};
    struct twd_random random = {{1, 2, 3, 4}};
    (void)state;
    for (size_t i = 0; i < sizeof expected / sizeof expected[0]; i++)
        assert_int_equal(twd_random_next(&random), expected[i]);
}

/* The seeded state is two outputs of SplitMix64, low word first. Expected: its first five outputs for seed 1234567,
 * from Rosetta Code, "Pseudo-random numbers/Splitmix64". Its state is a counter in steps of 0x9E3779B97F4A7C15, so that
 * a seed moved by k steps starts k outputs later. */
static void seeding_equals_the_published_splitmix64_vector(void **state)
{
    static const uint64_t expected[] = {6457827717110365317U, 3203168211198807973U, 9817491932198370423U,
                                        4593380528125082431U, 16408922859458223821U};
    (void)state;
    for (uint64_t start = 0; start < 4; start++) {
        struct twd_random random;
        twd_random_seed(&random, 1234567U + start * 0x9E3779B97F4A7C15U);
        for (uint64_t word = 0; word < 2; word++) {
            assert_int_equal(random.state[2 * word], (uint32_t)expected[start + word]);
            assert_int_equal(random.state[2 * word + 1], (uint32_t)(expected[start + word] >> 32));
        }
    }
}

/* A draw is the upper 24 bits of the next output, spread over [-h, h). Expected, by hand from the published outputs of
 * the state 1, 2, 3, 4: 641 >> 8 = 2, 1573767 >> 8 = 6147, 3222811527 >> 8 = 12589107, each divided by 2^23, minus
 * 1. */
static void symmetric_draw_uses_the_upper_24_bits(void **state)
{
    static const double upper_bits[] = {2.0, 6147.0, 12589107.0};
    struct twd_random random = {{1, 2, 3, 4}};
    (void)state;
    for (size_t i = 0; i < sizeof upper_bits / sizeof upper_bits[0]; i++) {
        const double expected = 0.5 * (upper_bits[i] / 8388608.0 - 1.0);
        assert_num_close(twd_random_symmetric(&random, TWD_NUM(0.5)), expected, 1e-15);
    }
}

/* A million draws stay in [-h, h), and their mean and variance are the uniform distribution's, 0 and h^2 / 3, within
 * five standard errors. */
static void symmetric_draws_are_uniform(void **state)
{
    const int32_t draws = CASES(1000000);
    const double half_range = 0.3;
    struct twd_random random;
    double sum = 0.0;
    double sum_of_squares = 0.0;
    (void)state;
    print_message("seed 20110824\n");
    twd_random_seed(&random, 20110824U);
    for (int32_t i = 0; i < draws; i++) {
        const twd_num number = twd_random_symmetric(&random, TWD_NUM(0.3));
        const double draw = twd_num_to_double(number);
        assert_true(number >= -TWD_NUM(0.3) && number < TWD_NUM(0.3));
        sum += draw;
        sum_of_squares += draw * draw;
    }
    const double count = (double)draws;
    const double variance = half_range * half_range / 3.0;
    const double variance_of_squares = half_range * half_range * half_range * half_range * (1.0 / 5.0 - 1.0 / 9.0);
    assert_true(fabs(sum / count) < 5.0 * sqrt(variance / count));
    assert_true(fabs(sum_of_squares / count - variance) < 5.0 * sqrt(variance_of_squares / count));
}

/* Neighbouring seeds and seed 0 start from states that differ and are not all zero. */
static void every_seed_gives_a_usable_state(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 1000; seed++) {
        struct twd_random one;
        struct twd_random next;
        twd_random_seed(&one, seed);
        twd_random_seed(&next, seed + 1);
        assert_true((one.state[0] | one.state[1] | one.state[2] | one.state[3]) != 0);
        assert_memory_not_equal(one.state, next.state, sizeof one.state);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(outputs_equal_the_published_vector),
        cmocka_unit_test(seeding_equals_the_published_splitmix64_vector),
        cmocka_unit_test(symmetric_draw_uses_the_upper_24_bits),
        cmocka_unit_test(symmetric_draws_are_uniform),
        cmocka_unit_test(every_seed_gives_a_usable_state),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
