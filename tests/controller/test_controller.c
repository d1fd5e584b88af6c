#include "controller_fixture.h"

/* Of angles of up to 2.25 rad. */
#define ROUNDING (BY_NUMBER(1e-9, 3e-6, 1e-7) + 2.25 * FILTER_ERROR)

/* The same with sines, and with phases that lag by up to 2^-32 turn a tick. */
#define SWINGING (BY_NUMBER(1e-6, 2e-5, 5e-6) + 2.25 * FILTER_ERROR)

/* The controller of the test in hand, and a second one; static, since each takes 3 KiB. */
static struct twd_controller controller, other;

static void make(struct twd_controller *made, const struct twd_controller_config *config)
{
    assert_int_equal(twd_controller_init(made, config), TWD_OK);
}

/* A critically damped step from rest at `start` to `target` after `time_s`. */
static double step_response(double start, double target, double time_s)
{
    const double s = RATE_PER_S * time_s / 2.0;
    return target + (start - target) * exp(-s) * (1.0 + s);
}

/* CPG-H with amplitudes 0: each joint is the closed-form step of C's, M's and S's centres, weighed 0.5, 0.3, 0.2 and
 * mapped onto its range. */
static void hierarchical_controller_mixes_and_maps_its_centres(void **state)
{
    (void)state;
    const struct twd_controller_config config = config_of(&twd_model_h, true);
    make(&controller, &config);
    /* 1 Hz; C1..4 of C, at 5; C1 and C2 of M, at 14; C1 of S, at 18; the selector */
    static const double centres[22] = {0.5, 0, 0, 0,   0,   0.1, 0.9, 0.3, 0.7, 0,   0,
                                       0,   0, 0, 0.6, 0.2, 0,   0,   0.4, 0.5, 0.3, 0.2};
    twd_num parameter[22];
    for (int k = 0; k < 22; k++)
        parameter[k] = twd_num_from_double(centres[k]);
    static const double c[4] = {0.1, 0.9, 0.3, 0.7}, c_start[4] = {0.0, 0.5, 0.0, 0.0};
    static const double m[4] = {0.6, 0.2, 0.6, 0.2};
    assert_int_equal(twd_controller_start(&controller, parameter, 22), TWD_OK);

    for (int tick = 1; tick <= 100; tick++) {
        twd_num desired[4];
        twd_controller_tick(&controller, desired);
        for (int j = 0; j < 4; j++) {
            const double t = tick * TICK_S;
            const double fraction = 0.5 * step_response(c_start[j], c[j], t) + 0.3 * step_response(0.0, m[j], t) +
                                    0.2 * step_response(0.0, 0.4, t);
            assert_num_close(desired[j], lower_rad[j] + fraction * (upper_rad[j] - lower_rad[j]), ROUNDING);
        }
    }
    assert_int_equal(controller.saturations.output, 0);
}

/* CPG-S with R = 0.5 at 1 Hz: centred at 0.5 or without a centre, the output is 0.5 + 0.5 cos(2 pi t) once the filters
 * have settled; all four joints share it. The phase advances by whole parts of 2^-32 turn: in 500 ticks it may lag
 * 500 x 2^-32 turn, which is 0.9e-6 rad of the widest joint. */
static void settled_oscillator_swings_over_the_whole_range(void **state)
{
    (void)state;
    for (int centred = 0; centred <= 1; centred++) {
        const struct twd_controller_config config = config_of(&twd_model_s, centred == 1);
        make(&controller, &config);
        static const twd_num parameter[2] = {TWD_NUM(1), TWD_NUM(0.5)};
        assert_int_equal(twd_controller_start(&controller, parameter, centred ? 2 : 1), TWD_OK);
        for (int tick = 1; tick <= 500; tick++) {
            twd_num desired[4];
            twd_controller_tick(&controller, desired);
            if (tick < 300) continue;
            const double fraction = 0.5 + 0.5 * cos(2.0 * PI * tick * TICK_S);
            for (int j = 0; j < 4; j++)
                assert_num_close(desired[j], lower_rad[j] + fraction * (upper_rad[j] - lower_rad[j]), SWINGING);
        }
    }
}

