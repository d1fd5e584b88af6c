#include "controller_test.h"

#include <twiddle/controller.h>

#define RATE_PER_S 20.0
#define TICK_S 0.01
#define ROUNDING BY_NUMBER(1e-9, 3e-6)

/* The ranges of FEI, AAI, FET, OT, rad. */
static const double lower_rad[4] = {0.0, -0.25, 0.0, 0.0};
static const double upper_rad[4] = {1.5, 0.25, 1.5, 2.25};

/* One link of 0.1 kg along x, 0.02 m to its centre of mass, turning about z. */
static const struct twd_chain_joint pendulum_joint = {
    .rotation = {{TWD_NUM(1), 0, 0}, {0, TWD_NUM(1), 0}, {0, 0, TWD_NUM(1)}},
    .mass_kg = TWD_NUM(0.1),
    .centre_of_mass_m = {TWD_NUM(0.02), 0, 0},
};

static struct twd_controller_config config_of(const struct twd_model *model, bool with_centre)
{
    struct twd_controller_config config;
    memset(&config, 0, sizeof config);
    config.model = model;
    config.oscillators.with_centre = with_centre;
    config.oscillators.tick_s = TWD_NUM(TICK_S);
    config.oscillators.amplitude_rate_per_s = TWD_NUM(RATE_PER_S);
    config.oscillators.centre_rate_per_s = TWD_NUM(RATE_PER_S);
    config.ranges.frequency_lower_hz = TWD_NUM(0.5);
    config.ranges.frequency_upper_hz = TWD_NUM(1.5);
    config.ranges.lone_frequency_hz = TWD_NUM(1);
    config.ranges.amplitude_upper = TWD_NUM(0.5);
    config.ranges.centre_upper = TWD_NUM(1);
    config.joints = 4;
    for (int j = 0; j < 4; j++) {
        config.joint[j].lower_rad = (twd_num)lower_rad[j];
        config.joint[j].upper_rad = (twd_num)upper_rad[j];
        config.joint[j].pd = (struct twd_pd){TWD_NUM(0.2), TWD_NUM(0.01), TWD_NUM(1)};
    }
    return config;
}

/* Give joint `joint` a pendulum as its finger; gravity along -y. */
static void add_pendulum(struct twd_controller_config *config, uint8_t joint)
{
    static const twd_num down[3] = {0, TWD_NUM(-1), 0};
    const struct twd_chain chain = {1, &pendulum_joint};
    struct twd_finger *const finger = &config->finger[config->fingers++];
    assert_int_equal(twd_gravity_init(&finger->gravity, &chain, 1, NULL, TWD_NUM(9.81), down), TWD_OK);
    finger->joint[0] = joint;
}

static struct twd_controller make(const struct twd_controller_config *config)
{
    struct twd_controller controller;
    assert_int_equal(twd_controller_init(&controller, config), TWD_OK);
    return controller;
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
    struct twd_controller controller = make(&config);
    static const twd_num parameter[22] = {TWD_NUM(0.5),
                                          0,
                                          0,
                                          0,
                                          0,
                                          TWD_NUM(0.1),
                                          TWD_NUM(0.9),
                                          TWD_NUM(0.3),
                                          TWD_NUM(0.7),
                                          0,
                                          0,
                                          0, /* C */
                                          0,
                                          0,
                                          TWD_NUM(0.6),
                                          TWD_NUM(0.2),
                                          0, /* M */
                                          0,
                                          TWD_NUM(0.4), /* S */
                                          TWD_NUM(0.5),
                                          TWD_NUM(0.3),
                                          TWD_NUM(0.2)}; /* selector */
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
            assert_close(desired[j], lower_rad[j] + fraction * (upper_rad[j] - lower_rad[j]), ROUNDING);
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
        struct twd_controller controller = make(&config);
        static const twd_num parameter[2] = {TWD_NUM(1), TWD_NUM(0.5)};
        assert_int_equal(twd_controller_start(&controller, parameter, centred ? 2 : 1), TWD_OK);
        for (int tick = 1; tick <= 500; tick++) {
            twd_num desired[4];
            twd_controller_tick(&controller, desired);
            if (tick < 300) continue;
            const double fraction = 0.5 + 0.5 * cos(2.0 * PI * tick * TICK_S);
            for (int j = 0; j < 4; j++)
                assert_close(desired[j], lower_rad[j] + fraction * (upper_rad[j] - lower_rad[j]),
                             BY_NUMBER(1e-6, 2e-5));
        }
    }
}

/* With C = 0.9 the top of the swing is out of range: the angle stays at the joint's end, and each tick above is counted
 * once a joint. The count comes from the closed form, tick by tick. */
