#include "controller_test.h"

#include <twiddle/model.h>

/* Fixed: half a step of 2^-28 for each number that goes in, the weights' divided by a sum above 0.4, and for the
 * result. */
#define ROUNDING BY_NUMBER(1e-14, 1e-6, 3 * NUM_STEP)

static const struct twd_parameter_ranges ranges = {
    .frequency_lower_hz = TWD_NUM(0.3),
    .frequency_upper_hz = TWD_NUM(1.3),
    .lone_frequency_hz = TWD_NUM(0.84),
    .amplitude_upper = TWD_NUM(0.5),
    .centre_lower = TWD_NUM(0.1),
    .centre_upper = TWD_NUM(0.9),
};

/* Parameter i of a hand-written vector: (i + 1) / 100, so that each can be told from all others. */
static void number_off(twd_num *parameter, size_t count)
{
    for (size_t i = 0; i < count; i++)
        parameter[i] = twd_num_from_double((double)(i + 1) / 100.0);
}

static void assert_amplitude(const struct twd_cpg_drive *drive, int oscillator, int position)
{
    assert_num_close(drive->amplitude[oscillator], 0.5 * position / 100.0, ROUNDING);
}

static void assert_centre(const struct twd_cpg_drive *drive, int oscillator, int position)
{
    assert_num_close(drive->centre[oscillator], 0.1 + 0.8 * position / 100.0, ROUNDING);
}

static void assert_lag(const struct twd_cpg_drive *drive, int coupling, int position)
{
    /* A phase is a whole number of parts of 2^-32 turn; fixed: half a step of the parameter. */
    assert_close(signed_turns(drive->phase_lag[coupling]), position / 100.0, BY_NUMBER(2.4e-10, 1e-7, 0.5 * NUM_STEP));
}

/* The paper's counts: 2, 5, 12, 22 parameters for CPG-S, -M, -C, -H, and 1, 3, 8, 15 without centre. */
static void models_have_the_papers_parameter_counts(void **state)
{
    (void)state;
    assert_int_equal(twd_model_parameters(&twd_model_s, true), 2);
    assert_int_equal(twd_model_parameters(&twd_model_m, true), 5);
    assert_int_equal(twd_model_parameters(&twd_model_c, true), 12);
    assert_int_equal(twd_model_parameters(&twd_model_h, true), 22);
    assert_int_equal(twd_model_parameters(&twd_model_s, false), 1);
    assert_int_equal(twd_model_parameters(&twd_model_m, false), 3);
    assert_int_equal(twd_model_parameters(&twd_model_c, false), 8);
    assert_int_equal(twd_model_parameters(&twd_model_h, false), 15);
}

/* CPG-H reads C: nu, R1..4, C1..4, phi12, phi13, phi34; M: R1, R2, C1, C2, phi12; S: R1, C1; selector C, M, S:
 * positions 1 to 22, written out by hand. */
static void hierarchical_model_reads_in_order(void **state)
{
    (void)state;
    twd_num parameter[22];
    number_off(parameter, 22);
    struct twd_model_drive drive;
    assert_int_equal(twd_model_decode(&twd_model_h, true, &ranges, parameter, 22, &drive), TWD_OK);

    for (int k = 0; k < 3; k++)
        assert_num_close(drive.cpg[k].frequency_hz, 0.31, ROUNDING);
    for (int i = 0; i < 4; i++) {
        assert_amplitude(&drive.cpg[0], i, 2 + i);
        assert_centre(&drive.cpg[0], i, 6 + i);
    }
    assert_lag(&drive.cpg[0], 0, 10);
    assert_lag(&drive.cpg[0], 1, 11);
    assert_lag(&drive.cpg[0], 2, 12);
    assert_amplitude(&drive.cpg[1], 0, 13);
    assert_amplitude(&drive.cpg[1], 1, 14);
    assert_centre(&drive.cpg[1], 0, 15);
    assert_centre(&drive.cpg[1], 1, 16);
    assert_lag(&drive.cpg[1], 0, 17);
    assert_amplitude(&drive.cpg[2], 0, 18);
    assert_centre(&drive.cpg[2], 0, 19);
    assert_num_close(drive.weight[0], 20.0 / 63.0, ROUNDING);
    assert_num_close(drive.weight[1], 21.0 / 63.0, ROUNDING);
    assert_num_close(drive.weight[2], 22.0 / 63.0, ROUNDING);
}

