#include "controller_test.h"

#include <twiddle/elementary.h>

/* The bounds that elementary.h states. The exponential's is relative in float and double, and absolute in fixed. */
#define EXP_BOUND BY_NUMBER(1e-11, 1e-6, 2e-7)
#define EXP_OF_NUM_BOUND BY_NUMBER(1e-11, 1e-6, 4e-8)
#define SIGMOID_BOUND BY_NUMBER(1e-11, 2e-7, 2e-7)

static double max(double a, double b)
{
    return a > b ? a : b;
}

/* The error of `actual` for exp(-x), as the bounds count it. */
static double exponential_error(twd_num actual, double x)
{
    const double expected = exp(-x);
    const double error = fabs(twd_num_to_double(actual) - expected);
    return BY_NUMBER(error / expected, error / expected, error);
}

/* On [0, 32] exp(-x) keeps its bound against libm; exp(0) is 1. */
static void exponential_keeps_its_bound(void **state)
{
    (void)state;
    const int32_t cases = CASES(1000000);
    double worst = 0.0;
    for (int32_t k = 0; k <= cases; k++) {
        const twd_wide x = twd_wide_from_double(32.0 * (double)k / (double)cases);
        worst = max(worst, exponential_error(twd_exp_negative(x), twd_wide_to_double(x)));
    }
    print_message("exponential: error at most %.2g\n", worst);
    /* libm's own exp(-32) errs by the last bit of its argument. */
    assert_bound(worst, EXP_BOUND + 32.0 * DBL_EPSILON);
    assert_true(twd_exp_negative(TWD_WIDE(0)) == TWD_NUM(1));
}

/* The same for numbers, on [0, 1) and beyond. */
static void exponential_of_a_number_keeps_its_bound(void **state)
{
    (void)state;
    const int32_t cases = CASES(100000);
    double worst_below_one = 0.0;
    double worst_beyond = 0.0;
    for (int32_t k = 0; k <= cases; k++) {
        const twd_num x = twd_num_from_double((double)k / ((double)cases + 1.0));
        worst_below_one = max(worst_below_one, exponential_error(twd_exp_negative_of_num(x), twd_num_to_double(x)));
        const twd_num y = twd_num_from_double(1.0 + 6.0 * (double)k / (double)cases);
        worst_beyond = max(worst_beyond, exponential_error(twd_exp_negative_of_num(y), twd_num_to_double(y)));
    }
    print_message("exponential of a number: error at most %.2g below 1, %.2g beyond\n", worst_below_one, worst_beyond);
    assert_bound(worst_below_one, EXP_OF_NUM_BOUND);
    assert_bound(worst_beyond, EXP_BOUND);
    assert_true(twd_exp_negative_of_num(TWD_NUM(0)) == TWD_NUM(1));
}

/* Below 0, above 32 and at values that are no numbers, exp(-x) answers as elementary.h says, by a limit of its
 * argument. */
static void exponential_limits_its_argument(void **state)
{
    (void)state;
    const twd_num at_limit = twd_exp_negative(TWD_WIDE(32));
    assert_true(twd_exp_negative(TWD_WIDE(-3)) == TWD_NUM(1));
    assert_true(twd_exp_negative(twd_wide_from_double(-1e30)) == TWD_NUM(1));
    assert_true(twd_exp_negative(TWD_WIDE(100)) == at_limit);
    assert_true(twd_exp_negative(twd_wide_from_double(1e30)) == at_limit);
    assert_true(twd_exp_negative_of_num(TWD_NUM(-3)) == TWD_NUM(1));
#if !defined(TWD_NUMBER_FIXED) /* there an infinity is no number */
    assert_true(twd_exp_negative(twd_wide_from_double((double)INFINITY)) == at_limit);
#endif
    assert_true(twd_within(twd_exp_negative(twd_wide_from_double((double)NAN)), TWD_NUM(0), TWD_NUM(1)));
    assert_true(twd_within(twd_exp_negative_of_num(twd_num_from_double((double)NAN)), TWD_NUM(0), TWD_NUM(1)));
}

/* On [-50, 50] the logistic function keeps its bound against libm and stays in [0, 1]. */
static void sigmoid_keeps_its_bound(void **state)
{
    (void)state;
    const int32_t cases = CASES(500000);
    double worst = 0.0;
    for (int32_t k = -cases; k <= cases; k++) {
        const twd_wide x = twd_wide_from_double(50.0 * (double)k / (double)cases);
        const twd_num y = twd_sigmoid(x);
        assert_true(twd_within(y, TWD_NUM(0), TWD_NUM(1)));
        worst = max(worst, fabs(twd_num_to_double(y) - 1.0 / (1.0 + exp(-twd_wide_to_double(x)))));
    }
    print_message("sigmoid: error at most %.2g\n", worst);
    assert_bound(worst, SIGMOID_BOUND);
    assert_true(twd_sigmoid(TWD_WIDE(0)) == TWD_NUM(0.5));
}

/* At the ends of its argument's range, and for what is no number, the logistic function stays in [0, 1]; far out it is
 * 0 or 1. */
static void sigmoid_takes_any_value(void **state)
{
    (void)state;
    static const double values[] = {-1e30, 1e30, (double)NAN, (double)INFINITY, -(double)INFINITY};
    for (size_t k = 0; k < sizeof values / sizeof *values; k++) {
        const twd_num y = twd_sigmoid(twd_wide_from_double(values[k]));
        assert_true(twd_within(y, TWD_NUM(0), TWD_NUM(1)));
        if (k < 2) assert_num_close(y, k == 0 ? 0.0 : 1.0, SIGMOID_BOUND);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exponential_keeps_its_bound),     cmocka_unit_test(exponential_of_a_number_keeps_its_bound),
        cmocka_unit_test(exponential_limits_its_argument), cmocka_unit_test(sigmoid_keeps_its_bound),
        cmocka_unit_test(sigmoid_takes_any_value),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
