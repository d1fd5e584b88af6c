#include "controller_test.h"

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
    const double of_sine =
        max(fabs(twd_num_to_double(twd_sin(phase)) - sin(radians)), fabs(twd_num_to_double(sine) - sin(radians)));
    const double of_cosine =
        max(fabs(twd_num_to_double(twd_cos(phase)) - cos(radians)), fabs(twd_num_to_double(cosine) - cos(radians)));
    return max(of_sine, of_cosine);
}

/* Over 4 million phases, every octant boundary's neighbours among them, sine and cosine, alone and together, keep their
 * bound against libm. */
static void sine_and_cosine_keep_their_bound(void **state)
{
    (void)state;
    double worst = 0.0;
    for (uint64_t phase = 0; phase < (UINT64_C(1) << 32); phase += UINT64_C(1021) * TWD_TEST_THINNING)
        worst = max(worst, error_at((twd_phase)phase));
    const int32_t reach = CASES(1000);
    for (uint32_t octant = 0; octant < 8; octant++)
        for (int32_t offset = -reach; offset < reach; offset++)
            worst = max(worst, error_at(octant * TWD_EIGHTH_TURN + (twd_phase)offset));
    print_message("sine and cosine: error at most %.2g\n", worst);
    assert_bound(worst, SINE_BOUND);
}

/* sin(-theta) = -sin(theta) and sin(half a turn - theta) = sin(theta) hold to the last bit. */
static void sine_is_odd_and_symmetric(void **state)
{
    (void)state;
    uint64_t random = 1;
    for (int32_t k = CASES(100000); k > 0; k--) {
        const twd_phase p = uniform_phase(&random);
        assert_true(twd_sin((twd_phase)0 - p) == -twd_sin(p));
        assert_true(twd_sin(TWD_HALF_TURN - p) == twd_sin(p));
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
    for (int32_t k = CASES(100000); k > 0; k--) {
        const twd_phase p = uniform_phase(&random);
        twd_sine_cosine(p, &sine, &cosine);
        twd_sine_cosine(p + TWD_QUARTER_TURN, &next_sine, &next_cosine);
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

    /* Fixed: half a step of 2^-28, of turns or of rad, and the phase of an angle is a multiple of 2^-30 turn. */
    const double rounding_turns = BY_NUMBER(1e-9, 1e-7, 1.9e-9);
    for (int k = -499; k <= 499; k++) {
        const double turns = k / 1000.0;
        const twd_phase of_turns = twd_phase_from_turns(twd_num_from_double(turns));
        const twd_phase of_angle = twd_phase_from_angle(twd_num_from_double(2.0 * PI * turns));
        const twd_phase of_fraction = twd_phase_from_fraction(twd_num_from_double(turns + 0.5));
        assert_close(signed_turns(of_turns), turns, rounding_turns);
        assert_close(signed_turns(of_angle), turns, rounding_turns);
        assert_close((double)of_fraction / 4294967296.0, turns + 0.5, rounding_turns);
    }
}

/* Frequencies and rates become what they advance in a tick: nu h turns, and w h / 2 pi. */
static void advances_are_turns_of_a_tick(void **state)
{
    (void)state;
    static const double tick_s[] = {0.0001, 0.001, 0.01, 0.1};
    for (int h = 0; h < 4; h++) {
        const twd_small tick = twd_small_from_double(tick_s[h]);
        const twd_turn_gain gain = twd_turn_gain_of_tick(tick);
        for (int k = -30; k <= 30; k++) {
            /* Fixed: half a step of a rate is 5e-10 turns of the longest tick, the gain's 3e-10, and the phase is a
             * multiple of 2^-31 turn. */
            const double frequency_hz = k * 0.16, rate_rad_s = k * 0.5;
            const double turns = frequency_hz * tick_s[h], turns_of_rate = rate_rad_s * tick_s[h] / (2.0 * PI);
            assert_close(signed_turns(twd_phase_from_frequency(twd_num_from_double(frequency_hz), tick)), turns,
                         BY_NUMBER(1e-9, 1e-7, 1.2e-9));
            assert_close(signed_turns(twd_phase_from_rates(twd_wide_from_double(rate_rad_s),
                                                           twd_wide_from_double(rate_rad_s), gain)),
                         turns_of_rate, BY_NUMBER(1e-9, 1e-7, 1.2e-9));
        }
    }
}

/* What lies beyond a conversion's range counts as its nearest end. */
static void conversions_clamp(void **state)
{
    (void)state;
    const double last = 0.5 - 1e-7;
    assert_true(signed_turns(twd_phase_from_turns(TWD_NUM(0.5))) > last);
    assert_true(signed_turns(twd_phase_from_turns(twd_num_from_double(1e30))) > last);
    assert_true(signed_turns(twd_phase_from_turns(TWD_NUM(-7))) < -last);
    assert_true(signed_turns(twd_phase_from_angle(TWD_NUM(PI))) > last);
    assert_true(signed_turns(twd_phase_from_angle(TWD_NUM(-PI))) < -last);
    assert_true(signed_turns(twd_phase_from_angle(TWD_NUM(4))) > last);
    assert_true(signed_turns(twd_phase_from_frequency(TWD_NUM(7), TWD_SMALL(0.1))) > last);
    assert_true(signed_turns(twd_phase_from_frequency(TWD_NUM(-7), TWD_SMALL(0.1))) < -last);
    assert_int_equal(twd_phase_from_fraction(TWD_NUM(-1)), 0);
    assert_int_equal(twd_phase_from_fraction(TWD_NUM(2)), 0);
}

/* Of an angle within half a turn, against libm; beyond, as at half a turn. */
static void sine_and_cosine_of_an_angle_keep_their_bound(void **state)
{
    (void)state;
    double worst = 0.0;
    const int32_t steps = CASES(400000);
    for (int32_t step = -steps; step <= steps; step++) {
        const twd_num angle = twd_num_from_double(4.0 * (double)step / (double)steps);
        const double within = fmax(-PI, fmin(PI, twd_num_to_double(angle)));
        twd_num sine, cosine;
        twd_sine_cosine_of_angle(angle, &sine, &cosine);
        worst = max(worst, fabs(twd_num_to_double(sine) - sin(within)));
        worst = max(worst, fabs(twd_num_to_double(cosine) - cos(within)));
    }
    print_message("sine and cosine of an angle: error at most %.2g\n", worst);
    assert_bound(worst, BY_NUMBER(1e-8, 3e-7, 4e-6));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sine_and_cosine_keep_their_bound),
        cmocka_unit_test(sine_is_odd_and_symmetric),
        cmocka_unit_test(sine_and_cosine_change_places_at_a_quarter_turn),
        cmocka_unit_test(conversions_are_exact_in_binary_fractions),
        cmocka_unit_test(advances_are_turns_of_a_tick),
        cmocka_unit_test(conversions_clamp),
        cmocka_unit_test(sine_and_cosine_of_an_angle_keep_their_bound),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
