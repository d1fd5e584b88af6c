/* The learner on a bandit whose answer is known in closed form: reward = 1 - sum_j (p_j - target_j)^2. */
#include "learner_test.h"

#include <twiddle/input_map.h>
#include <twiddle/learner.h>

enum { TRIALS = 5000, SEEDS = 8 };

/* The reward's distance from its maximum, 1, at `parameter`. */
static double shortfall(const twd_num *parameter, const double *target, size_t units)
{
    double sum = 0.0;
    for (size_t j = 0; j < units; j++) {
        const double distance = twd_num_to_double(parameter[j]) - target[j];
        sum += distance * distance;
    }
    return sum;
}

/* Shortfall of the noise-free policy before and after a training with the paper's settings. */
static void train(uint64_t seed, size_t units, double *before, double *after)
{
    const struct twd_learner_config config = {
        .units = units,
        .inputs = TWD_INPUTS,
        .actor_rate = TWD_NUM(0.1),
        .critic_rate = TWD_NUM(0.1),
        .weight_range = TWD_NUM(0.05),
        .clip = TWD_NUM(0.001),
        .noise = {.start = TWD_NUM(0.5), .end = TWD_NUM(0.05), .decay_fraction = TWD_NUM(0.6), .trials = TRIALS},
        .seed = seed,
    };
    double target[TWD_MAX_UNITS];
    twd_num input[TWD_INPUTS];
    twd_num parameter[TWD_MAX_UNITS];
    static struct twd_learner learner; /* 3 KiB */
    for (size_t j = 0; j < units; j++)
        target[j] = j % 2 == 0 ? 0.2 : 0.8;
    twd_input_map(TWD_SHAPE_SPHERE, TWD_NUM(0.028), TWD_WIDE(10), input);
    assert_int_equal(twd_learner_init(&learner, &config), TWD_OK);
    twd_learner_policy(&learner, input, parameter);
    *before = shortfall(parameter, target, units);
    for (int trial = 0; trial < TRIALS; trial++) {
        twd_learner_act(&learner, input, parameter);
        (void)twd_learner_learn(&learner, twd_wide_from_double(1.0 - shortfall(parameter, target, units)));
    }
    twd_learner_policy(&learner, input, parameter);
    *after = shortfall(parameter, target, units);
}

/* From targets 0.3 away in every unit (an untrained policy is near 0.5) the trained policy comes, for every seed and
 * for as many units as CPG-M, CPG-C and CPG-H have, to within a tenth of the untrained one's shortfall of reward. */
static void noise_free_policy_comes_close_to_the_optimum(void **state)
{
    static const size_t units[] = {5, 12, 22};
    (void)state;
    for (size_t i = 0; i < 3; i++) {
        for (int32_t seed = 1; seed <= CASES(SEEDS); seed++) {
            double before = 0.0;
            double after = 0.0;
            train((uint64_t)seed, units[i], &before, &after);
            print_message("%d units, seed %d: shortfall %.4f -> %.4f\n", (int)units[i], (int)seed, before, after);
            assert_true(after < 0.1 * before);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(noise_free_policy_comes_close_to_the_optimum),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
