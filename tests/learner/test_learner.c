/* The learner of one run: noise schedule, order of draws, both updates, and what it refuses. */
#include "learner_test.h"

#include <twiddle/input_map.h>
#include <twiddle/learner.h>
#include <twiddle/model.h>

/* The paper's settings for `units` parameters and `inputs` inputs. */
static struct twd_learner_config paper_config(size_t units, size_t inputs, uint64_t seed)
{
    const struct twd_learner_config config = {
        .units = units,
        .inputs = inputs,
        .actor_rate = TWD_NUM(0.1),
        .critic_rate = TWD_NUM(0.1),
        .weight_range = TWD_NUM(0.05),
        .clip = TWD_NUM(0.001),
        .noise = {.start = TWD_NUM(0.5), .end = TWD_NUM(0.05), .decay_fraction = TWD_NUM(0.6), .trials = 5000},
        .seed = seed,
    };
    return config;
}

/* The learner of the test in hand; static, since it takes 3 KiB. */
static struct twd_learner learner;

/* The half-range is 0.5 at 0 %, 0.275 at 30 %, 0.05 at 60 % and at 100 % of the training (the paper's schedule, by
 * hand). */
static void noise_follows_the_schedule(void **state)
{
    const struct twd_learner_config config = paper_config(5, 27, 1);
    (void)state;
    assert_num_close(twd_noise_half_range(&config.noise, 0), 0.5, ROUNDING);
    assert_num_close(twd_noise_half_range(&config.noise, 1500), 0.275, ROUNDING);
    assert_num_close(twd_noise_half_range(&config.noise, 2999), 0.05 + 0.45 / 3000.0, ROUNDING);
    assert_num_close(twd_noise_half_range(&config.noise, 3000), 0.05, ROUNDING);
    assert_num_close(twd_noise_half_range(&config.noise, 5000), 0.05, ROUNDING);
    assert_num_close(twd_noise_half_range(&config.noise, UINT32_MAX), 0.05, ROUNDING);
}

enum { UNITS = 5 };

/* The learner's numbers before a trial, as far as the trial needs them. */
struct numbers {
    twd_num actor_weight[UNITS][TWD_INPUTS];
    twd_wide critic_weight[TWD_INPUTS];
    struct twd_random random;
};

static void keep(struct numbers *before)
{
    for (int j = 0; j < UNITS; j++)
        memcpy(before->actor_weight[j], learner.actor.weight[j], sizeof before->actor_weight[j]);
    memcpy(before->critic_weight, learner.critic.weight, sizeof before->critic_weight);
    before->random = learner.random;
}

/* sum_i w_i x_i of eqs. 1 and 6. */
static double activation_of(const twd_num *weight, const twd_num *input)
{
    double sum = 0.0;
    for (int i = 0; i < TWD_INPUTS; i++)
        sum += twd_num_to_double(weight[i]) * twd_num_to_double(input[i]);
    return sum;
}

static double estimate_of(const twd_wide *weight, const twd_num *input)
{
    double sum = 0.0;
    for (int i = 0; i < TWD_INPUTS; i++)
        sum += twd_wide_to_double(weight[i]) * twd_num_to_double(input[i]);
    return sum;
}

/* What the trial has changed, recomputed in double precision from the equations and the generator's bits. */
static void assert_trial(struct numbers *before, const twd_num *input, const twd_num *parameter, double half_range,
                         double td_error)
{
    for (int j = 0; j < UNITS; j++) {
        const double y = 1.0 / (1.0 + exp(-activation_of(before->actor_weight[j], input)));
        const double draw = half_range * ((double)(twd_random_next(&before->random) >> 8) / 8388608.0 - 1.0);
        const double explored = fmin(fmax(y + draw, 0.001), 0.999);
        assert_num_close(parameter[j], explored, ROUNDING);
        for (int i = 0; i < TWD_INPUTS; i++) {
            const double change = 0.1 * td_error * (explored - y) * y * (1.0 - y) * twd_num_to_double(input[i]);
            assert_num_close(learner.actor.weight[j][i], twd_num_to_double(before->actor_weight[j][i]) + change,
                             ROUNDING);
        }
    }
    for (int i = 0; i < TWD_INPUTS; i++) {
        const double change = 0.1 * td_error * twd_num_to_double(input[i]);
        assert_wide_close(learner.critic.weight[i], twd_wide_to_double(before->critic_weight[i]) + change, ROUNDING);
    }
}