/* Without centre the C's are left out, and all else keeps its order: positions 1 to 15. */
static void hierarchical_model_without_centre_leaves_centres_out(void **state)
{
    (void)state;
    twd_num parameter[15];
    number_off(parameter, 15);
    struct twd_model_drive drive;
    assert_int_equal(twd_model_decode(&twd_model_h, false, &ranges, parameter, 15, &drive), TWD_OK);

    for (int i = 0; i < 4; i++)
        assert_amplitude(&drive.cpg[0], i, 2 + i);
    for (int k = 0; k < 3; k++)
        assert_lag(&drive.cpg[0], k, 6 + k);
    assert_amplitude(&drive.cpg[1], 0, 9);
    assert_amplitude(&drive.cpg[1], 1, 10);
    assert_lag(&drive.cpg[1], 0, 11);
    assert_amplitude(&drive.cpg[2], 0, 12);
    assert_num_close(drive.weight[0], 13.0 / 42.0, ROUNDING);
    assert_num_close(drive.weight[2], 15.0 / 42.0, ROUNDING);
}

/* Lone CPG-M and CPG-S run at the set-up's fixed frequency, CPG-C at its own; a lone CPG's weight is 1. */
static void lone_models_take_the_fixed_frequency(void **state)
{
    (void)state;
    twd_num parameter[12];
    number_off(parameter, 12);
    struct twd_model_drive drive;
    assert_int_equal(twd_model_decode(&twd_model_m, true, &ranges, parameter, 5, &drive), TWD_OK);
    assert_num_close(drive.cpg[0].frequency_hz, 0.84, ROUNDING);
    assert_amplitude(&drive.cpg[0], 0, 1);
    assert_lag(&drive.cpg[0], 0, 5);
    assert_true(drive.weight[0] == TWD_NUM(1));
    assert_int_equal(twd_model_decode(&twd_model_s, true, &ranges, parameter, 2, &drive), TWD_OK);
    assert_num_close(drive.cpg[0].frequency_hz, 0.84, ROUNDING);
    assert_int_equal(twd_model_decode(&twd_model_c, true, &ranges, parameter, 12, &drive), TWD_OK);
    assert_num_close(drive.cpg[0].frequency_hz, 0.31, ROUNDING);
    assert_true(drive.weight[0] == TWD_NUM(1));
}

/* Parameters 0 and 1 are the ends of each range as the table of ranges has them. */
static void ends_of_the_ranges_are_reached(void **state)
{
    (void)state;
    twd_num parameter[12];
    struct twd_model_drive drive;
    for (int end = 0; end <= 1; end++) {
        for (int i = 0; i < 12; i++)
            parameter[i] = twd_num_from_double(end);
        assert_int_equal(twd_model_decode(&twd_model_c, true, &ranges, parameter, 12, &drive), TWD_OK);
        assert_num_close(drive.cpg[0].frequency_hz, end ? 1.3 : 0.3, ROUNDING);
        assert_num_close(drive.cpg[0].amplitude[3], end ? 0.5 : 0.0, ROUNDING);
        assert_num_close(drive.cpg[0].centre[3], end ? 0.9 : 0.1, ROUNDING);
        assert_int_equal(drive.cpg[0].phase_lag[2], 0);
    }
}

/* A wrong count, or one parameter that is not in [0, 1] or no number, is refused, and the drive stays as it was. */
static void bad_parameters_leave_the_drive_alone(void **state)
{
    (void)state;
    static const double bad[] = {-0.001, 1.001, (double)NAN, (double)INFINITY, -(double)INFINITY};
    struct twd_model_drive drive;
    mark(&drive, sizeof drive);
    twd_num parameter[23];
    number_off(parameter, 23);

    assert_int_equal(twd_model_decode(&twd_model_h, true, &ranges, parameter, 21, &drive), TWD_ERROR_PARAMETER_COUNT);
    assert_int_equal(twd_model_decode(&twd_model_h, true, &ranges, parameter, 23, &drive), TWD_ERROR_PARAMETER_COUNT);
    assert_int_equal(twd_model_decode(&twd_model_h, true, &ranges, parameter, 0, &drive), TWD_ERROR_PARAMETER_COUNT);
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        for (size_t i = 0; i < 22; i++) {
            number_off(parameter, 22);
            parameter[i] = twd_num_from_double(bad[k]);
            const enum twd_error error = twd_model_decode(&twd_model_h, true, &ranges, parameter, 22, &drive);
            assert_int_equal(error, TWD_ERROR_PARAMETER);
        }
    }
    assert_marked(&drive, sizeof drive);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(models_have_the_papers_parameter_counts),
        cmocka_unit_test(hierarchical_model_reads_in_order),
        cmocka_unit_test(hierarchical_model_without_centre_leaves_centres_out),
        cmocka_unit_test(lone_models_take_the_fixed_frequency),
        cmocka_unit_test(ends_of_the_ranges_are_reached),
        cmocka_unit_test(bad_parameters_leave_the_drive_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