static void outputs_out_of_range_are_saturated_and_counted(void **state)
{
    (void)state;
    const struct twd_controller_config config = config_of(&twd_model_s, true);
    struct twd_controller controller = make(&config);
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
            assert_close(desired[j], upper_rad[j], 0.0);
        expected += 4;
    }
    assert_true(expected > 400);
    assert_int_equal(controller.saturations.output, expected);
}

/* CPG-H with weights of 1/3: CPG-C's FEI swings by 0.5 around 0.9, beyond the range, and the others' stand at 0.3. The sum, at
 * most 2/3, is never cut; with each CPG saturated, CPG-C's part is cut at 1/3. Expected: both closed forms, tick by tick. */
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
    struct twd_controller of_sum = make(&config);
    config.saturation = TWD_SATURATE_EACH;
    struct twd_controller of_each = make(&config);
    assert_int_equal(twd_controller_start(&of_sum, parameter, 22), TWD_OK);
    assert_int_equal(twd_controller_start(&of_each, parameter, 22), TWD_OK);
    uint32_t cut = 0;
    for (int tick = 1; tick <= 300; tick++) {
        twd_num desired[4];
        const double t = tick * TICK_S;
        const double c = step_response(0.0, 0.9, t) + step_response(0.0, 0.5, t) * cos(2.0 * PI * t);
        const double others = 2.0 * step_response(0.0, 0.3, t);
        assert_true(c > 0.0 && fabs(c - 1.0) > 1e-4); /* no tick is a matter of rounding */
        cut += c > 1.0;
        twd_controller_tick(&of_sum, desired);
        assert_close(desired[0], 1.5 * (c + others) / 3.0, BY_NUMBER(1e-6, 2e-5));
        twd_controller_tick(&of_each, desired);
        assert_close(desired[0], 1.5 * (fmin(c, 1.0) + others) / 3.0, BY_NUMBER(1e-6, 2e-5));
    }
    assert_true(cut > 100);
    assert_int_equal(of_sum.saturations.output, 0);
    assert_int_equal(of_each.saturations.output, cut);
}

/* Phases start at their lags, or all at 0, as the setting says: phi12 is a quarter of a turn here. */
static void phases_start_as_the_setting_says(void **state)
{
    (void)state;
    static const twd_num parameter[5] = {TWD_NUM(1), TWD_NUM(1), TWD_NUM(0.5), TWD_NUM(0.5), TWD_NUM(0.25)};
    struct twd_controller_config config = config_of(&twd_model_m, true);
    struct twd_controller at_lag = make(&config);
    config.phase_start = TWD_PHASE_START_AT_ZERO;
    struct twd_controller at_zero = make(&config);
    assert_int_equal(twd_controller_start(&at_lag, parameter, 5), TWD_OK);
    assert_int_equal(twd_controller_start(&at_zero, parameter, 5), TWD_OK);
    assert_int_equal(at_lag.cpg[0].oscillator[0].phase, 0);
    assert_int_equal(at_lag.cpg[0].oscillator[1].phase, 1U << 30);
    assert_int_equal(at_zero.cpg[0].oscillator[1].phase, 0);
}

/* T = g + Kp (desired - actual) - Kd velocity by hand, with m g l cos(q) = 0.01962 cos(q) N m at the joint with a
 * finger. */
static void torques_are_gravity_and_pd(void **state)
{
    (void)state;
    struct twd_controller_config config = config_of(&twd_model_s, true);
    add_pendulum(&config, 2);
    struct twd_controller controller = make(&config);
    static const twd_num desired[4] = {TWD_NUM(0.5), 0, TWD_NUM(1), 0};
    static const twd_num angle[4] = {TWD_NUM(0.3), 0, TWD_NUM(0.9), 0};
    static const twd_num velocity[4] = {TWD_NUM(2), TWD_NUM(-1), 0, 0};
    twd_num torque[4];
    twd_controller_torque(&controller, desired, angle, velocity, torque);
    assert_close(torque[0], 0.2 * 0.2 - 0.01 * 2.0, BY_NUMBER(1e-9, 1e-7));
    assert_close(torque[1], 0.01, BY_NUMBER(1e-9, 1e-7));
    assert_close(torque[2], 0.01962 * cos(0.9) + 0.2 * 0.1, BY_NUMBER(1e-9, 1e-7));
    assert_close(torque[3], 0.0, 0.0);
    assert_int_equal(controller.saturations.torque, 0);
    assert_int_equal(controller.saturations.input, 0);
}

