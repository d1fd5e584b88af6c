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
    assert_close(twd_critic_value(&critic, input), 0.0, 0.0);
    assert_close(twd_critic_learn(&critic, input, TWD_NUM(0.1), TWD_NUM(2)), 2.0, ROUNDING);
    assert_close(critic.weight[0], 0.2, ROUNDING);
    assert_close(critic.weight[1], 0.4, ROUNDING);
    assert_close(critic.weight[2], -0.1, ROUNDING);
    assert_close(twd_critic_value(&critic, input), 1.05, ROUNDING);
    assert_close(twd_critic_learn(&critic, input, TWD_NUM(0.1), TWD_NUM(2)), 0.95, ROUNDING);
    assert_close(critic.weight[0], 0.295, ROUNDING);
    assert_close(critic.weight[1], 0.59, ROUNDING);
    assert_close(critic.weight[2], -0.1475, ROUNDING);
}

/* On a constant input and reward the error shrinks by 1 - eta |x|^2 a trial: after n trials E = R (1 - (1 - eta |x|^2)^n). */
static void estimate_approaches_a_constant_reward_geometrically(void **state)
{
    const twd_num input[] = {TWD_NUM(1), TWD_NUM(0.5)};
    struct twd_critic critic;
    (void)state;
    assert_int_equal(twd_critic_init(&critic, 2), TWD_OK);
    for (int trial = 0; trial < 50; trial++) {
        assert_close(twd_critic_value(&critic, input), 3.0 * (1.0 - pow(1.0 - 0.1 * 1.25, trial)), 10.0 * ROUNDING);
        (void)twd_critic_learn(&critic, input, TWD_NUM(0.1), TWD_NUM(3));
    }
}

/* Sizes that the array cannot hold are refused, and the critic stays as it was. */
static void wrong_sizes_leave_the_critic_as_it_was(void **state)
{
    struct twd_critic critic;
    (void)state;
    assert_int_equal(twd_critic_init(&critic, 4), TWD_OK);
    critic.weight[0] = TWD_NUM(0.25);
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
        cmocka_unit_test(wrong_sizes_leave_the_critic_as_it_was),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
