/* The networks against the paper's continuous equations, integrated by GSL's adaptive Prince-Dormand 8(9) method in
 * double precision with relative and absolute tolerance 1e-10. */
#include "controller_test.h"
#include "ring_topology.h"

#include <twiddle/cpg.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#define SETS 200
#define DURATION_S 3.0
#define FILTER_RATE_PER_S 20.0

/* Tolerance of the phases at a tick h, rad. Second-order Adams-Bashforth errs by (5/12) h^3 |theta'''| a tick, so by
 * (5/12) h^2 times the integral of |theta'''| in all. Per neighbour, theta''' = r'' sin + 2 r' psi' cos + r (psi'' cos
 * - psi'^2 sin), where psi is the phase difference, |psi'| <= 2 and r <= 0.5:
 *   - the total variation of r' in a critically damped step of R <= 0.5 at a = 20 /s is 2 R a / (2 e) = 3.7,
 *   - 2 r' psi' integrates to at most 2 x 0.5 x 2 = 2,
 *   - r (psi'' + psi'^2) is at most 0.5 (4 + 4) while psi moves, about 1 s: 4.
 * With two neighbours that is 19.4. A difference that starts near its unstable equilibrium moves away at up to 2 /s for
 * the about 1 s that it takes to leave, which multiplies early errors by up to e^2 = 7.4. Together: 60 h^2. */
#define PHASE_TOLERANCE_RAD(tick_s) (60.0 * (tick_s) * (tick_s))

/* x moves by at most r <= 0.5 a radian of phase; amplitude and centre, of at most 0.5 and 1, are exact but for rounding
 * and the filter's own error. */
#define OUTPUT_TOLERANCE(tick_s) (0.5 * PHASE_TOLERANCE_RAD(tick_s) + BY_NUMBER(1e-8, 2e-6, 2e-6) + 1.5 * FILTER_ERROR)

static const struct twd_topology *const networks[] = {&twd_cpg_c, &twd_cpg_m, &twd_cpg_s, &ring};

/* One random set of parameters. */
struct set {
    const struct twd_topology *topology;
    bool with_centre;
    enum twd_return_lag return_lag;
    struct twd_cpg_drive drive;
    twd_phase phase[TWD_MAX_OSCILLATORS];
};

/* Largest differences found. */
struct worst {
    double phase_rad;
    double output;
};

static struct set random_set(uint64_t *random, int index)
{
    struct set set;
    memset(&set, 0, sizeof set);
    set.topology = networks[index % 4];
    set.with_centre = (index / 4) % 2 == 0;
    set.return_lag = (index / 8) % 2 == 0 ? TWD_RETURN_LAG_NEGATED : TWD_RETURN_LAG_EQUAL;
    set.drive.frequency_hz = twd_num_from_double(uniform(random, 0.3, 2.0));
    for (int i = 0; i < TWD_MAX_OSCILLATORS; i++) {
        set.drive.amplitude[i] = twd_num_from_double(uniform(random, 0.0, 0.5));
        set.drive.centre[i] = twd_num_from_double(uniform(random, 0.0, 1.0));
        set.phase[i] = uniform_phase(random);
    }
    for (int k = 0; k < TWD_MAX_COUPLINGS; k++)
        set.drive.phase_lag[k] = uniform_phase(random);
    return set;
}

/* The state y of the reference: for oscillator i, theta, r, r', c, c' at 5 i. The sums run over i and j as the paper
 * prints them, with w_ij = 1 where the table couples i and j, phi_ij = phi one way and -phi or phi the other. */
static int derivative(double time_s, const double y[], double dydt[], void *context)
{
    (void)time_s;
    const struct set *const set = context;
    const double a = FILTER_RATE_PER_S;
    const int n = set->topology->oscillators;
    for (int i = 0; i < n; i++) {
        dydt[5 * i] = 2.0 * PI * twd_num_to_double(set->drive.frequency_hz);
        for (int k = 0; k < set->topology->couplings; k++) {
            const struct twd_coupling coupling = set->topology->coupling[k];
            const double phi = 2.0 * PI * (double)set->drive.phase_lag[k] / 4294967296.0;
            const double return_phi = set->return_lag == TWD_RETURN_LAG_EQUAL ? phi : -phi;
            const int first = coupling.first;
            const int second = coupling.second;
            if (i == first) dydt[5 * i] += y[5 * second + 1] * sin(y[5 * second] - y[5 * i] - phi);
            if (i == second) dydt[5 * i] += y[5 * first + 1] * sin(y[5 * first] - y[5 * i] - return_phi);
        }
        dydt[5 * i + 1] = y[5 * i + 2];
        dydt[5 * i + 2] = a * (a / 4.0 * (twd_num_to_double(set->drive.amplitude[i]) - y[5 * i + 1]) - y[5 * i + 2]);
        dydt[5 * i + 3] = y[5 * i + 4];
        dydt[5 * i + 4] = a * (a / 4.0 * (twd_num_to_double(set->drive.centre[i]) - y[5 * i + 3]) - y[5 * i + 4]);
    }
    return GSL_SUCCESS;
}