/* A torque beyond the limit of 1 N m is held to it, either way, and counted. */
static void torques_beyond_the_limit_are_saturated_and_counted(void **state)
{
    (void)state;
    const struct twd_controller_config config = config_of(&twd_model_s, true);
    struct twd_controller controller = make(&config);
    static const twd_num desired[4] = {TWD_NUM(6), TWD_NUM(-6), TWD_NUM(0.1), 0};
    static const twd_num zero[4] = {0};
    twd_num torque[4];
    twd_controller_torque(&controller, desired, zero, zero, torque);
    assert_close(torque[0], 1.0, 0.0);
    assert_close(torque[1], -1.0, 0.0);
    assert_close(torque[2], 0.02, 1e-8);
    assert_int_equal(controller.saturations.torque, 2);
}

/* An angle, velocity or desired angle that is no number, or absurdly large, gives that joint zero torque and is
 * counted; the others get what they would get otherwise, and a finger's gravity takes the lost angle as 0. */
static void input_that_is_no_number_never_reaches_the_torques(void **state)
{
    (void)state;
    static const struct twd_chain_joint joint[2] = {
        {.rotation = {{TWD_NUM(1), 0, 0}, {0, TWD_NUM(1), 0}, {0, 0, TWD_NUM(1)}}},
        {.rotation = {{TWD_NUM(1), 0, 0}, {0, TWD_NUM(1), 0}, {0, 0, TWD_NUM(1)}},
         .mass_kg = TWD_NUM(0.1),
         .centre_of_mass_m = {TWD_NUM(0.02), 0, 0}}};
    static const twd_num down[3] = {0, TWD_NUM(-1), 0};
    static const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY, 1e30};
    const struct twd_chain chain = {2, joint};
    struct twd_controller_config config = config_of(&twd_model_s, true);
    config.fingers = 1;
    assert_int_equal(twd_gravity_init(&config.finger[0].gravity, &chain, 2, NULL, TWD_NUM(9.81), down), TWD_OK);
    config.finger[0].joint[0] = 0;
    config.finger[0].joint[1] = 1;
    struct twd_controller controller = make(&config);

    uint32_t counted = 0;
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        for (int which = 0; which < 3; which++) {
            twd_num input[3][4] = {{0}, {TWD_NUM(0.5), TWD_NUM(0.1), 0, 0}, {0}}; /* desired, angle, velocity */
            input[which][0] = (twd_num)bad[k];
            twd_num torque[4];
            twd_controller_torque(&controller, input[0], input[1], input[2], torque);
            const double finger_angle = which == 1 ? 0.1 : 0.6;
            assert_true(torque[0] == TWD_NUM(0));
            assert_close(torque[1], 0.01962 * cos(finger_angle) - 0.2 * 0.1, BY_NUMBER(1e-9, 1e-7));
            assert_int_equal(controller.saturations.input, ++counted);
        }
    }
    assert_int_equal(controller.saturations.torque, 0);
}

