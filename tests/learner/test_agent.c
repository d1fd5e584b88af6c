/* The learner of one run: noise schedule, order of draws, both updates, and what it refuses. */
#include "learner_test.h"

#include <string.h>

#include <twiddle/agent.h>
#include <twiddle/input_map.h>
#include <twiddle/model.h>

/* The paper's settings for `units` parameters and `inputs` inputs. */
static struct twd_agent_config paper_config(size_t units, size_t inputs, uint64_t seed)
{
    const struct twd_agent_config config = {
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

/* The half-range is 0.5 at 0 %, 0.275 at 30 %, 0.05 at 60 % and at 100 % of the training (the paper's schedule, by hand). */
static void noise_follows_the_schedule(void **state)
{
    const struct twd_agent_config config = paper_config(5, 27, 1);
    (void)state;
    assert_close(twd_noise_half_range(&config.noise, 0), 0.5, ROUNDING);
    assert_close(twd_noise_half_range(&config.noise, 1500), 0.275, ROUNDING);
    assert_close(twd_noise_half_range(&config.noise, 2999), 0.05 + 0.45 / 3000.0, ROUNDING);
    assert_close(twd_noise_half_range(&config.noise, 3000), 0.05, ROUNDING);
    assert_close(twd_noise_half_range(&config.noise, 5000), 0.05, ROUNDING);
    assert_close(twd_noise_half_range(&config.noise, UINT32_MAX), 0.05, ROUNDING);
}

/* What one trial must change, recomputed in double precision from the equations and the generator's bits. */
struct expected_trial {
    double explored[TWD_MAX_UNITS];
    double actor_weight[TWD_MAX_UNITS][TWD_MAX_INPUTS];
    double critic_weight[TWD_MAX_INPUTS];
    double value;
};

static struct expected_trial expect_trial(const struct twd_agent *agent, const twd_num *input, double half_range,
                                          double reward)
{
    struct expected_trial expected = {.value = 0.0};
    struct twd_random random = agent->random;
    for (size_t i = 0; i < agent->config.inputs; i++)
        expected.value += (double)agent->critic.weight[i] * (double)input[i];
    const double td_error = reward - expected.value;
    for (size_t i = 0; i < agent->config.inputs; i++)
        expected.critic_weight[i] = (double)agent->critic.weight[i] + 0.1 * td_error * (double)input[i];
    for (size_t j = 0; j < agent->config.units; j++) {
        double activation = 0.0;
        for (size_t i = 0; i < agent->config.inputs; i++)
            activation += (double)agent->actor.weight[j][i] * (double)input[i];
        const double y = 1.0 / (1.0 + exp(-activation));
        const double draw = half_range * ((double)(twd_random_next(&random) >> 8) / 8388608.0 - 1.0);
        expected.explored[j] = fmin(fmax(y + draw, 0.001), 0.999);
        for (size_t i = 0; i < agent->config.inputs; i++)
            expected.actor_weight[j][i] = (double)agent->actor.weight[j][i] + 0.1 * td_error *
                                                                                  (expected.explored[j] - y) * y *
                                                                                  (1.0 - y) * (double)input[i];
    }
    return expected;
}

/* Over 100 trials with random rewards every parameter, estimate and weight equals eqs. 1 to 8 in double precision. */
static void trials_equal_the_equations_term_by_term(void **state)
{
    const struct twd_agent_config config = paper_config(5, TWD_INPUTS, 11);
    struct twd_agent agent;
    struct twd_random rewards;
    twd_num input[TWD_INPUTS];
    twd_num parameter[TWD_MAX_UNITS];
    (void)state;
    print_message("seed 11 for the agent, 12 for the rewards\n");
    twd_random_seed(&rewards, 12);
    twd_input_map(TWD_SHAPE_CUBE, TWD_NUM(0.032), TWD_NUM(10), input);
    assert_int_equal(twd_agent_init(&agent, &config), TWD_OK);
    for (uint32_t trial = 0; trial < 100; trial++) {
        const twd_num reward = twd_random_symmetric(&rewards, TWD_NUM(3));
        const double half_range = 0.5 - 0.45 * trial / 3000.0;
        const struct expected_trial expected = expect_trial(&agent, input, half_range, (double)reward);
        twd_agent_act(&agent, input, parameter);
        assert_close(agent.noise, half_range, ROUNDING);
        assert_close(agent.value, expected.value, ROUNDING);
        assert_close(twd_agent_learn(&agent, reward), (double)reward - expected.value, ROUNDING);
        assert_int_equal(agent.trial, trial + 1);
        for (size_t j = 0; j < config.units; j++) {
            assert_close(parameter[j], expected.explored[j], ROUNDING);
            for (size_t i = 0; i < config.inputs; i++)
                assert_close(agent.actor.weight[j][i], expected.actor_weight[j][i], ROUNDING);
        }
        for (size_t i = 0; i < config.inputs; i++)
            assert_close(agent.critic.weight[i], expected.critic_weight[i], ROUNDING);
    }
}

/* The generator serves the initial weights, unit by unit, and then one draw a unit and trial, and nothing else. */
static void draws_come_in_the_stated_order(void **state)
{
    const struct twd_agent_config config = paper_config(3, 4, 21);
    const twd_num input[4] = {TWD_NUM(1), TWD_NUM(0), TWD_NUM(0), TWD_NUM(0)};
    twd_num parameter[3];
    struct twd_agent agent;
    struct twd_random random;
    (void)state;
    twd_random_seed(&random, 21);
    assert_int_equal(twd_agent_init(&agent, &config), TWD_OK);
    for (int j = 0; j < 3; j++)
        for (int i = 0; i < 4; i++)
            assert_close(agent.actor.weight[j][i], 0.05 * ((double)(twd_random_next(&random) >> 8) / 8388608.0 - 1.0),
                         1e-8);
    twd_agent_act(&agent, input, parameter);
    for (int j = 0; j < 3; j++)
        (void)twd_random_next(&random);
    (void)twd_agent_learn(&agent, TWD_NUM(1));
    assert_memory_equal(agent.random.state, random.state, sizeof random.state);
}

/* The policy is the sigmoid of the activations without noise, and asking for it draws and changes nothing. */
static void policy_is_noise_free_and_changes_nothing(void **state)
{
    const struct twd_agent_config config = paper_config(2, 2, 31);
    const twd_num input[2] = {TWD_NUM(1), TWD_NUM(-2)};
    twd_num parameter[2];
    struct twd_agent agent;
    (void)state;
    assert_int_equal(twd_agent_init(&agent, &config), TWD_OK);
    twd_agent_act(&agent, input, parameter);
    const struct twd_agent before = agent;
    twd_agent_policy(&agent, input, parameter);
    for (int j = 0; j < 2; j++) {
        const double activation = (double)agent.actor.weight[j][0] - 2.0 * (double)agent.actor.weight[j][1];
        assert_close(parameter[j], 1.0 / (1.0 + exp(-activation)), ROUNDING);
    }
    assert_memory_equal(agent.actor.weight, before.actor.weight, sizeof before.actor.weight);
    assert_memory_equal(agent.actor.output, before.actor.output, sizeof before.actor.output);
    assert_memory_equal(agent.actor.explored, before.actor.explored, sizeof before.actor.explored);
    assert_memory_equal(agent.random.state, before.random.state, sizeof before.random.state);
    assert_int_equal(agent.trial, before.trial);
}

static void run(struct twd_agent *agent, uint64_t seed)
{
    const struct twd_agent_config config = paper_config(22, TWD_INPUTS, seed);
    twd_num input[TWD_INPUTS];
    twd_num parameter[TWD_MAX_UNITS];
    twd_input_map(TWD_SHAPE_SPHERE, TWD_NUM(0.028), TWD_NUM(10), input);
    assert_int_equal(twd_agent_init(agent, &config), TWD_OK);
    for (int trial = 0; trial < 200; trial++) {
        twd_agent_act(agent, input, parameter);
        (void)twd_agent_learn(agent, parameter[0] - parameter[1]);
    }
}

/* The same seed and rewards give the same bytes; another seed gives others. */
static void same_seed_gives_the_same_bytes(void **state)
{
    struct twd_agent one;
    struct twd_agent again;
    struct twd_agent other;
    (void)state;
    run(&one, 41);
    run(&again, 41);
    run(&other, 42);
    assert_memory_equal(one.actor.weight, again.actor.weight, sizeof one.actor.weight);
    assert_memory_equal(one.actor.explored, again.actor.explored, sizeof one.actor.explored);
    assert_memory_equal(one.critic.weight, again.critic.weight, sizeof one.critic.weight);
    assert_memory_not_equal(one.actor.weight, other.actor.weight, sizeof one.actor.weight);
}

/* A reward that is not a number or is infinite counts as 0: the TD error is minus the estimate, and every weight stays finite. */
static void a_reward_that_is_not_finite_counts_as_zero(void **state)
{
    static const double rewards[] = {NAN, INFINITY, -INFINITY};
    const struct twd_agent_config config = paper_config(4, 2, 51);
    const twd_num input[2] = {TWD_NUM(1), TWD_NUM(1)};
    twd_num parameter[4];
    struct twd_agent agent;
    (void)state;
    assert_int_equal(twd_agent_init(&agent, &config), TWD_OK);
    for (int trial = 0; trial < 30; trial++) {
        twd_agent_act(&agent, input, parameter);
        (void)twd_agent_learn(&agent, TWD_NUM(2));
        twd_agent_act(&agent, input, parameter);
        assert_close(twd_agent_learn(&agent, (twd_num)rewards[trial % 3]), -(double)agent.value, ROUNDING);
    }
    for (int i = 0; i < 2; i++) {
        assert_true(isfinite(agent.critic.weight[i]));
        for (int j = 0; j < 4; j++)
            assert_true(isfinite(agent.actor.weight[j][i]));
    }
}

/* For each model with and without centre an agent has as many units as the paper's model has parameters. */
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
            const struct twd_agent_config config = paper_config(units, TWD_INPUTS, 61);
            struct twd_agent agent;
            assert_int_equal(units, centre == 1 ? models[i].with_centre : models[i].without_centre);
            assert_int_equal(twd_agent_init(&agent, &config), TWD_OK);
            assert_int_equal(agent.actor.units, units);
        }
    }
}