/* With C = 0.9 the top of the swing is out of range: the angle stays at the joint's end, and each tick above is counted
 * once a joint. The count comes from the closed form, tick by tick. */
static void outputs_out_of_range_are_saturated_and_counted(void **state)
{
    (void)state;
    const struct twd_controller_config config = config_of(&twd_model_s, true);
    make(&controller, &config);
    static const twd_num parameter[2] = {TWD_NUM(1), TWD_NUM(0.9)};
    assert_int_equal(twd_controller_start(&controller, parameter, 2), TWD_OK);
    uint32_t expected = 0;
    for (int tick = 1; tick <= 300; tick++) {
        twd_num desired[4];
        twd_controller_tick(&controller, desired);
        const double t = tick * TICK_S;
        const double fraction = step_response(0.0, 0.9, t) + step_response(0.0, 0.5, t) * cos(2.0 * PI * t);
        assert_true(fabs(fraction - 1.0) > 1e-4); /* no tick is a matter of rounding */
        if (fraction < 1.0) continue;
        for (int j = 0; j < 4; j++)
            assert_num_close(desired[j], upper_rad[j], 0.0);
        expected += 4;
    }
    assert_true(expected > 400);
    assert_int_equal(controller.saturations.output, expected);
}

/* CPG-H with weights of 1/3: CPG-C's FEI swings by 0.5 around 0.9, beyond the range, and the others' stand at 0.3. The
 * sum, at most 2/3, is never cut; with each CPG saturated, CPG-C's part is cut at 1/3. Expected: both closed forms,
 * tick by tick. */
static void saturation_cuts_the_sum_or_each_cpg(void **state)
{
    (void)state;
    twd_num parameter[22] = {TWD_NUM(0.5)}; /* 1 Hz */
    parameter[1] = TWD_NUM(1);              /* R1 of C: 0.5 */
    parameter[5] = TWD_NUM(0.9);            /* C1 of C */
    parameter[14] = TWD_NUM(0.3);           /* C1 of M */
    parameter[18] = TWD_NUM(0.3);           /* C1 of S */
    for (int k = 19; k < 22; k++)
        parameter[k] = TWD_NUM(0.5);
    struct twd_controller_config config = config_of(&twd_model_h, true);
    make(&controller, &config); /* of the sum */
    config.saturation = TWD_SATURATE_EACH;
    make(&other, &config); /* of each */
    assert_int_equal(twd_controller_start(&controller, parameter, 22), TWD_OK);
    assert_int_equal(twd_controller_start(&other, parameter, 22), TWD_OK);
    uint32_t cut = 0;
    for (int tick = 1; tick <= 300; tick++) {
        twd_num desired[4];
        const double t = tick * TICK_S;
        const double c = step_response(0.0, 0.9, t) + step_response(0.0, 0.5, t) * cos(2.0 * PI * t);
        const double others = 2.0 * step_response(0.0, 0.3, t);
        assert_true(c > 0.0 && fabs(c - 1.0) > 1e-4); /* no tick is a matter of rounding */
        cut += c > 1.0;
        twd_controller_tick(&controller, desired);
        assert_num_close(desired[0], 1.5 * (c + others) / 3.0, SWINGING);
        twd_controller_tick(&other, desired);
        assert_num_close(desired[0], 1.5 * (fmin(c, 1.0) + others) / 3.0, SWINGING);
    }
    assert_true(cut > 100);
    assert_int_equal(controller.saturations.output, 0);
    assert_int_equal(other.saturations.output, cut);
}