static void compare(const struct set *set, const struct twd_cpg *cpg, const double *y, struct worst *worst)
{
    for (uint8_t i = 0; i < set->topology->oscillators; i++) {
        const double theta = y[5 * i];
        const double expected =
            set->with_centre ? y[5 * i + 3] + y[5 * i + 1] * cos(theta) : y[5 * i + 1] * (1.0 + cos(theta));
        const double lead = remainder(2.0 * PI * signed_turns(cpg->oscillator[i].phase) - theta, 2.0 * PI);
        worst->phase_rad = fmax(worst->phase_rad, fabs(lead));
        worst->output = fmax(worst->output, fabs(twd_num_to_double(twd_cpg_output(cpg, i)) - expected));
    }
}

static struct worst run(const struct set *set, double tick_s)
{
    struct twd_cpg cpg;
    const struct twd_cpg_config config = {
        .with_centre = set->with_centre,
        .tick_s = twd_small_from_double(tick_s),
        .amplitude_rate_per_s = TWD_RATE(FILTER_RATE_PER_S),
        .centre_rate_per_s = TWD_RATE(FILTER_RATE_PER_S),
        .return_lag = set->return_lag,
    };
    assert_int_equal(twd_cpg_init(&cpg, set->topology, &config), TWD_OK);
    twd_cpg_start(&cpg, &set->drive, set->phase);

    double y[5 * TWD_MAX_OSCILLATORS] = {0.0};
    for (int i = 0; i < set->topology->oscillators; i++) {
        y[5 * i] = 2.0 * PI * (double)set->phase[i] / 4294967296.0;
        y[5 * i + 3] = twd_num_to_double(set->topology->initial_centre[i]);
    }
    struct set copy = *set;
    gsl_odeiv2_system system = {derivative, NULL, (size_t)(5 * set->topology->oscillators), &copy};
    gsl_odeiv2_driver *driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3, 1e-10, 1e-10);
    assert_non_null(driver);

    struct worst worst = {0.0, 0.0};
    double time_s = 0.0;
    const int ticks = (int)lround(DURATION_S / tick_s);
    for (int tick = 1; tick <= ticks; tick++) {
        assert_int_equal(gsl_odeiv2_driver_apply(driver, &time_s, tick * tick_s, y), GSL_SUCCESS);
        twd_cpg_tick(&cpg);
        compare(set, &cpg, y, &worst);
    }
    gsl_odeiv2_driver_free(driver);
    return worst;
}

/* The worst of SETS sets, all networks with and without centre; prints the seed, and every set beyond the tolerance. */
static struct worst run_all(double tick_s)
{
    const uint64_t seed = 20110824;
    uint64_t random = seed;
    struct worst all = {0.0, 0.0};
    int failed = 0;
    for (int k = 0; k < SETS; k++) {
        const struct set set = random_set(&random, k);
        const struct worst one = run(&set, tick_s);
        if (!(one.phase_rad <= PHASE_TOLERANCE_RAD(tick_s)) || !(one.output <= OUTPUT_TOLERANCE(tick_s))) {
            print_error("set %d (%s, %s centre, %s return lag): phase %g rad, output %g\n", k, set.topology->name,
                        set.with_centre ? "with" : "without",
                        set.return_lag == TWD_RETURN_LAG_EQUAL ? "equal" : "negated", one.phase_rad, one.output);
            failed++;
        }
        all.phase_rad = fmax(all.phase_rad, one.phase_rad);
        all.output = fmax(all.output, one.output);
    }
    print_message("seed %lu, %d sets, tick %g s: phase error at most %.2g rad, output error at most %.2g\n",
                  (unsigned long)seed, SETS, tick_s, all.phase_rad, all.output);
    assert_int_equal(failed, 0);
    return all;
}

/* 3 s of 200 random networks, at ticks of 10 ms and 5 ms, stay within the method's error of the continuous equations;
 * in double precision half the tick gives about a quarter of the error: second order. */
static void networks_follow_the_continuous_equations(void **state)
{
    (void)state;
    const struct worst whole = run_all(0.01);
    const struct worst half = run_all(0.005);
    print_message("half the tick divides the phase error by %.2f\n", whole.phase_rad / half.phase_rad);
#ifdef TWD_NUMBER_DOUBLE
    assert_true(whole.phase_rad / half.phase_rad > 3.5);
    assert_true(whole.phase_rad / half.phase_rad < 4.5);
#endif
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(networks_follow_the_continuous_equations),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