/* CPG-H's selector weights, decoded from what the agent explores, are y_k / sum(y) of the last three parameters (eq. 4) and sum
 * to 1 in every trial, with and without centre. */
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
        const struct twd_agent_config config = paper_config(units, TWD_INPUTS, 71);
        twd_num input[TWD_INPUTS];
        twd_num parameter[TWD_MAX_UNITS];
        struct twd_agent agent;
        struct twd_model_drive drive;
        twd_input_map(TWD_SHAPE_SPHERE, TWD_NUM(0.036), TWD_NUM(10), input);
        assert_int_equal(twd_agent_init(&agent, &config), TWD_OK);
        for (int trial = 0; trial < 200; trial++) {
            twd_agent_act(&agent, input, parameter);
            assert_int_equal(twd_model_decode(&twd_model_h, centre == 1, &ranges, parameter, units, &drive), TWD_OK);
            const twd_num *const y = parameter + units - 3;
            const double sum = (double)y[0] + (double)y[1] + (double)y[2];
            for (int k = 0; k < 3; k++)
                assert_close(drive.weight[k], (double)y[k] / sum, ROUNDING);
            assert_close(drive.weight[0] + drive.weight[1] + drive.weight[2], 1.0, 1e-6);
            (void)twd_agent_learn(&agent, parameter[0]);
        }
    }
}