/* Phases start at their lags, or all at 0, as the setting says: phi12 is a quarter of a turn here. */
static void phases_start_as_the_setting_says(void **state)
{
    (void)state;
    static const twd_num parameter[5] = {TWD_NUM(1), TWD_NUM(1), TWD_NUM(0.5), TWD_NUM(0.5), TWD_NUM(0.25)};
    struct twd_controller_config config = config_of(&twd_model_m, true);
    make(&controller, &config); /* at the lags */
    config.phase_start = TWD_PHASE_START_AT_ZERO;
    make(&other, &config); /* at 0 */
    assert_int_equal(twd_controller_start(&controller, parameter, 5), TWD_OK);
    assert_int_equal(twd_controller_start(&other, parameter, 5), TWD_OK);
    assert_int_equal(controller.cpg.oscillator[0].phase, 0);
    assert_int_equal(controller.cpg.oscillator[1].phase, TWD_QUARTER_TURN);
    assert_int_equal(other.cpg.oscillator[1].phase, 0);
}

/* T = g + Kp (desired - actual) - Kd velocity by hand, with m g l cos(q) = 0.01962 cos(q) N m at the joint with a
 * finger. Fixed: half a step of 2^-28 for each number, twice that for the damping's, and gravity's sine. */
static void torques_are_gravity_and_pd(void **state)
{
    (void)state;
    struct twd_controller_config config = config_of(&twd_model_s, true);
    add_pendulum(&config, 2);
    make(&controller, &config);
    static const twd_num desired[4] = {TWD_NUM(0.5), TWD_NUM(0), TWD_NUM(1), TWD_NUM(0)};
    static const twd_num angle[4] = {TWD_NUM(0.3), TWD_NUM(0), TWD_NUM(0.9), TWD_NUM(0)};
    static const twd_rate velocity[4] = {TWD_RATE(2), TWD_RATE(-1), TWD_RATE(0), TWD_RATE(0)};
    twd_num torque[4];
    twd_controller_torque(&controller, desired, angle, velocity, torque);
    assert_num_close(torque[0], 0.2 * 0.2 - 0.01 * 2.0, BY_NUMBER(1e-9, 1e-7, 3 * NUM_STEP));
    assert_num_close(torque[1], 0.01, BY_NUMBER(1e-9, 1e-7, NUM_STEP));
    assert_num_close(torque[2], 0.01962 * cos(0.9) + 0.2 * 0.1,
                     BY_NUMBER(1e-9, 1e-7, 3 * NUM_STEP + 0.02 * SINE_BOUND));
    assert_num_close(torque[3], 0.0, 0.0);
    assert_int_equal(controller.saturations.torque, 0);
    assert_int_equal(controller.saturations.input, 0);
}

/* A torque beyond the limit of 1 N m is held to it, either way, and counted. */
static void torques_beyond_the_limit_are_saturated_and_counted(void **state)
{
    (void)state;
    const struct twd_controller_config config = config_of(&twd_model_s, true);
    make(&controller, &config);
    static const twd_num desired[4] = {TWD_NUM(6), TWD_NUM(-6), TWD_NUM(0.1), TWD_NUM(0)};
    static const twd_num zero[4] = {TWD_NUM(0)};
    static const twd_rate at_rest[4] = {TWD_RATE(0)};
    twd_num torque[4];
    twd_controller_torque(&controller, desired, zero, at_rest, torque);
    assert_num_close(torque[0], 1.0, 0.0);
    assert_num_close(torque[1], -1.0, 0.0);
    assert_num_close(torque[2], 0.02, 1e-8);
    assert_int_equal(controller.saturations.torque, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hierarchical_controller_mixes_and_maps_its_centres),
        cmocka_unit_test(settled_oscillator_swings_over_the_whole_range),
        cmocka_unit_test(outputs_out_of_range_are_saturated_and_counted),
        cmocka_unit_test(saturation_cuts_the_sum_or_each_cpg),
        cmocka_unit_test(phases_start_as_the_setting_says),
        cmocka_unit_test(torques_are_gravity_and_pd),
        cmocka_unit_test(torques_beyond_the_limit_are_saturated_and_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
