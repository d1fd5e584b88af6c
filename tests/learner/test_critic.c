/* The reward's estimator, on cases worked by hand. */
#include "learner_test.h"

#include <twiddle/critic.h>

/* Eqs. 6 and 7 term by term, worked by hand with x = (1, 2, -0.5), eta = 0.1, R = 2:
 * from E = 0: S = 2, w = (0.2, 0.4, -0.1); then E = 0.2 + 0.8 + 0.05 = 1.05, S = 0.95, w = (0.295, 0.59, -0.1475). */
static void updates_equal_the_worked_example(void **state)
{
    const twd_num input[] = {TWD_NUM(1), TWD_NUM(2), TWD_NUM(-0.5)};
    struct twd_critic critic;
    (void)state;
    assert_int_equal(twd_critic_init(&critic, 3), TWD_OK);
    assert_wide_close(twd_critic_value(&critic, input), 0.0, 0.0);
    assert_wide_close(twd_critic_learn(&critic, input, TWD_NUM(0.1), TWD_WIDE(2)), 2.0, ROUNDING);
    assert_wide_close(critic.weight[0], 0.2, ROUNDING);
    assert_wide_close(critic.weight[1], 0.4, ROUNDING);
    assert_wide_close(critic.weight[2], -0.1, ROUNDING);
    assert_wide_close(twd_critic_value(&critic, input), 1.05, ROUNDING);
    assert_wide_close(twd_critic_learn(&critic, input, TWD_NUM(0.1), TWD_WIDE(2)), 0.95, ROUNDING);
    assert_wide_close(critic.weight[0], 0.295, ROUNDING);
    assert_wide_close(critic.weight[1], 0.59, ROUNDING);
    assert_wide_close(critic.weight[2], -0.1475, ROUNDING);
}

/* On a constant input and reward the error shrinks by 1 - eta |x|^2 a trial: after n trials E = R (1 - (1 - eta
 * |x|^2)^n). */
static void estimate_approaches_a_constant_reward_geometrically(void **state)
{
    const twd_num input[] = {TWD_NUM(1), TWD_NUM(0.5)};
    struct twd_critic critic;
    (void)state;
    assert_int_equal(twd_critic_init(&critic, 2), TWD_OK);
    for (int trial = 0; trial < 50; trial++) {
        assert_wide_close(twd_critic_value(&critic, input), 3.0 * (1.0 - pow(1.0 - 0.1 * 1.25, trial)),
                          10.0 * ROUNDING);
        (void)twd_critic_learn(&critic, input, TWD_NUM(0.1), TWD_WIDE(3));
    }
}

/* Whatever the rewards, the fixed build's estimate and weights stop at +-128; in the others they are numbers. */
static void estimate_stays_in_its_range(void **state)
{
    const twd_num input[] = {TWD_NUM(7.5), TWD_NUM(-7.5)};
    static const double rewards[] = {1e6, -1e6};
    struct twd_critic critic;
    (void)state;
    for (int sign = 0; sign < 2; sign++) {
        assert_int_equal(twd_critic_init(&critic, 2), TWD_OK);
        const twd_wide reward = twd_wide_from_double(rewards[sign]);
        const double largest = rewards[sign] * BY_NUMBER(1.0, 1.0, 128e-6);
        /* After one update at rate 1 the estimate would be 112.5 times the reward. */
        assert_wide_close(twd_critic_learn(&critic, input, TWD_NUM(1), reward), largest, WIDE_STEP);
        const double estimate = largest * BY_NUMBER(112.5, 112.5, 1.0);
        assert_wide_close(twd_critic_value(&critic, input), estimate, BY_NUMBER(1e-3, 100.0, WIDE_STEP));
    }
}

/* Sizes that the array cannot hold are refused, and the critic stays as it was. */
static void wrong_sizes_leave_the_critic_as_it_was(void **state)
{
    struct twd_critic critic;
    (void)state;
    assert_int_equal(twd_critic_init(&critic, 4), TWD_OK);
    critic.weight[0] = TWD_WIDE(0.25);
    const struct twd_critic before = critic;
    assert_int_equal(twd_critic_init(&critic, 0), TWD_ERROR_LEARNER_SIZE);
    assert_int_equal(twd_critic_init(&critic, TWD_MAX_INPUTS + 1), TWD_ERROR_LEARNER_SIZE);
    assert_int_equal(critic.inputs, before.inputs);
    assert_memory_equal(critic.weight, before.weight, sizeof before.weight);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(updates_equal_the_worked_example),
        cmocka_unit_test(estimate_approaches_a_constant_reward_geometrically),
        cmocka_unit_test(estimate_stays_in_its_range),
        cmocka_unit_test(wrong_sizes_leave_the_critic_as_it_was),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
