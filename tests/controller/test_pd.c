#include "controller_test.h"

#include <twiddle/pd.h>

/* T = g + Kp (desired - actual) - Kd velocity: 0.01 + 0.21 x 0.2 - 0.0069 x 3 = 0.0313. */
static void pd_law_is_the_papers(void **state)
{
    (void)state;
    const struct twd_pd pd = {TWD_NUM(0.21), TWD_NUM(0.0069), TWD_NUM(1)};
    const twd_num torque = twd_pd_torque(&pd, TWD_NUM(0.5), TWD_NUM(0.3), TWD_NUM(3), TWD_NUM(0.01));
    assert_close(torque, 0.0313, BY_NUMBER(1e-15, 1e-8));
}

/* At the desired angle and at rest, the torque is gravity's alone. */
static void pd_law_at_rest_holds_the_weight(void **state)
{
    (void)state;
    const struct twd_pd pd = {TWD_NUM(0.21), TWD_NUM(0.0069), TWD_NUM(1)};
    assert_true(twd_pd_torque(&pd, TWD_NUM(0.4), TWD_NUM(0.4), TWD_NUM(0), TWD_NUM(0.02)) == TWD_NUM(0.02));
}

/* 1000 random joints: the torque of the stable gains is that of one step of implicit Euler. Expected: q1 = q + h v1 and
 * M (v1 - v) / h = Kp (desired - q1) - Kd v1, two linear equations, solved by Cramer's rule in double. */
static void stable_gains_make_a_step_of_implicit_euler(void **state)
{
    (void)state;
    uint64_t random = 11;
    print_message("seed 11\n");
    for (int repeat = 0; repeat < 1000; repeat++) {
        const struct twd_pd pd = {(twd_num)uniform(&random, 0.05, 0.5), (twd_num)uniform(&random, 0.0, 0.02),
                                  TWD_NUM(1)};
        const twd_num inertia = (twd_num)uniform(&random, 1e-5, 1e-3), period = (twd_num)uniform(&random, 1e-4, 0.05);
        const twd_num desired = (twd_num)uniform(&random, -1, 1), q = (twd_num)uniform(&random, -1, 1);
        const twd_num v = (twd_num)uniform(&random, -5, 5);
        struct twd_pd stable;
        assert_int_equal(twd_pd_stable(&pd, inertia, period, &stable), TWD_OK);
        assert_true(stable.torque_limit_nm == pd.torque_limit_nm);

        const double h = (double)period, m = (double)inertia;
        const double kp = (double)pd.stiffness_nm_per_rad, kd = (double)pd.damping_nms_per_rad;
        /* (1) q1 - h v1 = q; (2) kp q1 + (m / h + kd) v1 = m v / h + kp desired */
        const double right = m * (double)v / h + kp * (double)desired;
        const double v1 = (right - kp * (double)q) / (m / h + kd + kp * h);
        const double expected = m * (v1 - (double)v) / h;
        assert_close(twd_pd_torque(&stable, desired, q, v, TWD_NUM(0)), expected, BY_NUMBER(1e-14, 1e-6));
    }
}

/* The largest |angle| between 1.9 s and 2 s, of a joint that starts 0.1 rad from its desired angle and is stepped by
 * semi-implicit Euler in double. */
static double late_swing(const struct twd_pd *pd, double inertia_kg_m2, double period_s)
{
    double q = 0.1, v = 0.0, largest = 0.0;
    const int steps = (int)(2.0 / period_s);
    for (int k = 0; k < steps && fabs(q) < 1e3; k++) {
        v += period_s * (double)twd_pd_torque(pd, 0, (twd_num)q, (twd_num)v, 0) / inertia_kg_m2;
        q += period_s * v;
        if (k * period_s > 1.9 && fabs(q) > largest) largest = fabs(q);
    }
    return fabs(q) < 1e3 ? largest : fabs(q);
}

/* Gains chosen for 60 rad/s, on the 3.7e-5 kg m2 of a straight iCub index at 10 ms: the joint swings out of bounds under
 * the plain law and settles under the stable one, also if the true inertia is 3/4 of the assumed one, or three times it. */