/* Each wrong field is refused with its error, and the agent stays as it was. */
static void init_errors_leave_the_agent_as_it_was(void **state)
{
    const struct twd_agent_config good = paper_config(5, 27, 81);
    struct twd_agent_config wrong[14];
    struct twd_agent agent;
    (void)state;
    for (size_t i = 0; i < 14; i++)
        wrong[i] = good;
    wrong[0].units = 0;
    wrong[1].units = TWD_MAX_UNITS + 1;
    wrong[2].inputs = 0;
    wrong[3].inputs = TWD_MAX_INPUTS + 1;
    wrong[4].actor_rate = TWD_NUM(-0.1);
    wrong[5].critic_rate = (twd_num)NAN;
    wrong[6].weight_range = TWD_NUM(2);
    wrong[7].clip = TWD_NUM(0.5);
    wrong[8].noise.start = (twd_num)INFINITY;
    wrong[9].noise.end = TWD_NUM(-0.1);
    wrong[10].noise.decay_fraction = TWD_NUM(0);
    wrong[11].noise.trials = 0;
    wrong[12].silent_units = 6;
    wrong[13].learned_value = (enum twd_learned_value)2;
    assert_int_equal(twd_agent_init(&agent, &good), TWD_OK);
    struct twd_agent before;
    memcpy(&before, &agent, sizeof before);
    for (size_t i = 0; i < 14; i++) {
        assert_int_equal(twd_agent_init(&agent, &wrong[i]), i < 4 ? TWD_ERROR_LEARNER_SIZE : TWD_ERROR_RANGE);
        assert_memory_equal(&agent, &before, sizeof before);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(noise_follows_the_schedule),
        cmocka_unit_test(trials_equal_the_equations_term_by_term),
        cmocka_unit_test(draws_come_in_the_stated_order),
        cmocka_unit_test(policy_is_noise_free_and_changes_nothing),
        cmocka_unit_test(same_seed_gives_the_same_bytes),
        cmocka_unit_test(a_reward_that_is_not_finite_counts_as_zero),
        cmocka_unit_test(unit_counts_are_the_papers),
        cmocka_unit_test(selector_weights_sum_to_one),
        cmocka_unit_test(init_errors_leave_the_agent_as_it_was),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
