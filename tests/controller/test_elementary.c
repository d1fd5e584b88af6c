#include "controller_test.h"

#include <twiddle/elementary.h>

/* The bounds that elementary.h states, for both number types. */
#define EXP_BOUND BY_NUMBER(1e-11, 1e-6)
#define SIGMOID_BOUND BY_NUMBER(1e-11, 2e-7)

static double max(double a, double b)
{
    return a > b ? a : b;
}

/* On [0, 32] the relative error of exp(-x) keeps its bound against libm; exp(0) is 1. */
static void exponential_keeps_its_bound(void **state)
{
    (void)state;
    double worst = 0.0;
    for (int k = 0; k <= 1000000; k++) {
        const twd_num x = (twd_num)(32.0 * k / 1e6);
        const double expected = exp(-(double)x);
        worst = max(worst, fabs((double)twd_exp_negative(x) - expected) / expected);
    }
    print_message("exponential: relative error at most %.2g\n", worst);
    assert_true(worst <= EXP_BOUND);
    assert_true(twd_exp_negative(TWD_NUM(0)) == TWD_NUM(1));
}

/* Below 0, above 32 and at values that are no numbers, exp(-x) answers as elementary.h says, by a limit of its
 * argument. */
static void exponential_limits_its_argument(void **state)
{
    (void)state;
    assert_true(twd_exp_negative(TWD_NUM(-3)) == TWD_NUM(1));
    assert_true(twd_exp_negative(TWD_NUM(1000)) == twd_exp_negative(TWD_NUM(32)));
    assert_true(twd_exp_negative((twd_num)INFINITY) == twd_exp_negative(TWD_NUM(32)));
    assert_true(twd_within(twd_exp_negative((twd_num)NAN), TWD_NUM(0), TWD_NUM(1)));
}

/* On [-50, 50] the logistic function keeps its bound against libm and stays in [0, 1]. */
static void sigmoid_keeps_its_bound(void **state)
{
    (void)state;
    double worst = 0.0;
    for (int k = -500000; k <= 500000; k++) {
        const twd_num x = (twd_num)(50.0 * k / 5e5);
        const twd_num y = twd_sigmoid(x);
        assert_true(twd_within(y, TWD_NUM(0), TWD_NUM(1)));
        worst = max(worst, fabs((double)y - 1.0 / (1.0 + exp(-(double)x))));
    }
    print_message("sigmoid: error at most %.2g\n", worst);
    assert_true(worst <= SIGMOID_BOUND);
    assert_true(twd_sigmoid(TWD_NUM(0)) == TWD_NUM(0.5));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exponential_keeps_its_bound),
        cmocka_unit_test(exponential_limits_its_argument),
        cmocka_unit_test(sigmoid_keeps_its_bound),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
