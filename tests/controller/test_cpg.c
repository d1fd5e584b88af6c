#include "controller_test.h"
#include "ring_topology.h"

#include <twiddle/cpg.h>

#define TICK_S TWD_SMALL(0.01)
#define RATE_PER_S TWD_RATE(20)
#define SETTLED_TICKS 20000 /* 200 s */

/* How near the filters come to their targets. Fixed: within 1 / (1 - exp(-k)) = 10.5 steps of each of two parts of the
 * state, since k = 20 /s x 0.01 s / 2. */
#define SETTLED BY_NUMBER(1e-12, 1e-6, 21 * NUM_STEP)

static const struct twd_topology *const trees[] = {&twd_cpg_c, &twd_cpg_m, &twd_cpg_s};

static struct twd_cpg_config config_of(bool with_centre)
{
    const struct twd_cpg_config config = {
        .with_centre = with_centre,
        .tick_s = TICK_S,
        .amplitude_rate_per_s = RATE_PER_S,
        .centre_rate_per_s = RATE_PER_S,
    };
    return config;
}

static struct twd_cpg make_as(const struct twd_topology *topology, struct twd_cpg_config config)
{
    struct twd_cpg cpg;
    assert_int_equal(twd_cpg_init(&cpg, topology, &config), TWD_OK);
    return cpg;
}

static struct twd_cpg make(const struct twd_topology *topology, bool with_centre)
{
    return make_as(topology, config_of(with_centre));
}

static struct twd_cpg_drive random_drive(uint64_t *random, double amplitude_lower)
{
    struct twd_cpg_drive drive;
    memset(&drive, 0, sizeof drive);
    drive.frequency_hz = twd_num_from_double(uniform(random, 0.3, 1.2));
    for (int i = 0; i < TWD_MAX_OSCILLATORS; i++) {
        drive.amplitude[i] = twd_num_from_double(uniform(random, amplitude_lower, 0.5));
        drive.centre[i] = twd_num_from_double(uniform(random, 0.0, 1.0));
    }
    for (int k = 0; k < TWD_MAX_COUPLINGS; k++)
        drive.phase_lag[k] = uniform_phase(random);
    return drive;
}

static void assert_lags(const struct twd_cpg *cpg, const struct twd_cpg_drive *drive, double tolerance_turns)
{
    const struct twd_topology *const topology = cpg->topology[0];
    for (int k = 0; k < topology->couplings; k++) {
        const struct twd_coupling coupling = topology->coupling[k];
        const twd_phase lead = cpg->oscillator[coupling.second].phase - cpg->oscillator[coupling.first].phase;
        const double error = signed_turns(lead - drive->phase_lag[k]);
        if (!(fabs(error) <= tolerance_turns)) {
            print_error("%s, coupling %d: lag is off by %g turns\n", topology->name, k, error);
            fail();
        }
    }
}

/* The couplings, and the oscillators of FEI, AAI, FET, OT, counted from 1 as the paper does. */
static void assert_wiring(const struct twd_topology *topology, uint8_t couplings, const uint8_t pairs[][2],
                          const uint8_t joint_oscillator[4])
{
    assert_int_equal(topology->couplings, couplings);
    for (int k = 0; k < couplings; k++) {
        assert_int_equal(topology->coupling[k].first + 1, pairs[k][0]);
        assert_int_equal(topology->coupling[k].second + 1, pairs[k][1]);
    }
    assert_int_equal(topology->joints, 4);
    for (int j = 0; j < 4; j++)
        assert_int_equal(topology->joint_oscillator[j] + 1, joint_oscillator[j]);
}

/* The paper's networks (its Fig. 3); CPG-C alone chooses nu. */
static void networks_are_wired_as_in_the_paper(void **state)
{
    (void)state;
    static const uint8_t pairs_of_c[][2] = {{1, 2}, {1, 3}, {3, 4}}, pairs_of_m[][2] = {{1, 2}};
    static const uint8_t joints_of_c[] = {1, 2, 3, 4}, joints_of_m[] = {1, 2, 1, 2}, joints_of_s[] = {1, 1, 1, 1};
    assert_wiring(&twd_cpg_c, 3, pairs_of_c, joints_of_c);
    assert_wiring(&twd_cpg_m, 1, pairs_of_m, joints_of_m);
    assert_wiring(&twd_cpg_s, 0, NULL, joints_of_s);
    assert_string_equal(twd_cpg_c.name, "cpg-c");
    assert_string_equal(twd_cpg_m.name, "cpg-m");
    assert_string_equal(twd_cpg_s.name, "cpg-s");
    assert_true(twd_cpg_c.chooses_frequency && !twd_cpg_m.chooses_frequency && !twd_cpg_s.chooses_frequency);
}

