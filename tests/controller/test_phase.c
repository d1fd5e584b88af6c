#include "controller_test.h"

#include <twiddle/phase.h>

/* The bound that phase.h states, for both number types. */
#define SINE_BOUND BY_NUMBER(1e-8, 2e-7)

static double max(double a, double b)
{
    return a > b ? a : b;
}

/* The largest error at `phase` of twd_sin, twd_cos and twd_sine_cosine against libm. */
static double error_at(twd_phase phase)
{
    const double radians = 2.0 * PI * (double)phase / 4294967296.0;
    twd_num sine, cosine;
    twd_sine_cosine(phase, &sine, &cosine);
    const double of_sine = max(fabs((double)twd_sin(phase) - sin(radians)), fabs((double)sine - sin(radians)));
    const double of_cosine = max(fabs((double)twd_cos(phase) - cos(radians)), fabs((double)cosine - cos(radians)));
    return max(of_sine, of_cosine);
}

/* Over 4 million phases, every octant boundary's neighbours among them, sine and cosine, alone and together, keep their
 * bound against libm. */
static void sine_and_cosine_keep_their_bound(void **state)
{
    (void)state;
    double worst = 0.0;
    for (uint64_t phase = 0; phase < (UINT64_C(1) << 32); phase += 1021)
        worst = max(worst, error_at((twd_phase)phase));
    for (uint32_t octant = 0; octant < 8; octant++)
        for (uint32_t offset = 0; offset < 2000; offset++)
            worst = max(worst, error_at(octant * UINT32_C(0x20000000) + offset - 1000U));
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

/* A quarter turn more makes the pair's sine its cosine and the cosine its negative sine, to the last bit; the quarter
 * turns themselves are exact. */
static void sine_and_cosine_change_places_at_a_quarter_turn(void **state)
{
    (void)state;
    uint64_t random = 2;
    twd_num sine, cosine, next_sine, next_cosine;
    for (int k = 0; k < 100000; k++) {
        const twd_phase p = uniform_phase(&random);
        twd_sine_cosine(p, &sine, &cosine);
        twd_sine_cosine(p + UINT32_C(0x40000000), &next_sine, &next_cosine);
        assert_true(next_sine == cosine && next_cosine == -sine);
    }
    twd_sine_cosine(0, &sine, &cosine);
    assert_true(sine == TWD_NUM(0) && cosine == TWD_NUM(1));
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
        cmocka_unit_test(sine_and_cosine_change_places_at_a_quarter_turn),
        cmocka_unit_test(conversions_are_exact_in_binary_fractions),
        cmocka_unit_test(conversions_clamp),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
