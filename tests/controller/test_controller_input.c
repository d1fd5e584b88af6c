/* What a controller refuses to be made of or to start with, and what it does with input that makes no sense. */
#include "controller_fixture.h"

/* Static, since they take 3 and 1.5 KiB. */
static struct twd_controller controller;
static struct twd_controller_config good, changed;

/* An angle, velocity or desired angle that is no number, or absurdly large (fixed: at an end of its range), gives that
 * joint zero torque and is counted; the others get what they would get otherwise, and a finger's gravity takes the lost
 * angle as 0. */
static void input_that_is_no_number_never_reaches_the_torques(void **state)
{
    (void)state;
    static const struct twd_chain_joint joint[2] = {{.rotation = {{TWD_NUM(1), TWD_NUM(0), TWD_NUM(0)},
                                                                  {TWD_NUM(0), TWD_NUM(1), TWD_NUM(0)},
                                                                  {TWD_NUM(0), TWD_NUM(0), TWD_NUM(1)}}},
                                                    PENDULUM};
    static const twd_num down[3] = {TWD_NUM(0), TWD_NUM(-1), TWD_NUM(0)};
    static const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY, 1e30, -1e30, 2e6, -2e6};
    const struct twd_chain chain = {2, joint};
    good = config_of(&twd_model_s, true);
    good.fingers = 1;
    assert_int_equal(twd_gravity_init(&good.finger[0].gravity, &chain, 2, NULL, TWD_WIDE(9.81), down), TWD_OK);
    good.finger[0].joint[0] = 0;
    good.finger[0].joint[1] = 1;
    assert_int_equal(twd_controller_init(&controller, &good), TWD_OK);

    uint32_t counted = 0;
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        for (int which = 0; which < 3; which++) {
            twd_num desired[4] = {TWD_NUM(0)}, torque[4];
            twd_num angle[4] = {TWD_NUM(0.5), TWD_NUM(0.1), TWD_NUM(0), TWD_NUM(0)};
            twd_rate velocity[4] = {TWD_RATE(0)};
            if (which == 0) desired[0] = twd_num_from_double(bad[k]);
            if (which == 1) angle[0] = twd_num_from_double(bad[k]);
            if (which == 2) velocity[0] = twd_rate_from_double(bad[k]);
            twd_controller_torque(&controller, desired, angle, velocity, torque);
            const double finger_angle = which == 1 ? 0.1 : 0.6;
            assert_true(torque[0] == TWD_NUM(0));
            assert_num_close(torque[1], 0.01962 * cos(finger_angle) - 0.2 * 0.1,
                             BY_NUMBER(1e-9, 1e-7, 3 * NUM_STEP + 0.02 * SINE_BOUND));
            assert_int_equal(controller.saturations.input, ++counted);
        }
    }
    assert_int_equal(controller.saturations.torque, 0);
}

/* Whatever comes in, with gains at the ends of their range and a finger's weight near its limit, every torque is a
 * number within its limit; it is 0 where the input is unusable. */
static void torques_are_within_their_limit_whatever_comes_in(void **state)
{
    (void)state;
    static const double values[] = {0.0,
                                    1e-9,
                                    -1.0,
                                    3.2,
                                    -7.9,
                                    7.99999999,
                                    -8.0,
                                    127.0,
                                    -2e3,
                                    2047.9,
                                    9e5,
                                    -9e5,
                                    1e30,
                                    (double)NAN,
                                    (double)INFINITY,
                                    -(double)INFINITY};
    const size_t count = sizeof values / sizeof *values;
    good = config_of(&twd_model_s, true);
    for (uint8_t j = 0; j < 4; j++) {
        good.joint[j].pd.stiffness_nm_per_rad = twd_num_from_double(BY_NUMBER(1e6, 1e6, 7.99));
        good.joint[j].pd.damping_nms_per_rad = twd_num_from_double(BY_NUMBER(1e6, 1e6, 7.99));
        good.joint[j].pd.torque_limit_nm = twd_num_from_double(j == 3 ? BY_NUMBER(1e6, 1e6, 7.99) : 0.5);
        add_pendulum(&good, j);
    }
    assert_int_equal(twd_controller_init(&controller, &good), TWD_OK);
    for (size_t k = 0; k < count * count * count; k += TWD_TEST_THINNING) {
        twd_num desired[4], angle[4], torque[4];
        twd_rate velocity[4];
        for (size_t j = 0; j < 4; j++) {
            desired[j] = twd_num_from_double(values[k % count]);
            angle[j] = twd_num_from_double(values[k / count % count]);
            velocity[j] = twd_rate_from_double(values[(k / (count * count) + j) % count]);
        }
        twd_controller_torque(&controller, desired, angle, velocity, torque);
        for (size_t j = 0; j < 4; j++) {
            const twd_num limit = good.joint[j].pd.torque_limit_nm;
            const bool usable = twd_is_usable(desired[j]) && twd_is_usable(angle[j]) && twd_rate_is_usable(velocity[j]);
            assert_true(twd_within(torque[j], -limit, limit));
            assert_true(usable || torque[j] == TWD_NUM(0));
        }
    }
}