/* Over 100 trials with random rewards every parameter, estimate and weight equals eqs. 1 to 8 in double precision. */
static void trials_equal_the_equations_term_by_term(void **state)
{
    const struct twd_learner_config config = paper_config(UNITS, TWD_INPUTS, 11);
    static struct numbers before;
    uint64_t rewards = 12;
    twd_num input[TWD_INPUTS];
    twd_num parameter[TWD_MAX_UNITS];
    (void)state;
    print_message("seed 11 for the learner, 12 for the rewards\n");
    twd_input_map(TWD_SHAPE_CUBE, TWD_NUM(0.032), TWD_WIDE(10), input);
    assert_int_equal(twd_learner_init(&learner, &config), TWD_OK);
    for (int trial = 0; trial < 100; trial++) {
        const twd_wide reward = twd_wide_from_double(uniform(&rewards, -3.0, 3.0));
        const double half_range = 0.5 - 0.45 * trial / 3000.0;
        keep(&before);
        const double value = estimate_of(before.critic_weight, input);
        const double td_error = twd_wide_to_double(reward) - value;
        twd_learner_act(&learner, input, parameter);
        assert_num_close(learner.noise, half_range, ROUNDING);
        assert_wide_close(learner.value, value, ROUNDING);
        assert_wide_close(twd_learner_learn(&learner, reward), td_error, ROUNDING);
        assert_trial(&before, input, parameter, half_range, td_error);
    }
}

/* The generator serves the initial weights, unit by unit, and then one draw a unit and trial, and nothing else. */
static void draws_come_in_the_stated_order(void **state)
{
    const struct twd_learner_config config = paper_config(3, 4, 21);
    const twd_num input[4] = {TWD_NUM(1), TWD_NUM(0), TWD_NUM(0), TWD_NUM(0)};
    twd_num parameter[3];
    struct twd_random random;
    (void)state;
    twd_random_seed(&random, 21);
    assert_int_equal(twd_learner_init(&learner, &config), TWD_OK);
    for (int j = 0; j < 3; j++)
        for (int i = 0; i < 4; i++)
            assert_num_close(learner.actor.weight[j][i],
                             0.05 * ((double)(twd_random_next(&random) >> 8) / 8388608.0 - 1.0), 1e-8);
    twd_learner_act(&learner, input, parameter);
    for (int j = 0; j < 3; j++)
        (void)twd_random_next(&random);
    (void)twd_learner_learn(&learner, TWD_WIDE(1));
    assert_memory_equal(learner.random.state, random.state, sizeof random.state);
}

/* The policy is the sigmoid of the activations without noise, and asking for it draws and changes nothing. */
static void policy_is_noise_free_and_changes_nothing(void **state)
{
    const struct twd_learner_config config = paper_config(2, 2, 31);
    const twd_num input[2] = {TWD_NUM(1), TWD_NUM(-2)};
    twd_num parameter[2];
    (void)state;
    assert_int_equal(twd_learner_init(&learner, &config), TWD_OK);
    twd_learner_act(&learner, input, parameter);
    const uint32_t before = checksum(&learner, sizeof learner);
    twd_learner_policy(&learner, input, parameter);
    assert_int_equal(checksum(&learner, sizeof learner), before);
    for (int j = 0; j < 2; j++) {
        const twd_num *const weight = learner.actor.weight[j];
        const double activation = twd_num_to_double(weight[0]) - 2.0 * twd_num_to_double(weight[1]);
        assert_num_close(parameter[j], 1.0 / (1.0 + exp(-activation)), ROUNDING);
    }
}

/* A checksum of what 200 trials leave: weights, explored values, estimates, the generator. */
static uint32_t run(uint64_t seed)
{
    const struct twd_learner_config config = paper_config(22, TWD_INPUTS, seed);
    twd_num input[TWD_INPUTS];
    twd_num parameter[TWD_MAX_UNITS];
    twd_input_map(TWD_SHAPE_SPHERE, TWD_NUM(0.028), TWD_WIDE(10), input);
    assert_int_equal(twd_learner_init(&learner, &config), TWD_OK);
    for (int trial = 0; trial < 200; trial++) {
        twd_learner_act(&learner, input, parameter);
        (void)twd_learner_learn(&learner, twd_wide_of_num(parameter[0] - parameter[1]));
    }
    return checksum(learner.actor.weight, sizeof learner.actor.weight) ^
           checksum(learner.actor.explored, sizeof learner.actor.explored) * 3U ^
           checksum(learner.critic.weight, sizeof learner.critic.weight) * 5U ^
           checksum(learner.random.state, sizeof learner.random.state) * 7U;
}

