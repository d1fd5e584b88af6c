/* The layer of exploring sigmoid units, on cases worked by hand or in double precision. */
#include "learner_test.h"

#include <twiddle/actor.h>

/* A layer of 2 units and 3 inputs with chosen weights. */
static struct twd_actor small_layer(void)
{
    static const double weights[2][3] = {{0.5, -0.25, 1.0}, {-1.5, 0.75, 0.125}};
    struct twd_random random;
    struct twd_actor actor;
    twd_random_seed(&random, 1);
    assert_int_equal(twd_actor_init(&actor, 2, 3, TWD_NUM(0), &random), TWD_OK);
    for (int j = 0; j < 2; j++)
        for (int i = 0; i < 3; i++)
            actor.weight[j][i] = TWD_NUM(weights[j][i]);
    return actor;
}

static const twd_num input[3] = {TWD_NUM(1), TWD_NUM(2), TWD_NUM(-0.5)};

/* Eqs. 1 and 2 by hand: PA = 0.5 - 0.5 - 0.5 = -0.5 and -1.5 + 1.5 - 0.0625 = -0.0625, so that
 * y = 1 / (1 + e^0.5) = 0.3775406688 and 1 / (1 + e^0.0625) = 0.4843800842. */
static void outputs_equal_the_worked_example(void **state)
{
    struct twd_actor actor = small_layer();
    (void)state;
    twd_actor_activate(&actor, input);
    assert_close(actor.output[0], 0.3775406688, ROUNDING);
    assert_close(actor.output[1], 0.4843800842, ROUNDING);
    assert_close(twd_actor_unit(&actor, 1, input), 0.4843800842, ROUNDING);
}

/* Eq. 8 term by term: w + eta S (y^N - y) y (1 - y) x with eta = 0.1 and S = 1.5, y from libm, y^N set by hand. */
static void weight_updates_equal_the_equation_term_by_term(void **state)
{
    static const double activation[] = {-0.5, -0.0625};
    static const double explored[] = {0.6, 0.1};
    static const double x[] = {1.0, 2.0, -0.5};
    struct twd_actor actor = small_layer();
    const struct twd_actor before = actor;
    (void)state;
    twd_actor_activate(&actor, input);
    for (int j = 0; j < 2; j++)
        actor.learned_value[j] = TWD_NUM(explored[j]);
    twd_actor_learn(&actor, input, TWD_NUM(0.1), TWD_NUM(1.5));
    for (int j = 0; j < 2; j++) {
        const double y = 1.0 / (1.0 + exp(-activation[j]));
        for (int i = 0; i < 3; i++) {
            const double change = 0.1 * 1.5 * (explored[j] - y) * y * (1.0 - y) * x[i];
            assert_close(actor.weight[j][i], (double)before.weight[j][i] + change, ROUNDING);
        }
    }
}

/* The first unit's change by hand: 0.15 x (0.6 - 0.3775406688) x 0.3775406688 x 0.6224593312 = 0.0078418, times x = 1, 2, -0.5. */
static void weight_updates_equal_the_worked_example(void **state)
{
    struct twd_actor actor = small_layer();
    (void)state;
    twd_actor_activate(&actor, input);
    actor.learned_value[0] = TWD_NUM(0.6);
    twd_actor_learn(&actor, input, TWD_NUM(0.1), TWD_NUM(1.5));
    assert_close(actor.weight[0][0], 0.5 + 0.0078418, 1e-6);
    assert_close(actor.weight[0][1], -0.25 + 0.0156836, 1e-6);
    assert_close(actor.weight[0][2], 1.0 - 0.0039209, 1e-6);
}

/* Exploration adds one draw a unit, in order, from [-h, h): the draws are repeated here from a copy of the generator. */
static void exploration_adds_one_draw_a_unit_in_order(void **state)
{
    const struct twd_exploration exploration = {.half_range = TWD_NUM(0.25), .clip = TWD_NUM(0.001)};
    struct twd_actor actor = small_layer();
    struct twd_random random;
    (void)state;
    twd_random_seed(&random, 7);
    struct twd_random copy = random;
    twd_actor_activate(&actor, input);
    twd_actor_explore(&actor, &exploration, &random);
    for (int j = 0; j < 2; j++) {
        const double draw = 0.25 * ((double)(twd_random_next(&copy) >> 8) / 8388608.0 - 1.0);
        assert_close(actor.explored[j], (double)actor.output[j] + draw, 1e-7);
    }
    assert_memory_equal(random.state, copy.state, sizeof copy.state);
}

/* Exploration that would leave [clip, 1 - clip] stops at its ends, and the update uses the stopped value, or the one asked for: with
 * weights for y = 1 / (1 + e^-2) = 0.8807970780, dw = eta S (y^N - y) y (1 - y) x, where y^N is at most 0.999, or what the draw
 * gives. */
static void learned_value_is_clipped_or_not(enum twd_learned_value learned_value)
{
    const struct twd_exploration exploration = {
        .half_range = TWD_NUM(0.5), .clip = TWD_NUM(0.001), .learned_value = learned_value};
    const twd_num one[] = {TWD_NUM(1)};
    const double y = 1.0 / (1.0 + exp(-2.0));
    int clipped = 0;
    struct twd_random random;
    twd_random_seed(&random, 3);
    for (int trial = 0; trial < 100; trial++) {
        struct twd_actor actor;
        assert_int_equal(twd_actor_init(&actor, 1, 1, TWD_NUM(0), &random), TWD_OK);
        actor.weight[0][0] = TWD_NUM(2);
        twd_actor_activate(&actor, one);
        struct twd_random repeat = random;
        twd_actor_explore(&actor, &exploration, &random);
        const double asked = y + 0.5 * ((double)(twd_random_next(&repeat) >> 8) / 8388608.0 - 1.0);
        const double acted = asked > 0.999 ? 0.999 : asked;
        const double learned = learned_value == TWD_LEARN_FROM_CLIPPED ? acted : asked;
        clipped += asked > 0.999;
        assert_close(actor.explored[0], acted, ROUNDING);
        twd_actor_learn(&actor, one, TWD_NUM(0.1), TWD_NUM(1));
        assert_close(actor.weight[0][0], 2.0 + 0.1 * (learned - y) * y * (1.0 - y), ROUNDING);
    }
    assert_in_range(clipped, 20, 60); /* (0.5 - 0.118) of 1.0: about 38 of 100 */
}