/* From random phases, trees of couplings reach the closed-form limit cycle: r = R, c = C, every lag = phi. */
static void trees_reach_their_limit_cycle(void **state)
{
    (void)state;
    uint64_t random = 42;
    print_message("seed 42\n");
    for (int32_t repeat = 0; repeat < CASES(30); repeat++) {
        struct twd_cpg cpg = make(trees[repeat % 3], true);
        const struct twd_cpg_drive drive = random_drive(&random, 0.2);
        twd_phase phase[TWD_MAX_OSCILLATORS];
        for (int i = 0; i < TWD_MAX_OSCILLATORS; i++)
            phase[i] = uniform_phase(&random);
        twd_cpg_start(&cpg, &drive, phase);
        for (int tick = 0; tick < SETTLED_TICKS; tick++)
            twd_cpg_tick(&cpg);

        for (uint8_t i = 0; i < cpg.oscillators; i++) {
            assert_num_close(cpg.oscillator[i].amplitude.value, twd_num_to_double(drive.amplitude[i]), SETTLED);
            assert_num_close(cpg.oscillator[i].centre.value, twd_num_to_double(drive.centre[i]), SETTLED);
        }
        assert_lags(&cpg, &drive, 1e-6);
    }
}

/* Started at their lags, trees feel no pull: all phases advance alike, to the last of the 2^32 parts of a turn. */
static void trees_started_at_lag_stay_there(void **state)
{
    (void)state;
    uint64_t random = 7;
    print_message("seed 7\n");
    for (int32_t repeat = 0; repeat < CASES(30); repeat++) {
        struct twd_cpg cpg = make(trees[repeat % 3], true);
        const struct twd_cpg_drive drive = random_drive(&random, 0.0);
        twd_phase phase[TWD_MAX_OSCILLATORS];
        twd_cpg_phases_at_lag(cpg.topology[0], drive.phase_lag, phase);
        assert_int_equal(phase[0], 0);
        twd_cpg_start(&cpg, &drive, phase);
        assert_lags(&cpg, &drive, 0.0);
        for (int tick = 0; tick < 300; tick++)
            twd_cpg_tick(&cpg);
        assert_lags(&cpg, &drive, 0.0);
        const double turns = 300 * 0.01 * twd_num_to_double(drive.frequency_hz);
        const twd_phase expected = (twd_phase)(fmod(turns, 1.0) * 4294967296.0);
        assert_close(signed_turns(cpg.oscillator[0].phase - expected), 0.0, 1e-6);
    }
}

/* Couplings listed against their direction, and oscillators without any, are placed as cpg.h says; the phases are
 * worked out by hand. */
static void phases_at_lag_serve_any_table(void **state)
{
    (void)state;
    static const struct twd_coupling coupling[] = {{2, 1}, {2, 0}, {4, 3}};
    static const uint8_t joint_oscillator[] = {0};
    static const twd_num centre[6] = {TWD_NUM(0)};
    static const struct twd_topology topology = {"islands", 6, 3, 1, false, coupling, joint_oscillator, centre};
    static const twd_phase lag[] = {1000, 300, 50};
    static const twd_phase expected[] = {0, 700, (twd_phase)-300, 0, (twd_phase)-50, 0};
    twd_phase phase[6];
    twd_cpg_phases_at_lag(&topology, lag, phase);
    for (int i = 0; i < 6; i++)
        assert_int_equal(phase[i], expected[i]);
}

