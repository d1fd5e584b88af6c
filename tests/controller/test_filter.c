#include "controller_test.h"

#include <twiddle/filter.h>

/* What each tick may add: four constants and four products, rounded by 2^-25 each, of values up to 1; in double
 * precision the polynomial of the exponential counts more, its error being at most 1e-11. */
#define TOLERANCE_PER_TICK BY_NUMBER(1e-11, 8 * 2.98e-8)

/* The closed form of y'' = a (a/4 (Y - y) - y') from (y0, v0), with v = y' / (a/2) and s = a t / 2:
 * y = Y + e^-s ((1 + s) (y0 - Y) + s v0), v = e^-s (-s (y0 - Y) + (1 - s) v0). */
struct response {
    double value;
    double velocity;
};

static struct response closed_form(double rate_per_s, double time_s, double y0, double v0, double target)
{
    const double s = rate_per_s * time_s / 2.0;
    const double error = y0 - target;
    const struct response response = {target + exp(-s) * ((1.0 + s) * error + s * v0),
                                      exp(-s) * (-s * error + (1.0 - s) * v0)};
    return response;
}

/* At ticks of 1 to 50 ms and rates of 5 to 60 /s, from rest and in motion, 1 s of steps lies on the closed form. */
static void filter_follows_the_closed_form(void **state)
{
    (void)state;
    static const double tick_s[] = {0.001, 0.002, 0.005, 0.01, 0.02, 0.05};
    static const double rate_per_s[] = {5.0, 20.0, 60.0};
    static const double start[][3] = {{0.0, 0.0, 0.5}, {0.5, 0.0, 0.1}, {0.2, 0.7, 0.9}, {1.0, -0.4, 0.0}};
    double worst = 0.0;
    double worst_per_tick = 0.0;

    for (size_t h = 0; h < sizeof tick_s / sizeof *tick_s; h++) {
        for (size_t a = 0; a < sizeof rate_per_s / sizeof *rate_per_s; a++) {
            const struct twd_filter_step step = twd_filter_step_make((twd_num)rate_per_s[a], (twd_num)tick_s[h]);
            for (size_t k = 0; k < sizeof start / sizeof *start; k++) {
                struct twd_filter filter = {(twd_num)start[k][0], (twd_num)start[k][1]};
                for (int tick = 1; tick * tick_s[h] <= 1.0; tick++) {
                    twd_filter_advance(&filter, &step, (twd_num)start[k][2]);
                    const struct response expected =
                        closed_form(rate_per_s[a], tick * tick_s[h], start[k][0], start[k][1], start[k][2]);
                    const double error = fmax(fabs((double)filter.value - expected.value),
                                              fabs((double)filter.velocity - expected.velocity));
                    worst = fmax(worst, error);
                    worst_per_tick = fmax(worst_per_tick, error / tick);
                }
            }
        }
    }
    print_message("filter: error at most %.2g, and %.2g a tick\n", worst, worst_per_tick);
    assert_true(worst_per_tick <= TOLERANCE_PER_TICK);
}

/* A target that changes on the way is followed from the state of that moment, by the same closed form piece by
 * piece. */
static void filter_follows_a_moving_target(void **state)
{
    (void)state;
    const struct twd_filter_step step = twd_filter_step_make(TWD_NUM(20), TWD_NUM(0.01));
    struct twd_filter filter = {TWD_NUM(0), TWD_NUM(0)};
    struct response at_change = {0.0, 0.0};
    for (int piece = 0; piece < 10; piece++) {
        const double target = piece % 2 == 0 ? 0.5 : 0.1;
        for (int tick = 0; tick < 7; tick++)
            twd_filter_advance(&filter, &step, (twd_num)target);
        at_change = closed_form(20.0, 0.07, at_change.value, at_change.velocity, target);
        assert_close(filter.value, at_change.value, 70 * TOLERANCE_PER_TICK);
        assert_close(filter.velocity, at_change.velocity, 70 * TOLERANCE_PER_TICK);
    }
}

/* Two ticks are one tick of twice the length: the solution is exact, not an approximation that depends on the step. */
static void ticks_add_up(void **state)
{
    (void)state;
    const struct twd_filter_step one = twd_filter_step_make(TWD_NUM(20), TWD_NUM(0.02));
    const struct twd_filter_step half = twd_filter_step_make(TWD_NUM(20), TWD_NUM(0.01));
    struct twd_filter whole = {TWD_NUM(0.3), TWD_NUM(-0.2)};
    struct twd_filter halves = whole;
    twd_filter_advance(&whole, &one, TWD_NUM(0.5));
    twd_filter_advance(&halves, &half, TWD_NUM(0.5));
    twd_filter_advance(&halves, &half, TWD_NUM(0.5));
    assert_close(whole.value, (double)halves.value, 2 * TOLERANCE_PER_TICK);
    assert_close(whole.velocity, (double)halves.velocity, 2 * TOLERANCE_PER_TICK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(filter_follows_the_closed_form),
        cmocka_unit_test(filter_follows_a_moving_target),
        cmocka_unit_test(ticks_add_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