static void stable_gains_settle_where_the_plain_law_diverges(void **state)
{
    (void)state;
    const struct twd_pd plain = {TWD_NUM(0.21), TWD_NUM(0.0069), TWD_NUM(1)};
    const double inertia = 3.7e-5, period = 0.01;
    struct twd_pd stable;
    assert_int_equal(twd_pd_stable(&plain, (twd_num)inertia, (twd_num)period, &stable), TWD_OK);
    assert_true(late_swing(&plain, inertia, period) > 100.0);
    assert_true(late_swing(&stable, inertia, period) < 1e-6);
    assert_true(late_swing(&stable, 0.75 * inertia, period) < 1e-6);
    assert_true(late_swing(&stable, 3.0 * inertia, period) < 1e-3);
}

/* With the period, the difference from the plain gains shrinks in proportion. Expected: for h of 1e-6 s, less than 2e-4
 * of them. */
static void stable_gains_tend_to_the_plain_ones(void **state)
{
    (void)state;
    const struct twd_pd plain = {TWD_NUM(0.21), TWD_NUM(0.0069), TWD_NUM(1)};
    struct twd_pd stable;
    assert_int_equal(twd_pd_stable(&plain, TWD_NUM(5.8e-5), TWD_NUM(1e-6), &stable), TWD_OK);
    assert_close(stable.stiffness_nm_per_rad, 0.21, 0.21 * 2e-4);
    assert_close(stable.damping_nms_per_rad, 0.0069, 0.0069 * 2e-4);
}

/* Periods, inertias and gains outside their ranges are refused, and nothing is written; good gains may be replaced in
 * place. */
static void stable_gains_reject_what_is_out_of_range(void **state)
{
    (void)state;
    const struct twd_pd good = {TWD_NUM(0.21), TWD_NUM(0.0069), TWD_NUM(1)};
    const struct twd_pd slack = {TWD_NUM(0), TWD_NUM(0.0069), TWD_NUM(1)};
    const struct twd_pd driving = {TWD_NUM(0.21), TWD_NUM(-0.1), TWD_NUM(1)};
    const twd_num nan = (twd_num)NAN, inertia = TWD_NUM(5e-5), period = TWD_NUM(0.01);
    struct twd_pd stable, before;
    memset(&stable, 0x5A, sizeof stable);
    memcpy(&before, &stable, sizeof stable);
    assert_int_equal(twd_pd_stable(&good, inertia, TWD_NUM(0), &stable), TWD_ERROR_TICK);
    assert_int_equal(twd_pd_stable(&good, inertia, TWD_NUM(0.11), &stable), TWD_ERROR_TICK);
    assert_int_equal(twd_pd_stable(&good, inertia, nan, &stable), TWD_ERROR_TICK);
    assert_int_equal(twd_pd_stable(&good, TWD_NUM(0), period, &stable), TWD_ERROR_RANGE);
    assert_int_equal(twd_pd_stable(&good, nan, period, &stable), TWD_ERROR_RANGE);
    assert_int_equal(twd_pd_stable(&good, (twd_num)INFINITY, period, &stable), TWD_ERROR_RANGE);
    assert_int_equal(twd_pd_stable(&good, TWD_NUM(1e-12), period, &stable), TWD_ERROR_RANGE);
    assert_int_equal(twd_pd_stable(&slack, inertia, period, &stable), TWD_ERROR_RANGE);
    assert_int_equal(twd_pd_stable(&driving, inertia, period, &stable), TWD_ERROR_RANGE);
    assert_memory_equal(&stable, &before, sizeof stable);

    struct twd_pd in_place = good;
    assert_int_equal(twd_pd_stable(&good, inertia, period, &stable), TWD_OK);
    assert_int_equal(twd_pd_stable(&in_place, inertia, period, &in_place), TWD_OK);
    assert_memory_equal(&in_place, &stable, sizeof stable);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pd_law_is_the_papers),
        cmocka_unit_test(pd_law_at_rest_holds_the_weight),
        cmocka_unit_test(stable_gains_make_a_step_of_implicit_euler),
        cmocka_unit_test(stable_gains_settle_where_the_plain_law_diverges),
        cmocka_unit_test(stable_gains_tend_to_the_plain_ones),
        cmocka_unit_test(stable_gains_reject_what_is_out_of_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