/* A bad `field` is refused with its error, and the controller stays as it was. */
#define REFUSED(field, value, error)                                                                                   \
    do {                                                                                                               \
        changed = good;                                                                                                \
        changed.field = (value);                                                                                       \
        assert_int_equal(twd_controller_init(&controller, &changed), (error));                                         \
    } while (0)

/* A model whose parts do not hold together. */
static void init_rejects_models_that_do_not_hold_together(void **state)
{
    (void)state;
    static const uint8_t narrow_joint[1] = {0};
    static const twd_num narrow_centre[1] = {TWD_NUM(0)};
    static const struct twd_topology narrow = {"narrow", 1, 0, 1, false, NULL, narrow_joint, narrow_centre};
    static const struct twd_topology tables = {"no tables", 1, 0, 4, false, NULL, NULL, narrow_centre};
    static const struct twd_model empty = {"empty", 0, {NULL}};
    static const struct twd_model crowd = {"crowd", TWD_MAX_CPGS + 1, {&twd_cpg_s}};
    static const struct twd_model uneven = {"uneven", 2, {&twd_cpg_s, &narrow}};
    static const struct twd_model hollow = {"hollow", 2, {&twd_cpg_s, NULL}};
    static const struct twd_model bare = {"bare", 1, {&tables}};
    good = config_of(&twd_model_s, true);
    mark(&controller, sizeof controller);
    REFUSED(model, NULL, TWD_ERROR_NULL);
    REFUSED(model, &hollow, TWD_ERROR_NULL);
    REFUSED(model, &bare, TWD_ERROR_NULL);
    REFUSED(model, &empty, TWD_ERROR_TOO_MANY_CPGS);
    REFUSED(model, &crowd, TWD_ERROR_TOO_MANY_CPGS);
    REFUSED(model, &uneven, TWD_ERROR_TOO_MANY_JOINTS);
    REFUSED(joints, 3, TWD_ERROR_TOO_MANY_JOINTS);
    REFUSED(joints, 0, TWD_ERROR_TOO_MANY_JOINTS);
    REFUSED(joints, TWD_MAX_JOINTS + 1, TWD_ERROR_TOO_MANY_JOINTS);
    REFUSED(fingers, TWD_MAX_CHAINS + 1, TWD_ERROR_CHAIN);
    REFUSED(fingers, 1, TWD_ERROR_CHAIN); /* a finger that twd_gravity_init has not prepared */
    changed = good;
    add_pendulum(&changed, 4); /* of a joint that is not there */
    assert_int_equal(twd_controller_init(&controller, &changed), TWD_ERROR_CHAIN);
    assert_marked(&controller, sizeof controller);
}

/* Numbers outside the ranges of their fields. */
static void init_rejects_numbers_out_of_range(void **state)
{
    (void)state;
    good = config_of(&twd_model_s, true);
    mark(&controller, sizeof controller);
    REFUSED(oscillators.tick_s, TWD_SMALL(0), TWD_ERROR_TICK);
    REFUSED(oscillators.amplitude_rate_per_s, TWD_RATE(0), TWD_ERROR_RANGE);
    REFUSED(oscillators.return_lag, (enum twd_return_lag)2, TWD_ERROR_RANGE);
    REFUSED(oscillators.centre_start, (enum twd_centre_start)3, TWD_ERROR_RANGE);
    REFUSED(phase_start, (enum twd_phase_start)2, TWD_ERROR_RANGE);
    REFUSED(saturation, (enum twd_saturation)2, TWD_ERROR_RANGE);
    REFUSED(ranges.frequency_lower_hz, TWD_NUM(0), TWD_ERROR_RANGE);
    REFUSED(ranges.frequency_upper_hz, TWD_NUM(0.4), TWD_ERROR_RANGE);
    REFUSED(ranges.frequency_upper_hz, TWD_NUM(5.1), TWD_ERROR_RANGE);
    REFUSED(ranges.amplitude_upper, TWD_NUM(0.6), TWD_ERROR_RANGE);
    REFUSED(ranges.centre_lower, TWD_NUM(-0.1), TWD_ERROR_RANGE);
    REFUSED(ranges.centre_upper, TWD_NUM(1.1), TWD_ERROR_RANGE);
    REFUSED(joint[1].range.lower_rad, TWD_NUM(-3.2), TWD_ERROR_RANGE);
    REFUSED(joint[1].range.upper_rad, TWD_NUM(-0.25), TWD_ERROR_RANGE);
    REFUSED(joint[3].pd.stiffness_nm_per_rad, TWD_NUM(0), TWD_ERROR_RANGE);
    REFUSED(joint[3].pd.damping_nms_per_rad, TWD_NUM(-0.1), TWD_ERROR_RANGE);
    REFUSED(joint[3].pd.torque_limit_nm, TWD_NUM(0), TWD_ERROR_RANGE);
    assert_marked(&controller, sizeof controller);
}

