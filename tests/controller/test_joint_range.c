#include "controller_test.h"

#include <twiddle/joint_range.h>

/* Fixed: half a step of 2^-28 for each number that goes in or comes out, three at most. */
#define ROUNDING BY_NUMBER(1e-15, 1e-6, 1.5 * NUM_STEP)

/* Fractions 0, 1/4, 1 of [-0.2, 0.6] are -0.2, 0, 0.6; beyond [0, 1], and for what is no number, an end of the
 * range. */
static void angles_span_the_range(void **state)
{
    (void)state;
    const struct twd_joint_range range = {TWD_NUM(-0.2), TWD_NUM(0.6)};
    assert_true(twd_joint_range_angle(&range, TWD_NUM(0)) == range.lower_rad);
    assert_num_close(twd_joint_range_angle(&range, TWD_NUM(0.25)), 0.0, ROUNDING);
    assert_num_close(twd_joint_range_angle(&range, TWD_NUM(1)), 0.6, ROUNDING);
    assert_true(twd_joint_range_angle(&range, TWD_NUM(-0.3)) == range.lower_rad);
    assert_true(twd_joint_range_angle(&range, TWD_NUM(1.3)) == twd_joint_range_angle(&range, TWD_NUM(1)));
    assert_true(twd_joint_range_angle(&range, twd_num_from_double((double)NAN)) == range.lower_rad);
}

/* 1000 random ranges: the angle of fraction 1 is not beyond the upper end by a rounding. */
static void angle_never_leaves_the_range(void **state)
{
    (void)state;
    uint64_t random = 6;
    print_message("seed 6\n");
    for (int32_t repeat = CASES(1000); repeat > 0; repeat--) {
        const twd_num lower = twd_num_from_double(uniform(&random, -3.0, 0.0));
        const twd_num upper = twd_num_from_double(uniform(&random, 0.0, 3.0));
        const struct twd_joint_range range = {lower, upper};
        assert_true(twd_within(twd_joint_range_angle(&range, TWD_NUM(1)), lower, upper));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(angles_span_the_range),
        cmocka_unit_test(angle_never_leaves_the_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
