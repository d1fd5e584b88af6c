/* A velocity from two angles and the time between them. */
#include "controller_test.h"

/* 1,000 turns of up to 0.5 rad in 1 to 10 ms: the quotient in double precision. Fixed: rounded to
 * nearest. */
static void velocity_is_way_over_period(void **state)
{
    uint64_t random = 91;
    (void)state;
    print_message("seed 91\n");
    for (int32_t i = 0; i < CASES(1000); i++) {
        const twd_num way_rad = twd_num_from_double(uniform(&random, -0.5, 0.5));
        const twd_small period_s = twd_small_from_double(uniform(&random, 0.001, 0.01));
        const double expected = twd_num_to_double(way_rad) / twd_small_to_double(period_s);
        assert_close(twd_rate_to_double(twd_rate_div_small(way_rad, period_s)), expected,
                     BY_NUMBER(1e-12, 1e-4, 0.51 * RATE_STEP));
    }
}

/* 5 rad in 0.5 ms are 10,000 rad/s, beyond the fixed build's 2048: it stays at the end, which the controller does not
 * use. */
static void velocity_beyond_its_range_is_not_usable(void **state)
{
    (void)state;
    for (int sign = -1; sign <= 1; sign += 2) {
        const twd_num way_rad = twd_num_from_double(5.0 * sign);
        const twd_rate velocity_rad_s = twd_rate_div_small(way_rad, TWD_SMALL(0.0005));
        assert_close(twd_rate_to_double(velocity_rad_s), BY_NUMBER(10000.0, 10000.0, 2048.0) * sign, 1e-2);
        assert_int_equal(twd_rate_is_usable(velocity_rad_s), BY_NUMBER(1, 1, 0));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(velocity_is_way_over_period),
        cmocka_unit_test(velocity_beyond_its_range_is_not_usable),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
