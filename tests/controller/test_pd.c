#include "controller_test.h"

#include <twiddle/pd.h>

/* T = g + Kp (desired - actual) - Kd velocity: 0.01 + 0.21 x 0.2 - 0.0069 x 3 = 0.0313. */
static void pd_law_is_the_papers(void **state)
{
    (void)state;
    const struct twd_pd pd = {TWD_NUM(0.21), TWD_NUM(0.0069), TWD_NUM(1)};
    const twd_num torque = twd_pd_torque(&pd, TWD_NUM(0.5), TWD_NUM(0.3), TWD_RATE(3), TWD_NUM(0.01));
    /* Fixed: half a step of 2^-28 for each number and each product, and three times that for the damping. */
    assert_num_close(torque, 0.0313, BY_NUMBER(1e-15, 1e-8, 3.5 * NUM_STEP));
}

/* At the desired angle and at rest, the torque is gravity's alone. */
static void pd_law_at_rest_holds_the_weight(void **state)
{
    (void)state;
    const struct twd_pd pd = {TWD_NUM(0.21), TWD_NUM(0.0069), TWD_NUM(1)};
    assert_true(twd_pd_torque(&pd, TWD_NUM(0.4), TWD_NUM(0.4), TWD_RATE(0), TWD_NUM(0.02)) == TWD_NUM(0.02));
}

/* D of pd.h. */
static double divisor(double stiffness, double damping, double inertia_kg_m2, double period_s)
{
    return 1.0 + period_s * (damping + period_s * stiffness) / inertia_kg_m2;
}

/* 1000 random joints: the torque of the stable gains is that of one step of implicit Euler. Expected: q1 = q + h v1 and
 * M (v1 - v) / h = Kp (desired - q1) - Kd v1, two linear equations, solved by Cramer's rule in double.
 *
 * Fixed: D is off by half a step of Kd + h Kp, times h / M, and by one of h (Kd + h Kp), 2^-34, over M; with Kp of at
 * least 0.05 and M of at least 1e-5 that is 6e-6 of it, of torques up to 1.3 N m. */
static void stable_gains_make_a_step_of_implicit_euler(void **state)
{
    (void)state;
    uint64_t random = 11;
    print_message("seed 11\n");
    for (int32_t repeat = CASES(1000); repeat > 0; repeat--) {
        const struct twd_pd pd = {twd_num_from_double(uniform(&random, 0.05, 0.5)),
                                  twd_num_from_double(uniform(&random, 0.0, 0.02)), TWD_NUM(1)};
        const twd_small inertia = twd_small_from_double(uniform(&random, 1e-5, 1e-3));
        const twd_small period = twd_small_from_double(uniform(&random, 1e-4, 0.05));
        const twd_num desired = twd_num_from_double(uniform(&random, -1, 1));
        const twd_num actual = twd_num_from_double(uniform(&random, -1, 1));
        const twd_rate velocity = twd_rate_from_double(uniform(&random, -5, 5));
        const double h = twd_small_to_double(period), m = twd_small_to_double(inertia);
        const double kp = twd_num_to_double(pd.stiffness_nm_per_rad), kd = twd_num_to_double(pd.damping_nms_per_rad);
        if (divisor(kp, kd, m, h) > BY_NUMBER(1e6, 1e6, 127.0)) continue;
        struct twd_pd stable;
        assert_int_equal(twd_pd_stable(&pd, inertia, period, &stable), TWD_OK);
        assert_true(stable.torque_limit_nm == pd.torque_limit_nm);

        /* (1) q1 - h v1 = q; (2) kp q1 + (m / h + kd) v1 = m v / h + kp desired */
        const double q = twd_num_to_double(actual), v = twd_rate_to_double(velocity);
        const double right = m * v / h + kp * twd_num_to_double(desired);
        const double v1 = (right - kp * q) / (m / h + kd + kp * h);
        const double expected = m * (v1 - v) / h;
        assert_num_close(twd_pd_torque(&stable, desired, actual, velocity, TWD_NUM(0)), expected,
                         BY_NUMBER(1e-14, 1e-6, 8e-6));
    }
}

/* The largest |angle| between 1.9 s and 2 s, of a joint that starts 0.1 rad from its desired angle and is stepped by
 * semi-implicit Euler in double. */
static double late_swing(const struct twd_pd *pd, double inertia_kg_m2, double period_s)
{
    double q = 0.1, v = 0.0, largest = 0.0;
    const int steps = (int)(2.0 / period_s);
    for (int k = 0; k < steps && fabs(q) < 1e3; k++) {
        const twd_num torque =
            twd_pd_torque(pd, TWD_NUM(0), twd_num_from_double(q), twd_rate_from_double(v), TWD_NUM(0));
        v += period_s * twd_num_to_double(torque) / inertia_kg_m2;
        q += period_s * v;
        if (k * period_s > 1.9 && fabs(q) > largest) largest = fabs(q);
    }
    return fabs(q) < 1e3 ? largest : fabs(q);
}

/* Gains chosen for 60 rad/s, on the 3.7e-5 kg m2 of a straight iCub index at 10 ms: the joint swings out of bounds
 * under the plain law and settles under the stable one, also if the true inertia is 3/4 of the assumed one, or three
 * times it. */