/* x = c + r cos(theta) and x = r (1 + cos(theta)), against libm on the running network's own state. */
static void outputs_follow_both_equations(void **state)
{
    (void)state;
    uint64_t random = 3;
    const struct twd_cpg_drive drive = random_drive(&random, 0.1);
    const double tolerance = 0.5 * SINE_BOUND + BY_NUMBER(5e-9, 2e-7, WIDE_STEP); /* R is at most 0.5 */
    static const twd_phase phase[TWD_MAX_OSCILLATORS] = {0, TWD_QUARTER_TURN, TWD_HALF_TURN, 3 * TWD_QUARTER_TURN};
    struct twd_cpg with_centre = make(&twd_cpg_c, true);
    struct twd_cpg without_centre = make(&twd_cpg_c, false);
    twd_cpg_start(&with_centre, &drive, phase);
    twd_cpg_start(&without_centre, &drive, phase);

    for (int tick = 0; tick < 300; tick++) {
        twd_cpg_tick(&with_centre);
        twd_cpg_tick(&without_centre);
        for (uint8_t i = 0; i < 4; i++) {
            const double cos_a = cos(2.0 * PI * signed_turns(with_centre.oscillator[i].phase));
            const double cos_b = cos(2.0 * PI * signed_turns(without_centre.oscillator[i].phase));
            const double amplitude_a = twd_num_to_double(with_centre.oscillator[i].amplitude.value);
            const double amplitude_b = twd_num_to_double(without_centre.oscillator[i].amplitude.value);
            const double centre = twd_num_to_double(with_centre.oscillator[i].centre.value);
            assert_num_close(twd_cpg_output(&with_centre, i), centre + amplitude_a * cos_a, tolerance);
            assert_num_close(twd_cpg_output(&without_centre, i), amplitude_b * (1.0 + cos_b), tolerance);
        }
    }
}

/* A ring with lags of 1/6 turn, disturbed by up to 1/10 turn an oscillator, settles to the travelling wave: each phase
 * 1/6 turn ahead of the last, which is the closed-form equilibrium. */
static void ring_settles_to_a_travelling_wave(void **state)
{
    (void)state;
    uint64_t random = 11;
    print_message("seed 11\n");
    for (int32_t repeat = CASES(10); repeat > 0; repeat--) {
        struct twd_cpg cpg = make(&ring, true);
        struct twd_cpg_drive drive = random_drive(&random, 0.2);
        for (int k = 0; k < RING_OSCILLATORS; k++)
            drive.phase_lag[k] = UINT32_C(715827883);
        twd_phase phase[TWD_MAX_OSCILLATORS];
        twd_cpg_phases_at_lag(&ring, drive.phase_lag, phase);
        for (int i = 0; i < RING_OSCILLATORS; i++)
            phase[i] += (twd_phase)(int32_t)(uniform(&random, -0.1, 0.1) * 4294967296.0);
        twd_cpg_start(&cpg, &drive, phase);
        for (int tick = 0; tick < SETTLED_TICKS; tick++)
            twd_cpg_tick(&cpg);
        assert_lags(&cpg, &drive, 1e-6);
    }
}

/* With phi_ji = +phi_ij, two oscillators of equal amplitude R = 0.5 do not settle at phi: their difference d obeys d' =
 * -2 R sin(d) cos(phi), whose stable end is 0 where cos(phi) > 0 and half a turn where it is below. Both then advance
 * at nu - R sin(phi) / 2 pi, or nu + it: the closed forms, at the settled end of 200 s. */
static void equal_return_lag_settles_in_or_against_phase(void **state)
{
    (void)state;
    static const double phi_turns[] = {0.1, 0.2, 0.35, 0.45, 0.6, 0.9};
    struct twd_cpg_config config = config_of(true);
    config.return_lag = TWD_RETURN_LAG_EQUAL;
    for (size_t k = 0; k < sizeof phi_turns / sizeof *phi_turns; k++) {
        struct twd_cpg cpg = make_as(&twd_cpg_m, config);
        const double phi = 2.0 * PI * phi_turns[k];
        const struct twd_cpg_drive drive = {.frequency_hz = TWD_NUM(1),
                                            .amplitude = {TWD_NUM(0.5), TWD_NUM(0.5)},
                                            .phase_lag = {twd_phase_from_fraction(twd_num_from_double(phi_turns[k]))}};
        static const twd_phase phase[TWD_MAX_OSCILLATORS] = {0, TWD_QUARTER_TURN};
        twd_cpg_start(&cpg, &drive, phase);
        for (int tick = 0; tick < SETTLED_TICKS; tick++)
            twd_cpg_tick(&cpg);
        const double difference = signed_turns(cpg.oscillator[1].phase - cpg.oscillator[0].phase);
        assert_close(fabs(difference), cos(phi) > 0.0 ? 0.0 : 0.5, 1e-5);

        const twd_phase before = cpg.oscillator[0].phase;
        twd_cpg_tick(&cpg);
        const double frequency_hz = 1.0 - (cos(phi) > 0.0 ? 0.5 : -0.5) * sin(phi) / (2.0 * PI);
        assert_close(signed_turns(cpg.oscillator[0].phase - before) / 0.01, frequency_hz, 1e-5);
    }
}

