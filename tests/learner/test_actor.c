/* The layer of exploring sigmoid units, on cases worked by hand or in double precision. */
#include "learner_test.h"

#include <twiddle/actor.h>

/* The layer of the test in hand, and a second one; static, since each takes 3 KiB. */
static struct twd_actor actor, other;

/* Make a layer of 2 units and 3 inputs with chosen weights. */
static void make_small_layer(struct twd_actor *layer)
{
    static const double weights[2][3] = {{0.5, -0.25, 1.0}, {-1.5, 0.75, 0.125}};
    struct twd_random random;
    twd_random_seed(&random, 1);
    assert_int_equal(twd_actor_init(layer, 2, 3, TWD_NUM(0), &random), TWD_OK);
    for (int j = 0; j < 2; j++)
        for (int i = 0; i < 3; i++)
            layer->weight[j][i] = twd_num_from_double(weights[j][i]);
}

static const twd_num input[3] = {TWD_NUM(1), TWD_NUM(2), TWD_NUM(-0.5)};

/* Eqs. 1 and 2 by hand: PA = 0.5 - 0.5 - 0.5 = -0.5 and -1.5 + 1.5 - 0.0625 = -0.0625, so that
 * y = 1 / (1 + e^0.5) = 0.3775406688 and 1 / (1 + e^0.0625) = 0.4843800842. */
static void outputs_equal_the_worked_example(void **state)
{
    (void)state;
    make_small_layer(&actor);
    twd_actor_activate(&actor, input);
    assert_num_close(actor.output[0], 0.3775406688, ROUNDING);
    assert_num_close(actor.output[1], 0.4843800842, ROUNDING);
    assert_num_close(twd_actor_unit(&actor, 1, input), 0.4843800842, ROUNDING);
}

/* Eq. 8 term by term: w + eta S (y^N - y) y (1 - y) x with eta = 0.1 and S = 1.5, y from libm, y^N set by hand. */
static void weight_updates_equal_the_equation_term_by_term(void **state)
{
    static const double activation[] = {-0.5, -0.0625};
    static const double explored[] = {0.6, 0.1};
    static const double x[] = {1.0, 2.0, -0.5};
    (void)state;
    make_small_layer(&actor);
    make_small_layer(&other); /* as it was before */
    twd_actor_activate(&actor, input);
    for (int j = 0; j < 2; j++)
        actor.learned_value[j] = twd_num_from_double(explored[j]);
    twd_actor_learn(&actor, input, TWD_NUM(0.1), TWD_WIDE(1.5));
    for (int j = 0; j < 2; j++) {
        const double y = 1.0 / (1.0 + exp(-activation[j]));
        for (int i = 0; i < 3; i++) {
            const double change = 0.1 * 1.5 * (explored[j] - y) * y * (1.0 - y) * x[i];
            assert_num_close(actor.weight[j][i], twd_num_to_double(other.weight[j][i]) + change, ROUNDING);
        }
    }
}

/* The first unit's change by hand: 0.15 x (0.6 - 0.3775406688) x 0.3775406688 x 0.6224593312 = 0.0078418, times x = 1,
 * 2, -0.5. */
static void weight_updates_equal_the_worked_example(void **state)
{
    (void)state;
    make_small_layer(&actor);
    twd_actor_activate(&actor, input);
    actor.learned_value[0] = TWD_NUM(0.6);
    twd_actor_learn(&actor, input, TWD_NUM(0.1), TWD_WIDE(1.5));
    assert_num_close(actor.weight[0][0], 0.5 + 0.0078418, 1e-6);
    assert_num_close(actor.weight[0][1], -0.25 + 0.0156836, 1e-6);
    assert_num_close(actor.weight[0][2], 1.0 - 0.0039209, 1e-6);
}

/* Exploration adds one draw a unit, in order, from [-h, h): the draws are repeated here from a copy of the
 * generator. */
static void exploration_adds_one_draw_a_unit_in_order(void **state)
{
    const struct twd_exploration exploration = {.half_range = TWD_NUM(0.25), .clip = TWD_NUM(0.001)};
    struct twd_random random;
    (void)state;
    make_small_layer(&actor);
    twd_random_seed(&random, 7);
    struct twd_random copy = random;
    twd_actor_activate(&actor, input);
    twd_actor_explore(&actor, &exploration, &random);
    for (int j = 0; j < 2; j++) {
        const double draw = 0.25 * ((double)(twd_random_next(&copy) >> 8) / 8388608.0 - 1.0);
        assert_num_close(actor.explored[j], twd_num_to_double(actor.output[j]) + draw, 1e-7);
    }
    assert_memory_equal(random.state, copy.state, sizeof copy.state);
}