/* The same seed and rewards give the same bytes; another seed gives others. */
static void same_seed_gives_the_same_bytes(void **state)
{
    (void)state;
    const uint32_t one = run(41);
    assert_int_equal(run(41), one);
    assert_int_not_equal(run(42), one);
}

enum { RESTORED_UNITS = 4, RESTORED_INPUTS = 6, RESTORED_TRIALS = 30 };

/* A checksum of what the coming trials explore and of what they leave. */
static uint32_t go_on(const twd_num *input)
{
    twd_num parameter[RESTORED_UNITS];
    uint32_t sum = 0;
    for (int trial = 0; trial < RESTORED_TRIALS; trial++) {
        twd_learner_act(&learner, input, parameter);
        sum = sum * 31U + checksum(parameter, sizeof parameter);
        (void)twd_learner_learn(&learner, twd_wide_of_num(parameter[0] - parameter[1]));
    }
    return sum * 31U + checksum(&learner, sizeof learner);
}

/* A learner made of what another has come to goes on as that one did, to the byte: here half way through the noise's
 * decay. */
static void restored_learner_goes_on_as_the_one_it_was(void **state)
{
    static const twd_num input[RESTORED_INPUTS] = {TWD_NUM(1),  TWD_NUM(0.5), TWD_NUM(0),
                                                   TWD_NUM(-1), TWD_NUM(0),   TWD_NUM(2)};
    static twd_num actor_weight[RESTORED_UNITS][RESTORED_INPUTS];
    static twd_wide critic_weight[RESTORED_INPUTS];
    struct twd_learner_config config = paper_config(RESTORED_UNITS, RESTORED_INPUTS, 71);
    config.noise.trials = 4 * RESTORED_TRIALS;
    (void)state;
    memset(&learner, 0, sizeof learner); /* padding counts as well */
    assert_int_equal(twd_learner_init(&learner, &config), TWD_OK);
    (void)go_on(input);
    for (int j = 0; j < RESTORED_UNITS; j++)
        memcpy(actor_weight[j], learner.actor.weight[j], sizeof actor_weight[j]);
    memcpy(critic_weight, learner.critic.weight, sizeof critic_weight);
    const struct twd_learner_snapshot snapshot = {config,          learner.random, learner.trial,
                                                  actor_weight[0], critic_weight,  input};
    const uint32_t expected = go_on(input);

    memset(&learner, 0, sizeof learner);
    assert_int_equal(twd_learner_restore(&learner, &snapshot), TWD_OK);
    assert_int_equal(learner.trial, RESTORED_TRIALS);
    assert_int_equal(go_on(learner.input), expected);
}

/* Tables that are missing, a generator that would give 0 for ever, and what init refuses: the learner stays as it
 * was. */
static void restore_errors_leave_the_learner_as_it_was(void **state)
{
    static const twd_num numbers[1] = {TWD_NUM(0.5)};
    static const twd_wide value[1] = {TWD_WIDE(0.5)};
    const struct twd_learner_snapshot good = {paper_config(1, 1, 1), {{0, 0, 0, 1}}, 10, numbers, value, numbers};
    (void)state;
    mark(&learner, sizeof learner);
#define REFUSED(field, value, error)                                                                                   \
    do {                                                                                                               \
        struct twd_learner_snapshot wrong = good;                                                                      \
        wrong.field = (value);                                                                                         \
        assert_int_equal(twd_learner_restore(&learner, &wrong), (error));                                              \
    } while (0)
    REFUSED(actor_weight, NULL, TWD_ERROR_NULL);
    REFUSED(critic_weight, NULL, TWD_ERROR_NULL);
    REFUSED(input, NULL, TWD_ERROR_NULL);
    REFUSED(random.state[3], 0, TWD_ERROR_RANGE);
    REFUSED(config.units, TWD_MAX_UNITS + 1, TWD_ERROR_LEARNER_SIZE);
    REFUSED(config.clip, TWD_NUM(0.5), TWD_ERROR_RANGE);
#undef REFUSED
    assert_marked(&learner, sizeof learner);
    assert_int_equal(twd_learner_restore(&learner, &good), TWD_OK);
}