/* Numbers that are none, or as large as none should be, in any field. */
static void init_rejects_what_is_no_number(void **state)
{
    (void)state;
    static const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY, 1e30, -1e30};
    good = config_of(&twd_model_s, true);
    mark(&controller, sizeof controller);
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        const twd_num num = twd_num_from_double(bad[k]);
        const twd_rate rate = twd_rate_from_double(bad[k]);
        REFUSED(oscillators.tick_s, twd_small_from_double(bad[k]), TWD_ERROR_TICK);
        REFUSED(oscillators.amplitude_rate_per_s, rate, TWD_ERROR_RANGE);
        REFUSED(oscillators.centre_rate_per_s, rate, TWD_ERROR_RANGE);
        REFUSED(ranges.frequency_lower_hz, num, TWD_ERROR_RANGE);
        REFUSED(ranges.frequency_upper_hz, num, TWD_ERROR_RANGE);
        REFUSED(ranges.lone_frequency_hz, num, TWD_ERROR_RANGE);
        REFUSED(ranges.amplitude_upper, num, TWD_ERROR_RANGE);
        REFUSED(ranges.centre_lower, num, TWD_ERROR_RANGE);
        REFUSED(ranges.centre_upper, num, TWD_ERROR_RANGE);
        REFUSED(joint[2].range.lower_rad, num, TWD_ERROR_RANGE);
        REFUSED(joint[2].range.upper_rad, num, TWD_ERROR_RANGE);
        REFUSED(joint[2].pd.stiffness_nm_per_rad, num, TWD_ERROR_RANGE);
        REFUSED(joint[2].pd.damping_nms_per_rad, num, TWD_ERROR_RANGE);
        REFUSED(joint[2].pd.torque_limit_nm, num, TWD_ERROR_RANGE);
    }
    assert_marked(&controller, sizeof controller);
}
#undef REFUSED

/* A trial cannot start with a wrong count or value; the running controller does not notice. */
static void start_rejects_bad_parameters(void **state)
{
    (void)state;
    static const double bad[] = {-0.01, 1.5, (double)NAN, (double)INFINITY, 1e30};
    good = config_of(&twd_model_s, true);
    assert_int_equal(twd_controller_init(&controller, &good), TWD_OK);
    twd_num parameter[2] = {TWD_NUM(1), TWD_NUM(0.5)}, desired[4];
    assert_int_equal(twd_controller_start(&controller, parameter, 2), TWD_OK);
    twd_controller_tick(&controller, desired);
    const uint32_t before = checksum(&controller, sizeof controller);
    assert_int_equal(twd_controller_start(&controller, parameter, 1), TWD_ERROR_PARAMETER_COUNT);
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        parameter[1] = twd_num_from_double(bad[k]);
        assert_int_equal(twd_controller_start(&controller, parameter, 2), TWD_ERROR_PARAMETER);
    }
    assert_int_equal(checksum(&controller, sizeof controller), before);
}

/* Every error has a sentence of its own, and so has a number that is no error. */
static void every_error_has_a_text(void **state)
{
    (void)state;
    for (int error = 0; error >= -14; error--) {
        assert_true(strlen(twd_error_text((enum twd_error)error)) > 5);
        for (int another = error + 1; another <= 0; another++)
            assert_string_not_equal(twd_error_text((enum twd_error)error), twd_error_text((enum twd_error)another));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(input_that_is_no_number_never_reaches_the_torques),
        cmocka_unit_test(torques_are_within_their_limit_whatever_comes_in),
        cmocka_unit_test(init_rejects_models_that_do_not_hold_together),
        cmocka_unit_test(init_rejects_numbers_out_of_range),
        cmocka_unit_test(init_rejects_what_is_no_number),
        cmocka_unit_test(start_rejects_bad_parameters),
        cmocka_unit_test(every_error_has_a_text),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
