/* The population code of object shape and size. */
#include "learner_test.h"

#include <twiddle/input_map.h>

static const enum twd_shape shapes[] = {TWD_SHAPE_SPHERE, TWD_SHAPE_CYLINDER, TWD_SHAPE_CUBE};

static double squared_norm_of(const twd_num *input)
{
    double sum = 0.0;
    for (int i = 0; i < TWD_INPUTS; i++)
        sum += twd_num_to_double(input[i]) * twd_num_to_double(input[i]);
    return sum;
}

/* For the nine objects the sum of the squared responses is the asked one, within 1 %. */
static void squared_norm_is_the_asked_one(void **state)
{
    static const double sizes_m[] = {0.028, 0.032, 0.036};
    static const double norms[] = {0.5, 1.0, 10.0, 20.0};
    (void)state;
    for (int shape = 0; shape < TWD_SHAPES; shape++) {
        for (int size = 0; size < 3; size++) {
            for (int norm = 0; norm < 4; norm++) {
                twd_num input[TWD_INPUTS];
                twd_input_map(shapes[shape], twd_num_from_double(sizes_m[size]), twd_wide_from_double(norms[norm]),
                              input);
                assert_close(squared_norm_of(input), norms[norm], 0.01 * norms[norm]);
            }
        }
    }
}

/* Each response is sqrt(norm / sqrt(pi)) exp(-((size - preferred) / 2 mm)^2 / 2) in the object's row, and 0 in the
 * others; expected from libm in double precision, for a size between two units. */
static void responses_are_gaussian_in_the_row_of_the_shape(void **state)
{
    const double size_m = 0.0293;
    const double amplitude = sqrt(10.0 / sqrt(acos(-1.0)));
    (void)state;
    for (int shape = 0; shape < TWD_SHAPES; shape++) {
        twd_num input[TWD_INPUTS];
        twd_input_map(shapes[shape], twd_num_from_double(size_m), TWD_WIDE(10), input);
        for (int i = 0; i < TWD_INPUTS; i++) {
            const double distance = (size_m - (0.024 + 0.002 * (i % 9))) / 0.002;
            const double response = amplitude * exp(-0.5 * distance * distance);
            assert_num_close(input[i], i / 9 == shape ? response : 0.0, 10.0 * ROUNDING);
        }
    }
}

/* At a unit's own preferred size the responses are, by hand for norm 10: amplitude 2.3753 at the unit, times exp(-1/2)
 * = 0.60653 beside it, exp(-2) = 0.13534 two away. */
static void responses_at_a_preferred_size_equal_the_worked_values(void **state)
{
    twd_num input[TWD_INPUTS];
    (void)state;
    twd_input_map(TWD_SHAPE_CYLINDER, TWD_NUM(0.032), TWD_WIDE(10), input);
    assert_num_close(input[9 + 4], 2.3753, 1e-4);
    assert_num_close(input[9 + 3], 1.4407, 1e-4);
    assert_num_close(input[9 + 5], 1.4407, 1e-4);
    assert_num_close(input[9 + 2], 0.3215, 1e-4);
    assert_num_close(input[9 + 6], 0.3215, 1e-4);
}

/* Sizes and norms that make no sense give finite responses: nothing for a norm of 0 or less, or for one that is not a
 * number. */
static void senseless_values_give_finite_responses(void **state)
{
    static const double sizes_m[] = {-1.0, 0.0, 0.028, 1e6, (double)INFINITY, (double)NAN};
    static const double norms[] = {-1.0, 0.0, (double)NAN, (double)INFINITY, 1e30};
    (void)state;
    for (int size = 0; size < 6; size++) {
        for (int norm = 0; norm < 5; norm++) {
            twd_num input[TWD_INPUTS];
            twd_input_map(TWD_SHAPE_SPHERE, twd_num_from_double(sizes_m[size]), twd_wide_from_double(norms[norm]),
                          input);
            const double sum = squared_norm_of(input);
            assert_true(isfinite(sum));
            if (norm < 3) assert_true(sum <= 0.0);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(squared_norm_is_the_asked_one),
        cmocka_unit_test(responses_are_gaussian_in_the_row_of_the_shape),
        cmocka_unit_test(responses_at_a_preferred_size_equal_the_worked_values),
        cmocka_unit_test(senseless_values_give_finite_responses),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