/* Whatever does not hold together is refused with its error, and the controller stays as it was. */
static void init_rejects_what_does_not_hold_together(void **state)
{
    (void)state;
    static const uint8_t narrow_joint[1] = {0};
    static const twd_num narrow_centre[1] = {0};
    static const struct twd_topology narrow = {"narrow", 1, 0, 1, false, NULL, narrow_joint, narrow_centre};
    static const struct twd_model empty = {"empty", 0, {NULL}};
    static const struct twd_model crowd = {"crowd", TWD_MAX_CPGS + 1, {&twd_cpg_s}};
    static const struct twd_model uneven = {"uneven", 2, {&twd_cpg_s, &narrow}};
    const twd_num nan = (twd_num)NAN;
    const struct twd_controller_config good = config_of(&twd_model_s, true);
    struct twd_controller controller, before;
    memset(&controller, 0x5A, sizeof controller);
    memcpy(&before, &controller, sizeof controller);

#define REFUSED(field, value, expected)                                                                                \
    do {                                                                                                               \
        struct twd_controller_config config = good;                                                                    \
        config.field = (value);                                                                                        \
        assert_int_equal(twd_controller_init(&controller, &config), (expected));                                       \
        assert_memory_equal(&controller, &before, sizeof controller);                                                  \
    } while (0)
    REFUSED(model, &empty, TWD_ERROR_TOO_MANY_CPGS);
    REFUSED(model, &crowd, TWD_ERROR_TOO_MANY_CPGS);
    REFUSED(model, &uneven, TWD_ERROR_TOO_MANY_JOINTS);
    REFUSED(joints, 3, TWD_ERROR_TOO_MANY_JOINTS);
    REFUSED(joints, 0, TWD_ERROR_TOO_MANY_JOINTS);
    REFUSED(joints, TWD_MAX_JOINTS + 1, TWD_ERROR_TOO_MANY_JOINTS);
    REFUSED(oscillators.tick_s, 0, TWD_ERROR_TICK);
    REFUSED(oscillators.tick_s, nan, TWD_ERROR_TICK);
    REFUSED(oscillators.amplitude_rate_per_s, 0, TWD_ERROR_RANGE);
    REFUSED(oscillators.centre_rate_per_s, nan, TWD_ERROR_RANGE);
    REFUSED(oscillators.return_lag, (enum twd_return_lag)2, TWD_ERROR_RANGE);
    REFUSED(oscillators.centre_start, (enum twd_centre_start)3, TWD_ERROR_RANGE);
    REFUSED(phase_start, (enum twd_phase_start)2, TWD_ERROR_RANGE);
    REFUSED(saturation, (enum twd_saturation)2, TWD_ERROR_RANGE);
    REFUSED(ranges.frequency_lower_hz, 0, TWD_ERROR_RANGE);
    REFUSED(ranges.frequency_upper_hz, TWD_NUM(0.4), TWD_ERROR_RANGE);
    REFUSED(ranges.frequency_upper_hz, TWD_NUM(5.1), TWD_ERROR_RANGE);
    REFUSED(ranges.lone_frequency_hz, nan, TWD_ERROR_RANGE);
    REFUSED(ranges.amplitude_upper, TWD_NUM(0.6), TWD_ERROR_RANGE);
    REFUSED(ranges.centre_lower, TWD_NUM(-0.1), TWD_ERROR_RANGE);
    REFUSED(ranges.centre_upper, TWD_NUM(1.1), TWD_ERROR_RANGE);
    REFUSED(joint[1].lower_rad, TWD_NUM(-3.2), TWD_ERROR_RANGE);
    REFUSED(joint[1].upper_rad, TWD_NUM(-0.25), TWD_ERROR_RANGE);
    REFUSED(joint[3].upper_rad, (twd_num)INFINITY, TWD_ERROR_RANGE);
    REFUSED(joint[3].pd.stiffness_nm_per_rad, 0, TWD_ERROR_RANGE);
    REFUSED(joint[3].pd.stiffness_nm_per_rad, (twd_num)INFINITY, TWD_ERROR_RANGE);
    REFUSED(joint[3].pd.damping_nms_per_rad, TWD_NUM(-0.1), TWD_ERROR_RANGE);
    REFUSED(joint[3].pd.torque_limit_nm, nan, TWD_ERROR_RANGE);
    REFUSED(fingers, TWD_MAX_CHAINS + 1, TWD_ERROR_CHAIN);
    REFUSED(fingers, 1, TWD_ERROR_CHAIN); /* a finger that twd_gravity_init has not prepared */
#undef REFUSED

    struct twd_controller_config stray = good;
    add_pendulum(&stray, 4);
    assert_int_equal(twd_controller_init(&controller, &stray), TWD_ERROR_CHAIN);
    assert_memory_equal(&controller, &before, sizeof controller);
}

/* A trial cannot start with a wrong count or value; the running controller does not notice. */
static void start_rejects_bad_parameters(void **state)
{
    (void)state;
    const struct twd_controller_config config = config_of(&twd_model_s, true);
    struct twd_controller controller = make(&config);
    static const twd_num good[2] = {TWD_NUM(1), TWD_NUM(0.5)};
    const twd_num bad[2] = {TWD_NUM(1), TWD_NUM(1.5)};
    twd_num desired[4];
    assert_int_equal(twd_controller_start(&controller, good, 2), TWD_OK);
    twd_controller_tick(&controller, desired);
    struct twd_controller before;
    memcpy(&before, &controller, sizeof controller);
    assert_int_equal(twd_controller_start(&controller, good, 1), TWD_ERROR_PARAMETER_COUNT);
    assert_int_equal(twd_controller_start(&controller, bad, 2), TWD_ERROR_PARAMETER);
    assert_memory_equal(&controller, &before, sizeof controller);
}

/* Every error has a sentence of its own, and so has a number that is no error. */
static void every_error_has_a_text(void **state)
{
    (void)state;
    for (int error = 0; error >= -13; error--) {
        assert_true(strlen(twd_error_text((enum twd_error)error)) > 5);
        for (int other = error + 1; other <= 0; other++)
            assert_string_not_equal(twd_error_text((enum twd_error)error), twd_error_text((enum twd_error)other));
    }
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
        cmocka_unit_test(input_that_is_no_number_never_reaches_the_torques),
        cmocka_unit_test(init_rejects_what_does_not_hold_together),
        cmocka_unit_test(start_rejects_bad_parameters),
        cmocka_unit_test(every_error_has_a_text),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