static void stable_gains_settle_where_the_plain_law_diverges(void **state)
{
    (void)state;
    const struct twd_pd plain = {TWD_NUM(0.21), TWD_NUM(0.0069), TWD_NUM(1)};
    const double inertia = 3.7e-5, period = 0.01;
    struct twd_pd stable;
    assert_int_equal(twd_pd_stable(&plain, twd_small_from_double(inertia), twd_small_from_double(period), &stable),
                     TWD_OK);
    /* Fixed: the torque ends at 8 N m, which is a swing of about 8 rad. */
    assert_true(late_swing(&plain, inertia, period) > BY_NUMBER(100.0, 100.0, 5.0));
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
    assert_int_equal(twd_pd_stable(&plain, TWD_SMALL(5.8e-5), TWD_SMALL(1e-6), &stable), TWD_OK);
    assert_num_close(stable.stiffness_nm_per_rad, 0.21, 0.21 * 2e-4);
    assert_num_close(stable.damping_nms_per_rad, 0.0069, 0.0069 * 2e-4);
}

/* Periods, inertias and gains outside their ranges are refused, and nothing is written. */
static void stable_gains_reject_what_is_out_of_range(void **state)
{
    (void)state;
    static const double bad_period_s[] = {0.0, -0.01, 0.11, 1e6, (double)NAN, (double)INFINITY, -(double)INFINITY};
    static const double bad_inertia[] = {0.0, -1e-5, 1e30, (double)NAN, (double)INFINITY, -(double)INFINITY};
    static const struct twd_pd bad_pd[] = {{TWD_NUM(0), TWD_NUM(0.0069), TWD_NUM(1)},
                                           {TWD_NUM(-0.1), TWD_NUM(0.0069), TWD_NUM(1)},
                                           {TWD_NUM(0.21), TWD_NUM(-0.1), TWD_NUM(1)},
                                           {TWD_NUM(0.21), TWD_NUM(0.0069), TWD_NUM(0)}};
    const struct twd_pd good = {TWD_NUM(0.21), TWD_NUM(0.0069), TWD_NUM(1)};
    const twd_small inertia = TWD_SMALL(5e-5), period = TWD_SMALL(0.01);
    struct twd_pd stable;
    mark(&stable, sizeof stable);
    for (size_t k = 0; k < sizeof bad_period_s / sizeof *bad_period_s; k++)
        assert_int_equal(twd_pd_stable(&good, inertia, twd_small_from_double(bad_period_s[k]), &stable),
                         TWD_ERROR_TICK);
    for (size_t k = 0; k < sizeof bad_inertia / sizeof *bad_inertia; k++)
        assert_int_equal(twd_pd_stable(&good, twd_small_from_double(bad_inertia[k]), period, &stable), TWD_ERROR_RANGE);
    for (size_t k = 0; k < sizeof bad_pd / sizeof *bad_pd; k++)
        assert_int_equal(twd_pd_stable(&bad_pd[k], inertia, period, &stable), TWD_ERROR_RANGE);
    assert_marked(&stable, sizeof stable);
}

/* An inertia so small that D would be above its limit is refused; one that keeps D just below gives Kp / D. */
static void stable_gains_reject_what_divides_them_by_too_much(void **state)
{
    (void)state;
    const struct twd_pd pd = {TWD_NUM(0.21), TWD_NUM(0.0069), TWD_NUM(1)};
    const double limit = BY_NUMBER(1e6, 1e6, 127.0);
    const double divided = divisor(0.21, 0.0069, 1.0, 0.1) - 1.0; /* (D - 1) M */
    struct twd_pd stable;
    mark(&stable, sizeof stable);
    const twd_small too_light = twd_small_from_double(divided / (1.03 * limit));
    assert_int_equal(twd_pd_stable(&pd, too_light, TWD_SMALL(0.1), &stable), TWD_ERROR_RANGE);
    assert_marked(&stable, sizeof stable);
    const twd_small light = twd_small_from_double(divided / (0.97 * limit));
    assert_int_equal(twd_pd_stable(&pd, light, TWD_SMALL(0.1), &stable), TWD_OK);
    assert_num_close(stable.stiffness_nm_per_rad, 0.21 / (0.97 * limit + 1.0), BY_NUMBER(1e-15, 1e-12, 2 * NUM_STEP));
}

/* Good gains may be replaced in place. */
static void stable_gains_may_replace_the_plain_ones(void **state)
{
    (void)state;
    const struct twd_pd plain = {TWD_NUM(0.21), TWD_NUM(0.0069), TWD_NUM(1)};
    struct twd_pd stable, in_place = plain;
    assert_int_equal(twd_pd_stable(&plain, TWD_SMALL(5e-5), TWD_SMALL(0.01), &stable), TWD_OK);
    assert_int_equal(twd_pd_stable(&in_place, TWD_SMALL(5e-5), TWD_SMALL(0.01), &in_place), TWD_OK);
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
        cmocka_unit_test(stable_gains_reject_what_divides_them_by_too_much),
        cmocka_unit_test(stable_gains_may_replace_the_plain_ones),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
