/* What a network refuses to be made of. */
#include "controller_test.h"
#include "ring_topology.h"

#include <twiddle/cpg.h>

static struct twd_cpg_config config_of(double tick_s, double amplitude_rate_per_s, double centre_rate_per_s)
{
    const struct twd_cpg_config config = {
        .with_centre = true,
        .tick_s = twd_small_from_double(tick_s),
        .amplitude_rate_per_s = twd_rate_from_double(amplitude_rate_per_s),
        .centre_rate_per_s = twd_rate_from_double(centre_rate_per_s),
    };
    return config;
}

static void assert_refused_as(const struct twd_topology *topology, const struct twd_cpg_config *config,
                              enum twd_error error)
{
    static struct twd_cpg cpg;
    mark(&cpg, sizeof cpg);
    assert_int_equal(twd_cpg_init(&cpg, topology, config), error);
    assert_marked(&cpg, sizeof cpg);
}

/* A topology that does not hold together is refused with its own error, and the network stays as it was. */
static void topologies_that_do_not_hold_together_are_refused(void **state)
{
    (void)state;
    static const struct twd_coupling missing[] = {{0, 6}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}};
    static const struct twd_coupling self[] = {{1, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}};
    static const uint8_t no_oscillator[] = {0, 1, 2, 3, 4, 6};
    static const twd_num beyond[] = {TWD_NUM(0), TWD_NUM(1.5), TWD_NUM(0), TWD_NUM(0), TWD_NUM(0), TWD_NUM(0)};
    twd_num no_number[RING_OSCILLATORS] = {TWD_NUM(0)};
    no_number[5] = twd_num_from_double((double)NAN);
    const struct twd_cpg_config config = config_of(0.01, 20.0, 20.0);

#define REFUSED(field, value, error)                                                                                   \
    do {                                                                                                               \
        struct twd_topology topology = ring;                                                                           \
        topology.field = (value);                                                                                      \
        assert_refused_as(&topology, &config, (error));                                                                \
    } while (0)
    REFUSED(oscillators, 0, TWD_ERROR_TOO_MANY_OSCILLATORS);
    REFUSED(oscillators, TWD_MAX_OSCILLATORS + 1, TWD_ERROR_TOO_MANY_OSCILLATORS);
    REFUSED(couplings, TWD_MAX_COUPLINGS + 1, TWD_ERROR_TOO_MANY_COUPLINGS);
    REFUSED(coupling, missing, TWD_ERROR_COUPLING);
    REFUSED(coupling, self, TWD_ERROR_COUPLING);
    REFUSED(joints, 0, TWD_ERROR_TOO_MANY_JOINTS);
    REFUSED(joints, TWD_MAX_JOINTS + 1, TWD_ERROR_TOO_MANY_JOINTS);
    REFUSED(joint_oscillator, no_oscillator, TWD_ERROR_JOINT_OSCILLATOR);
    REFUSED(initial_centre, beyond, TWD_ERROR_RANGE);
    REFUSED(initial_centre, no_number, TWD_ERROR_RANGE);
#undef REFUSED
}

/* A topology that is null, or whose tables are, is refused; couplings may be null where there are none. */
static void null_tables_are_refused(void **state)
{
    (void)state;
    const struct twd_cpg_config config = config_of(0.01, 20.0, 20.0);
    struct twd_topology uncoupled = ring, unjoined = ring, uncentred = ring, separate = ring;
    uncoupled.coupling = NULL;
    unjoined.joint_oscillator = NULL;
    uncentred.initial_centre = NULL;
    separate.coupling = NULL;
    separate.couplings = 0;
    assert_refused_as(NULL, &config, TWD_ERROR_NULL);
    assert_refused_as(&uncoupled, &config, TWD_ERROR_NULL);
    assert_refused_as(&unjoined, &config, TWD_ERROR_NULL);
    assert_refused_as(&uncentred, &config, TWD_ERROR_NULL);
    static struct twd_cpg cpg;
    assert_int_equal(twd_cpg_init(&cpg, &separate, &config), TWD_OK);
}

/* Ticks outside (0, 0.1] s and rates that are none, or too fast for the tick, are refused, the two rates alike. */
static void ticks_and_rates_out_of_range_are_refused(void **state)
{
    (void)state;
    static const double bad_tick_s[] = {0.0, -0.01, 0.1001, 1e6, (double)NAN, (double)INFINITY, -(double)INFINITY};
    static const double bad_rate_per_s[] = {0.0, -20.0, 3300.0, 1e30, (double)NAN, (double)INFINITY, -(double)INFINITY};
    for (size_t k = 0; k < sizeof bad_tick_s / sizeof *bad_tick_s; k++) {
        const struct twd_cpg_config config = config_of(bad_tick_s[k], 20.0, 20.0);
        assert_refused_as(&ring, &config, TWD_ERROR_TICK);
    }
    for (size_t k = 0; k < sizeof bad_rate_per_s / sizeof *bad_rate_per_s; k++) {
        const struct twd_cpg_config of_amplitude = config_of(0.01, bad_rate_per_s[k], 20.0);
        const struct twd_cpg_config of_centre = config_of(0.01, 20.0, bad_rate_per_s[k]);
        assert_refused_as(&ring, &of_amplitude, TWD_ERROR_RANGE);
        assert_refused_as(&ring, &of_centre, TWD_ERROR_RANGE);
    }
}

/* The product of rate and tick may be up to 32, in the fixed build up to 1.375. */
static void rates_are_limited_by_the_tick(void **state)
{
    (void)state;
    static const double tick_s[] = {0.1, 0.01, 0.001};
    const double limit = BY_NUMBER(32.0, 32.0, 1.375);
    for (size_t k = 0; k < sizeof tick_s / sizeof *tick_s; k++) {
        const double slow_per_s = 0.999 * limit / tick_s[k], fast_per_s = 1.001 * limit / tick_s[k];
        const struct twd_cpg_config slow_enough = config_of(tick_s[k], slow_per_s, slow_per_s);
        const struct twd_cpg_config fast_amplitude = config_of(tick_s[k], fast_per_s, slow_per_s);
        const struct twd_cpg_config fast_centre = config_of(tick_s[k], slow_per_s, fast_per_s);
        static struct twd_cpg cpg;
        assert_int_equal(twd_cpg_init(&cpg, &ring, &slow_enough), TWD_OK);
        assert_refused_as(&ring, &fast_amplitude, TWD_ERROR_RANGE);
        assert_refused_as(&ring, &fast_centre, TWD_ERROR_RANGE);
    }
}

/* A word that is none of the settings' is refused. */
static void unknown_settings_are_refused(void **state)
{
    (void)state;
    struct twd_cpg_config of_lag = config_of(0.01, 20.0, 20.0), of_start = config_of(0.01, 20.0, 20.0);
    of_lag.return_lag = (enum twd_return_lag)2;
    of_start.centre_start = (enum twd_centre_start)3;
    assert_refused_as(&ring, &of_lag, TWD_ERROR_RANGE);
    assert_refused_as(&ring, &of_start, TWD_ERROR_RANGE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(topologies_that_do_not_hold_together_are_refused),
        cmocka_unit_test(null_tables_are_refused),
        cmocka_unit_test(ticks_and_rates_out_of_range_are_refused),
        cmocka_unit_test(rates_are_limited_by_the_tick),
        cmocka_unit_test(unknown_settings_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
