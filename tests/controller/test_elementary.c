#include "controller_test.h"

#include <twiddle/elementary.h>

/* The bounds that elementary.h states, for both number types. */
#define SINE_BOUND BY_NUMBER(1e-8, 2e-7)
#define EXP_BOUND BY_NUMBER(1e-11, 1e-6)
#define SIGMOID_BOUND BY_NUMBER(1e-11, 2e-7)

static double max(double a, double b)
{
    return a > b ? a : b;
}

static double radians(twd_phase phase)
{
    return 2.0 * PI * (double)phase / 4294967296.0;
}

/* Over 4 million phases, every octant boundary's neighbours among them, sine and cosine keep their bound against
 * libm. */
static void sine_and_cosine_keep_their_bound(void **state)
{
    (void)state;
    double worst = 0.0;
    for (uint64_t phase = 0; phase < (UINT64_C(1) << 32); phase += 1021) {
        const twd_phase p = (twd_phase)phase;
        worst = max(worst, fabs((double)twd_sin(p) - sin(radians(p))));
        worst = max(worst, fabs((double)twd_cos(p) - cos(radians(p))));
    }
    for (uint32_t octant = 0; octant < 8; octant++) {
        for (uint32_t offset = 0; offset < 2000; offset++) {
            const twd_phase p = octant * UINT32_C(0x20000000) + offset - 1000U;
            worst = max(worst, fabs((double)twd_sin(p) - sin(radians(p))));
            worst = max(worst, fabs((double)twd_cos(p) - cos(radians(p))));
        }
    }
    print_message("sine and cosine: error at most %.2g\n", worst);
    assert_true(worst <= SINE_BOUND);
}

/* sin(-theta) = -sin(theta) and sin(half a turn - theta) = sin(theta) hold to the last bit. */
static void sine_is_odd_and_symmetric(void **state)
{
    (void)state;
    uint64_t random = 1;
    for (int k = 0; k < 100000; k++) {
        const twd_phase p = uniform_phase(&random);
        assert_true(twd_sin(0U - p) == -twd_sin(p));
        assert_true(twd_sin(UINT32_C(0x80000000) - p) == twd_sin(p));
    }
    assert_true(twd_sin(0) == TWD_NUM(0));
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

/* Turns, angles and fractions become phases exactly where they are exact in binary, else within one rounding. */
static void conversions_are_exact_in_binary_fractions(void **state)
{
    (void)state;
    assert_int_equal(twd_phase_from_turns(TWD_NUM(0.25)), 0x40000000);
    assert_int_equal(twd_phase_from_turns(TWD_NUM(-0.25)), 0xC0000000);
    assert_int_equal(twd_phase_from_turns(TWD_NUM(0)), 0);
    assert_int_equal(twd_phase_from_fraction(TWD_NUM(0)), 0);
    assert_int_equal(twd_phase_from_fraction(TWD_NUM(0.5)), 0x80000000);
    assert_int_equal(twd_phase_from_fraction(TWD_NUM(0.75)), 0xC0000000);
    assert_int_equal(twd_phase_from_fraction(TWD_NUM(1)), 0);

    const double rounding_turns = BY_NUMBER(1e-9, 1e-7);
    for (int k = -499; k <= 499; k++) {
        const double turns = k / 1000.0;
        assert_true(fabs(signed_turns(twd_phase_from_turns((twd_num)turns)) - turns) <= rounding_turns);
        assert_true(fabs(signed_turns(twd_phase_from_angle((twd_num)(2.0 * PI * turns))) - turns) <= rounding_turns);
        const twd_phase fraction = twd_phase_from_fraction((twd_num)(turns + 0.5));
        assert_true(fabs((double)fraction / 4294967296.0 - (turns + 0.5)) <= rounding_turns);
    }
}

/* What lies beyond a conversion's range counts as its nearest end. */
static void conversions_clamp(void **state)
{
    (void)state;
    const double last = 0.5 - 1e-7;
    assert_true(signed_turns(twd_phase_from_turns(TWD_NUM(0.5))) > last);
    assert_true(signed_turns(twd_phase_from_turns(TWD_NUM(1e30))) > last);
    assert_true(signed_turns(twd_phase_from_turns(TWD_NUM(-7))) < -last);
    assert_true(signed_turns(twd_phase_from_angle(TWD_NUM(PI))) > last);
    assert_true(signed_turns(twd_phase_from_angle(TWD_NUM(-PI))) < -last);
    assert_true(signed_turns(twd_phase_from_angle(TWD_NUM(4))) > last);
    assert_int_equal(twd_phase_from_fraction(TWD_NUM(-1)), 0);
    assert_int_equal(twd_phase_from_fraction(TWD_NUM(2)), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sine_and_cosine_keep_their_bound),
        cmocka_unit_test(sine_is_odd_and_symmetric),
        cmocka_unit_test(exponential_keeps_its_bound),
        cmocka_unit_test(exponential_limits_its_argument),
        cmocka_unit_test(sigmoid_keeps_its_bound),
        cmocka_unit_test(conversions_are_exact_in_binary_fractions),
        cmocka_unit_test(conversions_clamp),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
