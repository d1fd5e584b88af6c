#include "controller_test.h"

#include <twiddle/filter.h>

/* Tolerances, for a way of size 1, after `ticks` ticks with k = a h / 2:
 *   - float and double: each tick may add four constants and four products, rounded by 2^-25 each; in double
 *     precision the polynomial of the exponential counts more, its error being at most 1e-11;
 *   - fixed: FILTER_ERROR, and each of the two parts of the state stops within 1 / (1 - exp(-k)) steps of 2^-28. */
#define TOLERANCE_PER_TICK BY_NUMBER(1e-11, 8 * 2.98e-8, 0.0)

static double tolerance(double k, int ticks)
{
    return TOLERANCE_PER_TICK * ticks + FILTER_ERROR + BY_NUMBER(0.0, 0.0, 2.0 * NUM_STEP) / (1.0 - exp(-k));
}

/* The closed form of y'' = a (a/4 (Y - y) - y') from y0 at rest, with v = y' / (a/2) and s = a t / 2:
 * y = Y + e^-s (1 + s) (y0 - Y), v = -e^-s s (y0 - Y). */
struct response {
    double value;
    double velocity;
};

static struct response closed_form(double rate_per_s, double time_s, double start, double target)
{
    const double s = rate_per_s * time_s / 2.0;
    const struct response response = {target + exp(-s) * (1.0 + s) * (start - target), -exp(-s) * s * (start - target)};
    return response;
}

/* A second of ticks from `start` to `target`; returns the largest error as a part of its tolerance. */
static double worst_of_a_second(double rate_per_s, double tick_s, double start, double target)
{
    const struct twd_filter_step step =
        twd_filter_step_make(twd_rate_from_double(rate_per_s), twd_small_from_double(tick_s));
    const twd_num target_num = twd_num_from_double(target);
    struct twd_filter filter = twd_filter_start(twd_num_from_double(start), target_num);
    double worst = 0.0;
    for (int tick = 1; tick * tick_s <= 1.0; tick++) {
        twd_filter_advance(&filter, &step, target_num);
        const struct response expected = closed_form(rate_per_s, tick * tick_s, start, target);
        const double of_value = fabs(twd_num_to_double(filter.value) - expected.value);
        const double of_velocity =
            fabs(twd_num_to_double(twd_filter_velocity(&filter, target_num)) - expected.velocity);
        worst = fmax(worst, fmax(of_value, of_velocity) / tolerance(rate_per_s * tick_s / 2.0, tick));
    }
    return worst;
}

/* At ticks of 1 to 50 ms and rates of 5 to 60 /s, 1 s of steps lies on the closed form. */
static void filter_follows_the_closed_form(void **state)
{
    (void)state;
    static const double tick_s[] = {0.001, 0.002, 0.005, 0.01, 0.02, 0.05};
    static const double rate_per_s[] = {5.0, 20.0, 60.0};
    static const double way[][2] = {{0.0, 0.5}, {0.5, 0.1}, {0.2, 0.9}, {1.0, 0.0}};
    const double largest_product = twd_num_to_double(TWD_LARGEST_RATE_TIMES_TICK);
    double worst = 0.0;
    int filters = 0;
    for (size_t h = 0; h < sizeof tick_s / sizeof *tick_s; h++) {
        for (size_t a = 0; a < sizeof rate_per_s / sizeof *rate_per_s; a++) {
            if (rate_per_s[a] * tick_s[h] > largest_product) continue;
            for (size_t k = 0; k < sizeof way / sizeof *way; k++)
                worst = fmax(worst, worst_of_a_second(rate_per_s[a], tick_s[h], way[k][0], way[k][1]));
            filters++;
        }
    }
    print_message("filter: error at most %.2g of the tolerance, %d filters\n", worst, filters);
    assert_true(worst <= 1.0);
    assert_true(filters >= 17); /* the fixed build has no filter of 60 /s at 50 ms */
}

/* At the largest product of rate and tick the filter still goes straight to its target, and stays there. */
static void fastest_filter_arrives_and_stays(void **state)
{
    (void)state;
    const struct twd_filter_step step =
        twd_filter_step_make(twd_rate_from_double(BY_NUMBER(320.0, 320.0, 13.75)), TWD_SMALL(0.1));
    struct twd_filter filter = twd_filter_start(TWD_NUM(1), TWD_NUM(0.25));
    for (int tick = 0; tick < 100; tick++) {
        twd_filter_advance(&filter, &step, TWD_NUM(0.25));
        assert_true(twd_within(filter.value, TWD_NUM(0.2499), TWD_NUM(1)));
    }
    assert_num_close(filter.value, 0.25, BY_NUMBER(1e-15, 1e-7, 4 * NUM_STEP));
    assert_num_close(twd_filter_velocity(&filter, TWD_NUM(0.25)), 0.0, BY_NUMBER(1e-15, 1e-7, 4 * NUM_STEP));
}

/* Two ticks are one tick of twice the length: the solution is exact, not an approximation that depends on the step. */
static void ticks_add_up(void **state)
{
    (void)state;
    const twd_num target = TWD_NUM(0.5);
    const struct twd_filter_step one = twd_filter_step_make(TWD_RATE(20), TWD_SMALL(0.02));
    const struct twd_filter_step half = twd_filter_step_make(TWD_RATE(20), TWD_SMALL(0.01));
    struct twd_filter whole = twd_filter_start(TWD_NUM(-0.2), target);
    struct twd_filter halves = whole;
    for (int tick = 1; tick <= 5; tick++) {
        twd_filter_advance(&whole, &one, target);
        twd_filter_advance(&halves, &half, target);
        twd_filter_advance(&halves, &half, target);
        const double both = tolerance(0.2, tick) + tolerance(0.1, 2 * tick);
        const double value = twd_num_to_double(halves.value);
        assert_num_close(whole.value, value, both);
        assert_num_close(twd_filter_velocity(&whole, target), twd_num_to_double(twd_filter_velocity(&halves, target)),
                         both);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(filter_follows_the_closed_form),
        cmocka_unit_test(fastest_filter_arrives_and_stays),
        cmocka_unit_test(ticks_add_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