/* c at t = 0 is the topology's, 0, or the target, as the setting says; from its target a centre does not move. */
static void centres_start_as_the_setting_says(void **state)
{
    (void)state;
    static const twd_phase phase[TWD_MAX_OSCILLATORS] = {0};
    static const double target[4] = {0.25, 0.75, 0.125, 1.0};
    static const double at_topology[4] = {0.0, 0.5, 0.0, 0.0}, at_zero[4] = {0.0, 0.0, 0.0, 0.0};
    static const double *const expected[] = {at_topology, at_zero, target};
    for (int start = TWD_CENTRE_START_AT_TOPOLOGY; start <= TWD_CENTRE_START_AT_TARGET; start++) {
        struct twd_cpg_config config = config_of(true);
        config.centre_start = (enum twd_centre_start)start;
        struct twd_cpg cpg = make_as(&twd_cpg_c, config);
        struct twd_cpg_drive drive = {.frequency_hz = TWD_NUM(1)};
        for (int i = 0; i < 4; i++)
            drive.centre[i] = twd_num_from_double(target[i]);
        twd_cpg_start(&cpg, &drive, phase);
        for (uint8_t i = 0; i < 4; i++)
            assert_num_close(cpg.oscillator[i].centre.value, expected[start][i], 0.0);
        twd_cpg_tick(&cpg);
        for (uint8_t i = 0; start == TWD_CENTRE_START_AT_TARGET && i < 4; i++)
            assert_num_close(cpg.oscillator[i].centre.value, target[i], 0.0);
    }
}

/* Several networks in one array do what each does alone, bit for bit. */
static void networks_side_by_side_do_not_know_each_other(void **state)
{
    (void)state;
    uint64_t random = 11;
    print_message("seed 11\n");
    static const struct twd_topology *const topology[] = {&twd_cpg_c, &twd_cpg_m, &twd_cpg_s};
    struct twd_cpg together;
    struct twd_cpg alone[3];
    struct twd_cpg_drive drive[3];
    twd_phase phase[TWD_MAX_OSCILLATORS];
    const struct twd_cpg_config config = make(&twd_cpg_c, true).config;

    assert_int_equal(twd_cpg_init_several(&together, topology, 3, &config), TWD_OK);
    for (int i = 0; i < TWD_MAX_OSCILLATORS; i++)
        phase[i] = uniform_phase(&random);
    const twd_phase *next = phase;
    for (int n = 0; n < 3; n++) {
        drive[n] = random_drive(&random, 0.0);
        drive[n].frequency_hz = drive[0].frequency_hz;
        assert_int_equal(twd_cpg_init(&alone[n], topology[n], &config), TWD_OK);
        twd_cpg_start(&alone[n], &drive[n], next);
        next += topology[n]->oscillators;
    }
    twd_cpg_start(&together, drive, phase);

    for (int tick = 0; tick < 300; tick++) {
        twd_cpg_tick(&together);
        uint8_t index = 0;
        for (int n = 0; n < 3; n++) {
            twd_cpg_tick(&alone[n]);
            for (uint8_t i = 0; i < topology[n]->oscillators; i++)
                assert_true(twd_cpg_output(&together, index++) == twd_cpg_output(&alone[n], i));
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(networks_are_wired_as_in_the_paper),
        cmocka_unit_test(trees_reach_their_limit_cycle),
        cmocka_unit_test(trees_started_at_lag_stay_there),
        cmocka_unit_test(phases_at_lag_serve_any_table),
        cmocka_unit_test(outputs_follow_both_equations),
        cmocka_unit_test(ring_settles_to_a_travelling_wave),
        cmocka_unit_test(equal_return_lag_settles_in_or_against_phase),
        cmocka_unit_test(centres_start_as_the_setting_says),
        cmocka_unit_test(networks_side_by_side_do_not_know_each_other),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
