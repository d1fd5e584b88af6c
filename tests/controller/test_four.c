/* What a host computes four at a time (detail/four.h) against the same one by one, to the last bit. Joints: against a
 * hand with its joints in an order for which nothing of the kind exists. Oscillators: against the functions of one. */
#include "controller_fixture.h"

#include <twiddle/icub_right_hand.h>

/* Static, since each takes 3 KiB. */
static struct twd_controller side_by_side, one_by_one;

/* Where one_by_one has the joints of side_by_side: its fingers are then of joints 0 and 2, 1 and 3. */
static const uint8_t place[4] = {0, 2, 1, 3};

/* Two fingers: joints 1 and 0, and joints 3 and 2, each as `at` says. */
static struct twd_controller_config hand(const uint8_t at[4])
{
    static const twd_num held_rad[2] = {TWD_NUM(0.3), TWD_NUM(0.4)};
    static const twd_num direction[3] = {TWD_NUM(-0.96), TWD_NUM(0), TWD_NUM(0.28)};
    static const double stiffness[4] = {0.3, 0.5, 0.4, 0.6}, limit_nm[4] = {0.5, 0.7, 0.6, 0.8};
    struct twd_controller_config config = config_of(&twd_model_h, true);
    for (int j = 0; j < 4; j++) {
        struct twd_pd *const pd = &config.joint[at[j]].pd;
        pd->stiffness_nm_per_rad = twd_num_from_double(stiffness[j]);
        pd->damping_nms_per_rad = twd_num_from_double(0.01 * stiffness[3 - j]);
        pd->torque_limit_nm = twd_num_from_double(limit_nm[j]);
    }
    config.fingers = 2;
    for (int f = 0; f < 2; f++) {
        struct twd_finger *const finger = &config.finger[f];
        const struct twd_chain *const chain = f == 0 ? &twd_icub_index : &twd_icub_thumb;
        finger->joint[0] = at[2 * f + 1];
        finger->joint[1] = at[2 * f];
        assert_int_equal(twd_gravity_init(&finger->gravity, chain, 2, held_rad, TWD_WIDE(9.81), direction), TWD_OK);
    }
    return config;
}

static void make_both(void)
{
    static const uint8_t as_numbered[4] = {0, 1, 2, 3};
    struct twd_controller_config config = hand(as_numbered);
    assert_int_equal(twd_controller_init(&side_by_side, &config), TWD_OK);
    config = hand(place);
    assert_int_equal(twd_controller_init(&one_by_one, &config), TWD_OK);
#if TWD_FOUR_AT_ONCE
    assert_true(side_by_side.four.fit);
    assert_false(one_by_one.four.fit);
#endif
}

/* Both hands get the same torques from the same input, to the last bit, and count the same. */
static void assert_same_torques(const twd_num *desired, const twd_num *angle, const twd_rate *velocity)
{
    twd_num placed_desired[4], placed_angle[4], torque[4], placed_torque[4];
    twd_rate placed_velocity[4];
    for (int j = 0; j < 4; j++) {
        placed_desired[place[j]] = desired[j];
        placed_angle[place[j]] = angle[j];
        placed_velocity[place[j]] = velocity[j];
    }
    twd_controller_torque(&side_by_side, desired, angle, velocity, torque);
    twd_controller_torque(&one_by_one, placed_desired, placed_angle, placed_velocity, placed_torque);
    for (int j = 0; j < 4; j++)
        assert_true(torque[j] == placed_torque[place[j]]);
    assert_memory_equal(&side_by_side.saturations, &one_by_one.saturations, sizeof side_by_side.saturations);
}

/* Random angles within half a turn and beyond, velocities and desired angles, which take some torques to their
 * limits. */
static void torques_are_those_of_joints_one_by_one(void **state)
{
    (void)state;
    uint64_t random = 31;
    print_message("seed 31\n");
    make_both();
    for (int32_t repeat = CASES(20000); repeat > 0; repeat--) {
        const double reach_rad = repeat % 4 == 0 ? 4.0 : 1.5;
        twd_num desired[4], angle[4];
        twd_rate velocity[4];
        for (int j = 0; j < 4; j++) {
            desired[j] = twd_num_from_double(uniform(&random, -1.5, 1.5));
            angle[j] = twd_num_from_double(uniform(&random, -reach_rad, reach_rad));
            velocity[j] = twd_rate_from_double(uniform(&random, -30.0, 30.0));
        }
        assert_same_torques(desired, angle, velocity);
    }
    assert_true(side_by_side.saturations.torque > 0);
    assert_int_equal(side_by_side.saturations.input, 0);
}