/* Exploration that would leave [clip, 1 - clip] stops at its ends, and the update uses the stopped value, or the one
 * asked for: with weights for y = 1 / (1 + e^-2) = 0.8807970780, dw = eta S (y^N - y) y (1 - y) x, where y^N is at most
 * 0.999, or what the draw gives. */
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
        assert_int_equal(twd_actor_init(&actor, 1, 1, TWD_NUM(0), &random), TWD_OK);
        actor.weight[0][0] = TWD_NUM(2);
        twd_actor_activate(&actor, one);
        struct twd_random repeat = random;
        twd_actor_explore(&actor, &exploration, &random);
        const double asked = y + 0.5 * ((double)(twd_random_next(&repeat) >> 8) / 8388608.0 - 1.0);
        const double acted = asked > 0.999 ? 0.999 : asked;
        const double learned = learned_value == TWD_LEARN_FROM_CLIPPED ? acted : asked;
        clipped += asked > 0.999;
        assert_num_close(actor.explored[0], acted, ROUNDING);
        twd_actor_learn(&actor, one, TWD_NUM(0.1), TWD_WIDE(1));
        assert_num_close(actor.weight[0][0], 2.0 + 0.1 * (learned - y) * y * (1.0 - y), ROUNDING);
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
    struct twd_random random, copy;
    (void)state;
    make_small_layer(&actor);
    twd_random_seed(&random, 9);
    copy = random;
    twd_actor_activate(&actor, input);
    twd_actor_explore(&actor, &all, &random);
    twd_actor_learn(&actor, input, TWD_NUM(0.1), TWD_WIDE(1.5));
    const twd_num explored = actor.explored[0];
    twd_num weight[3], weight_before[3];
    memcpy(weight, actor.weight[0], sizeof weight);

    make_small_layer(&actor);
    memcpy(weight_before, actor.weight[1], sizeof weight_before);
    twd_actor_activate(&actor, input);
    twd_actor_explore(&actor, &first, &copy);
    twd_actor_learn(&actor, input, TWD_NUM(0.1), TWD_WIDE(1.5));
    assert_memory_equal(copy.state, random.state, sizeof copy.state);
    assert_true(actor.explored[0] == explored);
    assert_memory_equal(actor.weight[0], weight, sizeof weight);
    assert_true(actor.explored[1] == actor.output[1]);
    assert_memory_equal(actor.weight[1], weight_before, sizeof weight_before);
}

/* Initial weights lie in [-range, range), differ, and what no unit or input uses is 0. */
static void initial_weights_fill_their_range(void **state)
{
    double largest = 0.0;
    struct twd_random random;
    (void)state;
    twd_random_seed(&random, 5);
    assert_int_equal(twd_actor_init(&actor, 20, 20, TWD_NUM(0.05), &random), TWD_OK);
    for (size_t j = 0; j < TWD_MAX_UNITS; j++) {
        for (size_t i = 0; i < TWD_MAX_INPUTS; i++) {
            const double weight = fabs(twd_num_to_double(actor.weight[j][i]));
            if (j < 20 && i < 20)
                largest = weight > largest ? weight : largest;
            else
                assert_true(weight <= 0.0);
        }
    }
    assert_true(largest > 0.045 && largest <= twd_num_to_double(TWD_NUM(0.05)));
}

/* With TD errors of +-100 and inputs of +-7.5, 40 updates of eta S (y^N - y) y (1 - y) x carry a weight 374.25 far: by
 * hand, from 0.1, 0.999 and 0.5. In the fixed build it stops at the end of its range, 8, and is not carried round. */
static void weights_stop_at_the_end_of_their_range(void **state)
{
    (void)state;
    const twd_num large[3] = {TWD_NUM(7.5), TWD_NUM(-7.5), TWD_NUM(0)};
    const twd_wide td_errors[] = {TWD_WIDE(100), TWD_WIDE(-100)};
    for (int sign = 0; sign < 2; sign++) {
        make_small_layer(&actor);
        for (int trial = 0; trial < 40; trial++) {
            actor.output[0] = TWD_NUM(0.5);
            actor.learned_value[0] = TWD_NUM(0.999);
            twd_actor_learn(&actor, large, TWD_NUM(0.1), td_errors[sign]);
        }
        const double way = sign == 0 ? 374.25 : -374.25;
        assert_num_close(actor.weight[0][0], BY_NUMBER(0.5 + way, 0.5 + way, way > 0 ? 8.0 : -8.0),
                         BY_NUMBER(1e-9, 1e-2, NUM_STEP));
        assert_num_close(actor.weight[0][1], BY_NUMBER(-0.25 - way, -0.25 - way, way > 0 ? -8.0 : 8.0),
                         BY_NUMBER(1e-9, 1e-2, NUM_STEP));
        assert_num_close(actor.weight[0][2], 1.0, 0.0);
        assert_true(twd_within(twd_actor_unit(&actor, 0, large), TWD_NUM(0), TWD_NUM(1)));
    }
}

/* Wrong sizes and ranges are refused before anything is written or drawn. */
static void init_errors_leave_layer_and_generator_as_they_were(void **state)
{
    struct twd_random random;
    (void)state;
    twd_random_seed(&random, 9);
    const struct twd_random random_before = random;
    mark(&actor, sizeof actor);
    assert_int_equal(twd_actor_init(&actor, 0, 3, TWD_NUM(0.1), &random), TWD_ERROR_LEARNER_SIZE);
    assert_int_equal(twd_actor_init(&actor, TWD_MAX_UNITS + 1, 3, TWD_NUM(0.1), &random), TWD_ERROR_LEARNER_SIZE);
    assert_int_equal(twd_actor_init(&actor, 2, 0, TWD_NUM(0.1), &random), TWD_ERROR_LEARNER_SIZE);
    assert_int_equal(twd_actor_init(&actor, 2, TWD_MAX_INPUTS + 1, TWD_NUM(0.1), &random), TWD_ERROR_LEARNER_SIZE);
    assert_int_equal(twd_actor_init(&actor, 2, 3, TWD_NUM(-0.1), &random), TWD_ERROR_RANGE);
    assert_int_equal(twd_actor_init(&actor, 2, 3, twd_num_from_double((double)NAN), &random), TWD_ERROR_RANGE);
    assert_marked(&actor, sizeof actor);
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
        cmocka_unit_test(weights_stop_at_the_end_of_their_range),
        cmocka_unit_test(init_errors_leave_layer_and_generator_as_they_were),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
