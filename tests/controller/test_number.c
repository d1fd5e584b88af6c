/* The numbers' operations and conversions, as they hold in every build (the fixed build's words:
 * test_fixed_number.c). */
#include "c_test.h"

/* One operation on doubles, by way of the library's types. */
#define ON_DOUBLES(name, function, result, first, second)                                                              \
    static double name(double a, double b)                                                                             \
    {                                                                                                                  \
        return twd_##result##_to_double(function(twd_##first##_from_double(a), twd_##second##_from_double(b)));        \
    }

ON_DOUBLES(mul, twd_mul, num, num, num)
ON_DOUBLES(mul_short, twd_mul_short, num, num, num)
ON_DOUBLES(mul_saturated, twd_mul_saturated, num, num, num)
ON_DOUBLES(add_saturated, twd_add_saturated, num, num, num)
ON_DOUBLES(subtract_saturated, twd_subtract_saturated, num, num, num)
ON_DOUBLES(div_num, twd_div, num, num, num)
ON_DOUBLES(wide_product, twd_wide_product, wide, num, num)
ON_DOUBLES(wide_mul, twd_wide_mul, wide, num, wide)
ON_DOUBLES(wide_add, twd_wide_add, wide, wide, wide)
ON_DOUBLES(wide_subtract, twd_wide_subtract, wide, wide, wide)
ON_DOUBLES(wide_div, twd_wide_div, wide, wide, wide)
ON_DOUBLES(num_mul_wide, twd_num_mul_wide, num, num, wide)
ON_DOUBLES(num_mul_rate, twd_num_mul_rate, num, num, rate)
ON_DOUBLES(num_mul_small, twd_num_mul_small, num, num, small)
ON_DOUBLES(num_div_wide, twd_num_div_wide, num, num, wide)
ON_DOUBLES(num_mul_rate_small, twd_num_mul_rate_small, num, rate, small)
ON_DOUBLES(small_mul, twd_small_mul, small, num, small)
ON_DOUBLES(wide_div_small, twd_wide_div_small, wide, small, small)

/* In every build an operation on short binary fractions, whose result is one, gives exactly that. Expected: by hand. */
static void exact_values_give_exact_results(void **state)
{
    static const struct {
        double (*operation)(double, double);
        double a, b, expected;
    } cases[] = {
        {mul, 1.5, -2.25, -3.375},
        {mul_short, -0.75, 0.5, -0.375},
        {mul_saturated, -2.5, -3, 7.5},
        {add_saturated, 3.5, -7.25, -3.75},
        {subtract_saturated, 3.5, 7.25, -3.75},
        {div_num, -3.375, 2.25, -1.5},
        {wide_product, 6.5, -7.5, -48.75},
        {wide_mul, -1.5, 80.5, -120.75},
        {wide_add, 100.25, 20.5, 120.75},
        {wide_subtract, -100.25, 20.5, -120.75},
        {wide_div, 120.75, -1.5, -80.5},
        {num_mul_wide, 0.0625, -100, -6.25},
        {num_mul_rate, 0.00390625, 1000, 3.90625},
        {num_mul_small, 5, -0.03125, -0.15625},
        {num_div_wide, -6.25, -100, 0.0625},
        {num_mul_rate_small, 20, 0.0078125, 0.15625},
        {small_mul, -0.25, 0.09375, -0.0234375},
        {wide_div_small, 0.0625, 0.001953125, 32},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const double result = cases[i].operation(cases[i].a, cases[i].b);
        if (result != cases[i].expected) {
            print_error("case %d: got %.12g, expected %.12g\n", (int)i, result, cases[i].expected);
            fail();
        }
    }
    assert_true(twd_wide_to_double(twd_wide_half(TWD_WIDE(-100.5))) == -50.25);
    assert_true(twd_small_to_double(twd_small_half(TWD_SMALL(0.09375))) == 0.046875);
    assert_true(twd_num_to_double(twd_num_of_wide(TWD_WIDE(-7.125))) == -7.125);
    assert_true(twd_wide_to_double(twd_wide_of_num(TWD_NUM(-7.125))) == -7.125);
    assert_true(twd_num_to_double(twd_ratio(-3, 8)) == -0.375);
}

/* A clamp gives the nearest value inside, and what is at a limit is inside. */
static void clamps_keep_to_their_limits(void **state)
{
    const twd_num lower = TWD_NUM(-0.5);
    const twd_num upper = TWD_NUM(2);
    (void)state;
    assert_true(twd_clamp(TWD_NUM(-0.75), lower, upper) == lower && twd_clamp(lower, lower, upper) == lower);
    assert_true(twd_clamp(TWD_NUM(1), lower, upper) == TWD_NUM(1) && twd_clamp(upper, lower, upper) == upper);
    assert_true(twd_clamp(TWD_NUM(7), lower, upper) == upper);
    assert_true(twd_wide_clamp(TWD_WIDE(90), TWD_WIDE(-1), TWD_WIDE(80)) == TWD_WIDE(80));
    assert_true(twd_wide_clamp(TWD_WIDE(-90), TWD_WIDE(-1), TWD_WIDE(80)) == TWD_WIDE(-1));
    assert_true(twd_within(lower, lower, upper) && twd_within(upper, lower, upper));
    assert_true(!twd_within(TWD_NUM(-0.625), lower, upper) && !twd_within(TWD_NUM(2.125), lower, upper));
}

/* What is not a number, or infinite, is not usable, whatever type it came as; and no clamp lets it through. */
static void no_numbers_are_not_usable(void **state)
{
    const double values[] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    (void)state;
    for (size_t i = 0; i < 3; i++) {
        assert_true(!twd_is_usable(twd_num_from_double(values[i])));
        assert_true(!twd_wide_is_usable(twd_wide_from_double(values[i])));
        assert_true(!twd_rate_is_usable(twd_rate_from_double(values[i])));
        assert_true(!twd_small_is_usable(twd_small_from_double(values[i])));
        assert_true(!twd_wide_is_finite(twd_wide_from_double(values[i])));
        assert_true(!twd_within(twd_num_from_double(values[i]), TWD_NUM(-1), TWD_NUM(1)));
        const twd_num clamped = twd_clamp(twd_num_from_double(values[i]), TWD_NUM(-1), TWD_NUM(1));
        assert_true(twd_within(clamped, TWD_NUM(-1), TWD_NUM(1)));
    }
    assert_true(twd_clamp(twd_num_from_double((double)NAN), TWD_NUM(-1), TWD_NUM(1)) == TWD_NUM(-1));
    assert_true(twd_is_usable(TWD_NUM(0)) && twd_is_usable(TWD_NUM(-7.5)));
    assert_true(twd_wide_is_usable(TWD_WIDE(-100)) && twd_wide_is_finite(TWD_WIDE(-100)));
    assert_true(twd_rate_is_usable(TWD_RATE(2000)) && twd_small_is_usable(TWD_SMALL(-0.1)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exact_values_give_exact_results),
        cmocka_unit_test(clamps_keep_to_their_limits),
        cmocka_unit_test(no_numbers_are_not_usable),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