/* A reward that is not a number or is infinite counts as 0: the TD error is minus the estimate, and every weight stays
 * a number. */
static void a_reward_that_is_not_finite_counts_as_zero(void **state)
{
    static const double rewards[] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    const struct twd_learner_config config = paper_config(4, 2, 51);
    const twd_num input[2] = {TWD_NUM(1), TWD_NUM(1)};
    twd_num parameter[4];
    (void)state;
    assert_int_equal(twd_learner_init(&learner, &config), TWD_OK);
    for (int trial = 0; trial < 30; trial++) {
        twd_learner_act(&learner, input, parameter);
        (void)twd_learner_learn(&learner, TWD_WIDE(2));
        twd_learner_act(&learner, input, parameter);
        const double value = twd_wide_to_double(learner.value);
        assert_wide_close(twd_learner_learn(&learner, twd_wide_from_double(rewards[trial % 3])), -value, ROUNDING);
    }
    for (int i = 0; i < 2; i++) {
        assert_true(twd_wide_is_usable(learner.critic.weight[i]));
        for (int j = 0; j < 4; j++)
            assert_true(twd_is_usable(learner.actor.weight[j][i]));
    }
}

/* However large the rewards, and though they alternate, what acts stays in [clip, 1 - clip], also after 200 trials. */
static void huge_rewards_leave_the_parameters_in_their_range(void **state)
{
    static const double rewards[] = {9e5, -9e5, -9e5, 120.0, 9e5};
    const struct twd_learner_config config = paper_config(UNITS, TWD_INPUTS, 52);
    twd_num input[TWD_INPUTS], parameter[UNITS];
    (void)state;
    twd_input_map(TWD_SHAPE_SPHERE, TWD_NUM(0.028), TWD_WIDE(100), input);
    assert_int_equal(twd_learner_init(&learner, &config), TWD_OK);
    for (int trial = 0; trial < 200; trial++) {
        twd_learner_act(&learner, input, parameter);
        for (int j = 0; j < UNITS; j++)
            assert_true(twd_within(parameter[j], config.clip, TWD_NUM(1) - config.clip));
        (void)twd_learner_learn(&learner, twd_wide_from_double(rewards[trial % 5]));
    }
}

/* For each model with and without centre a learner has as many units as the paper's model has parameters. */
static void unit_counts_are_the_papers(void **state)
{
    static const struct {
        const struct twd_model *model;
        size_t with_centre;
        size_t without_centre;
    } models[] = {{&twd_model_s, 2, 1}, {&twd_model_m, 5, 3}, {&twd_model_c, 12, 8}, {&twd_model_h, 22, 15}};
    (void)state;
    for (size_t i = 0; i < 4; i++) {
        for (int centre = 0; centre < 2; centre++) {
            const size_t units = twd_model_parameters(models[i].model, centre == 1);
            const struct twd_learner_config config = paper_config(units, TWD_INPUTS, 61);
            assert_int_equal(units, centre == 1 ? models[i].with_centre : models[i].without_centre);
            assert_int_equal(twd_learner_init(&learner, &config), TWD_OK);
            assert_int_equal(learner.actor.units, units);
        }
    }
}

/* CPG-H's selector weights, decoded from what the learner explores, are y_k / sum(y) of the last three parameters (eq.
 * 4) and sum to 1 in every trial, with and without centre. */