static void clipped_value_acts_and_is_learned_from(void **state)
{
    (void)state;
    learned_value_is_clipped_or_not(TWD_LEARN_FROM_CLIPPED);
}

static void clipped_value_acts_and_the_unclipped_is_learned_from(void **state)
{
    (void)state;
    learned_value_is_clipped_or_not(TWD_LEARN_FROM_UNCLIPPED);
}

/* Silent units act on their outputs and keep their weights; the others draw and learn as without them. */
static void silent_units_neither_explore_nor_learn(void **state)
{
    const struct twd_exploration all = {.half_range = TWD_NUM(0.25), .clip = TWD_NUM(0.001)};
    struct twd_exploration first = all;
    first.silent_units = 1;
    struct twd_actor exploring = small_layer(), silent = small_layer();
    const struct twd_actor before = silent;
    struct twd_random random, copy;
    (void)state;
    twd_random_seed(&random, 9);
    copy = random;
    twd_actor_activate(&exploring, input);
    twd_actor_explore(&exploring, &all, &random);
    twd_actor_learn(&exploring, input, TWD_NUM(0.1), TWD_NUM(1.5));
    twd_actor_activate(&silent, input);
    twd_actor_explore(&silent, &first, &copy);
    twd_actor_learn(&silent, input, TWD_NUM(0.1), TWD_NUM(1.5));
    assert_memory_equal(copy.state, random.state, sizeof copy.state);
    assert_close(silent.explored[0], (double)exploring.explored[0], 0.0);
    assert_memory_equal(silent.weight[0], exploring.weight[0], sizeof silent.weight[0]);
    assert_close(silent.explored[1], (double)silent.output[1], 0.0);
    assert_memory_equal(silent.weight[1], before.weight[1], sizeof silent.weight[1]);
}

/* Initial weights lie in [-range, range), differ, and what no unit or input uses is 0. */
static void initial_weights_fill_their_range(void **state)
{
    double largest = 0.0;
    struct twd_random random;
    struct twd_actor actor;
    (void)state;
    twd_random_seed(&random, 5);
    assert_int_equal(twd_actor_init(&actor, 20, 20, TWD_NUM(0.05), &random), TWD_OK);
    for (size_t j = 0; j < TWD_MAX_UNITS; j++) {
        for (size_t i = 0; i < TWD_MAX_INPUTS; i++) {
            const double weight = fabs((double)actor.weight[j][i]);
            if (j < 20 && i < 20)
                largest = weight > largest ? weight : largest;
            else
                assert_true(weight <= 0.0);
        }
    }
    assert_true(largest > 0.045 && largest <= 0.05 + 1e-9);
}

/* Wrong sizes and ranges are refused before anything is written or drawn. */
static void init_errors_leave_layer_and_generator_as_they_were(void **state)
{
    struct twd_actor actor = small_layer();
    struct twd_random random;
    (void)state;
    twd_random_seed(&random, 9);
    const struct twd_actor before = actor;
    const struct twd_random random_before = random;
    assert_int_equal(twd_actor_init(&actor, 0, 3, TWD_NUM(0.1), &random), TWD_ERROR_LEARNER_SIZE);
    assert_int_equal(twd_actor_init(&actor, TWD_MAX_UNITS + 1, 3, TWD_NUM(0.1), &random), TWD_ERROR_LEARNER_SIZE);
    assert_int_equal(twd_actor_init(&actor, 2, 0, TWD_NUM(0.1), &random), TWD_ERROR_LEARNER_SIZE);
    assert_int_equal(twd_actor_init(&actor, 2, TWD_MAX_INPUTS + 1, TWD_NUM(0.1), &random), TWD_ERROR_LEARNER_SIZE);
    assert_int_equal(twd_actor_init(&actor, 2, 3, TWD_NUM(-0.1), &random), TWD_ERROR_RANGE);
    assert_int_equal(twd_actor_init(&actor, 2, 3, (twd_num)NAN, &random), TWD_ERROR_RANGE);
    assert_int_equal(actor.units, before.units);
    assert_int_equal(actor.inputs, before.inputs);
    assert_memory_equal(actor.weight, before.weight, sizeof before.weight);
    assert_memory_equal(random.state, random_before.state, sizeof random.state);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(outputs_equal_the_worked_example),
        cmocka_unit_test(weight_updates_equal_the_equation_term_by_term),
        cmocka_unit_test(weight_updates_equal_the_worked_example),
        cmocka_unit_test(exploration_adds_one_draw_a_unit_in_order),
        cmocka_unit_test(clipped_value_acts_and_is_learned_from),
        cmocka_unit_test(clipped_value_acts_and_the_unclipped_is_learned_from),
        cmocka_unit_test(silent_units_neither_explore_nor_learn),
        cmocka_unit_test(initial_weights_fill_their_range),
        cmocka_unit_test(init_errors_leave_layer_and_generator_as_they_were),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