/* Input that is no number, or of no sensible size, in any place. */
static void unusable_input_is_counted_alike(void **state)
{
    (void)state;
    static const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY, 1e30, -1e30, 2e6, -2e6};
    make_both();
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        for (size_t where = 0; where < 12; where++) {
            twd_num desired[4] = {TWD_NUM(0.1), TWD_NUM(0.2), TWD_NUM(0.3), TWD_NUM(0.4)};
            twd_num angle[4] = {TWD_NUM(0.2), TWD_NUM(0.1), TWD_NUM(0.5), TWD_NUM(0.6)};
            twd_rate velocity[4] = {TWD_RATE(1), TWD_RATE(-1), TWD_RATE(2), TWD_RATE(-3)};
            if (where < 4) desired[where % 4] = twd_num_from_double(bad[k]);
            if (where >= 4 && where < 8) angle[where % 4] = twd_num_from_double(bad[k]);
            if (where >= 8) velocity[where % 4] = twd_rate_from_double(bad[k]);
            assert_same_torques(desired, angle, velocity);
            assert_int_equal(side_by_side.saturations.input, 12 * k + where + 1);
        }
    }
}

/* Start both hands at random parameters, whose centres take the outputs of some trials out of range. */
static void start_both(uint64_t *random)
{
    twd_num parameter[22];
    for (int k = 0; k < 22; k++)
        parameter[k] = twd_num_from_double(uniform(random, 0.0, 1.0));
    assert_int_equal(twd_controller_start(&side_by_side, parameter, 22), TWD_OK);
    assert_int_equal(twd_controller_start(&one_by_one, parameter, 22), TWD_OK);
}

/* A tick of the controller's networks, with the functions of one oscillator. */
static void tick_one_by_one(struct twd_cpg *cpg)
{
    size_t first_oscillator = 0, first_coupling = 0;
    for (size_t n = 0; n < cpg->networks; first_oscillator += cpg->topology[n++]->oscillators) {
        for (size_t k = 0; k < cpg->topology[n]->couplings; k++) {
            const struct twd_coupling coupling = cpg->topology[n]->coupling[k];
            struct twd_oscillator *const first = &cpg->oscillator[first_oscillator + coupling.first];
            struct twd_oscillator *const second = &cpg->oscillator[first_oscillator + coupling.second];
            const twd_phase lag_and_quarter = cpg->coupling[first_coupling++].lag_and_quarter;
            const twd_num sine = twd_cos(second->phase - first->phase - lag_and_quarter);
            first->pull += twd_wide_product(second->amplitude.value, sine);
            second->pull -= twd_wide_product(first->amplitude.value, sine);
        }
    }
    for (size_t i = 0; i < cpg->oscillators; i++) {
        struct twd_oscillator *const oscillator = &cpg->oscillator[i];
        oscillator->phase +=
            cpg->intrinsic_advance + twd_phase_from_rates(oscillator->pull, oscillator->last_pull, cpg->turn_gain);
        oscillator->last_pull = oscillator->pull;
        oscillator->pull = TWD_WIDE(0);
        twd_filter_advance(&oscillator->amplitude, &cpg->amplitude_step, oscillator->amplitude_target);
        twd_filter_advance(&oscillator->centre, &cpg->centre_step, oscillator->centre_target);
        oscillator->output =
            twd_oscillator_output_with_centre(oscillator->centre.value, oscillator->amplitude.value, oscillator->phase);
    }
}

/* Desired angles and their saturations do not depend on how the joints are grouped into fingers; oscillators are where
 * one by one would have taken them. Phases start at 0, so that the couplings pull. */
static void ticks_are_those_of_oscillators_one_by_one(void **state)
{
    (void)state;
    static struct twd_cpg cpg;
    uint64_t random = 32;
    print_message("seed 32\n");
    make_both();
    side_by_side.config.phase_start = one_by_one.config.phase_start = TWD_PHASE_START_AT_ZERO;
    for (int32_t trial = CASES(40); trial > 0; trial--) {
        start_both(&random);
        cpg = side_by_side.cpg;
        for (int tick = 0; tick < 300; tick++) {
            twd_num desired[4], expected[4];
            twd_controller_tick(&side_by_side, desired);
            twd_controller_tick(&one_by_one, expected);
            tick_one_by_one(&cpg);
            for (int j = 0; j < 4; j++)
                assert_true(desired[j] == expected[j]);
            for (size_t i = 0; i < cpg.oscillators; i++) {
                const struct twd_oscillator *const found = &side_by_side.cpg.oscillator[i];
                assert_int_equal(found->phase, cpg.oscillator[i].phase);
                assert_true(found->amplitude.value == cpg.oscillator[i].amplitude.value);
                assert_true(found->centre.value == cpg.oscillator[i].centre.value);
                assert_true(found->last_pull == cpg.oscillator[i].last_pull);
                assert_true(found->output == cpg.oscillator[i].output);
            }
        }
    }
    assert_true(side_by_side.saturations.output > 0);
    assert_int_equal(side_by_side.saturations.output, one_by_one.saturations.output);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(torques_are_those_of_joints_one_by_one),
        cmocka_unit_test(unusable_input_is_counted_alike),
        cmocka_unit_test(ticks_are_those_of_oscillators_one_by_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