static void selector_weights_sum_to_one(void **state)
{
    const struct twd_parameter_ranges ranges = {
        .frequency_lower_hz = TWD_NUM(0.3),
        .frequency_upper_hz = TWD_NUM(1.2),
        .lone_frequency_hz = TWD_NUM(1),
        .amplitude_upper = TWD_NUM(0.5),
        .centre_lower = TWD_NUM(0),
        .centre_upper = TWD_NUM(1),
    };
    (void)state;
    for (int centre = 0; centre < 2; centre++) {
        const size_t units = twd_model_parameters(&twd_model_h, centre == 1);
        const struct twd_learner_config config = paper_config(units, TWD_INPUTS, 71);
        twd_num input[TWD_INPUTS];
        twd_num parameter[TWD_MAX_UNITS];
        struct twd_model_drive drive;
        twd_input_map(TWD_SHAPE_SPHERE, TWD_NUM(0.036), TWD_WIDE(10), input);
        assert_int_equal(twd_learner_init(&learner, &config), TWD_OK);
        for (int trial = 0; trial < 200; trial++) {
            twd_learner_act(&learner, input, parameter);
            assert_int_equal(twd_model_decode(&twd_model_h, centre == 1, &ranges, parameter, units, &drive), TWD_OK);
            const twd_num *const y = parameter + units - 3;
            const double sum = twd_num_to_double(y[0]) + twd_num_to_double(y[1]) + twd_num_to_double(y[2]);
            for (int k = 0; k < 3; k++)
                assert_num_close(drive.weight[k], twd_num_to_double(y[k]) / sum, ROUNDING);
            assert_num_close(drive.weight[0] + drive.weight[1] + drive.weight[2], 1.0, 1e-6);
            (void)twd_learner_learn(&learner, twd_wide_of_num(parameter[0]));
        }
    }
}

/* Each wrong field is refused with its error, and the learner stays as it was. */
static void init_errors_leave_the_learner_as_it_was(void **state)
{
    const struct twd_learner_config good = paper_config(5, 27, 81);
    (void)state;
    mark(&learner, sizeof learner);
#define REFUSED(field, value, error)                                                                                   \
    do {                                                                                                               \
        struct twd_learner_config wrong = good;                                                                        \
        wrong.field = (value);                                                                                         \
        assert_int_equal(twd_learner_init(&learner, &wrong), (error));                                                 \
    } while (0)
    REFUSED(units, 0, TWD_ERROR_LEARNER_SIZE);
    REFUSED(units, TWD_MAX_UNITS + 1, TWD_ERROR_LEARNER_SIZE);
    REFUSED(inputs, 0, TWD_ERROR_LEARNER_SIZE);
    REFUSED(inputs, TWD_MAX_INPUTS + 1, TWD_ERROR_LEARNER_SIZE);
    REFUSED(actor_rate, TWD_NUM(-0.1), TWD_ERROR_RANGE);
    REFUSED(critic_rate, twd_num_from_double((double)NAN), TWD_ERROR_RANGE);
    REFUSED(weight_range, TWD_NUM(2), TWD_ERROR_RANGE);
    REFUSED(clip, TWD_NUM(0.5), TWD_ERROR_RANGE);
    REFUSED(noise.start, twd_num_from_double((double)INFINITY), TWD_ERROR_RANGE);
    REFUSED(noise.end, TWD_NUM(-0.1), TWD_ERROR_RANGE);
    REFUSED(noise.decay_fraction, TWD_NUM(0), TWD_ERROR_RANGE);
    REFUSED(noise.trials, 0, TWD_ERROR_RANGE);
    REFUSED(noise.trials, UINT32_C(0x80000000), TWD_ERROR_RANGE);
    REFUSED(silent_units, 6, TWD_ERROR_RANGE);
    REFUSED(learned_value, (enum twd_learned_value)2, TWD_ERROR_RANGE);
#undef REFUSED
    assert_marked(&learner, sizeof learner);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(noise_follows_the_schedule),
        cmocka_unit_test(trials_equal_the_equations_term_by_term),
        cmocka_unit_test(draws_come_in_the_stated_order),
        cmocka_unit_test(policy_is_noise_free_and_changes_nothing),
        cmocka_unit_test(same_seed_gives_the_same_bytes),
        cmocka_unit_test(restored_learner_goes_on_as_the_one_it_was),
        cmocka_unit_test(restore_errors_leave_the_learner_as_it_was),
        cmocka_unit_test(a_reward_that_is_not_finite_counts_as_zero),
        cmocka_unit_test(huge_rewards_leave_the_parameters_in_their_range),
        cmocka_unit_test(unit_counts_are_the_papers),
        cmocka_unit_test(selector_weights_sum_to_one),
        cmocka_unit_test(init_errors_leave_the_learner_as_it_was),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
