#include "controller_test.h"

#include <twiddle/gate.h>

/* Fixed: half a step of 2^-28 for each number that goes in or comes out, three at most. */
#define ROUNDING BY_NUMBER(1e-15, 1e-6, 1.5 * NUM_STEP)

/* s_k = y_k / sum(y): 0.2, 0.3 and 0.5 of their sum 1, and 1, 2 and 5 of 8. */
static void weights_are_shares_of_the_sum(void **state)
{
    (void)state;
    const twd_num fractions[] = {TWD_NUM(0.2), TWD_NUM(0.3), TWD_NUM(0.5)};
    const twd_num eighths[] = {TWD_NUM(0.125), TWD_NUM(0.25), TWD_NUM(0.625)};
    twd_num weight[3];
    twd_gate_normalise(fractions, 3, weight);
    assert_num_close(weight[0], 0.2, ROUNDING);
    assert_num_close(weight[1], 0.3, ROUNDING);
    assert_num_close(weight[2], 0.5, ROUNDING);
    twd_gate_normalise(eighths, 3, weight);
    assert_num_close(weight[0], 1.0 / 8.0, ROUNDING);
    assert_num_close(weight[1], 2.0 / 8.0, ROUNDING);
    assert_num_close(weight[2], 5.0 / 8.0, ROUNDING);
}

/* Activations that are all 0 have no shares; the weights are then equal. */
static void silent_selector_weighs_equally(void **state)
{
    (void)state;
    const twd_num silent[] = {TWD_NUM(0), TWD_NUM(0), TWD_NUM(0)};
    twd_num weight[3];
    twd_gate_normalise(silent, 3, weight);
    for (int k = 0; k < 3; k++)
        assert_num_close(weight[k], 1.0 / 3.0, ROUNDING);
}

/* 1000 random selectors: the weights sum to 1 and keep the order of the activations. */
static void weights_sum_to_one(void **state)
{
    (void)state;
    uint64_t random = 5;
    print_message("seed 5\n");
    for (int32_t repeat = CASES(1000); repeat > 0; repeat--) {
        twd_num activation[3];
        twd_num weight[3];
        for (int k = 0; k < 3; k++)
            activation[k] = twd_num_from_double(uniform(&random, 0.001, 0.999));
        twd_gate_normalise(activation, 3, weight);
        assert_num_close(weight[0] + weight[1] + weight[2], 1.0, ROUNDING);
        assert_true((activation[0] < activation[1]) == (weight[0] < weight[1]));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(weights_are_shares_of_the_sum),
        cmocka_unit_test(silent_selector_weighs_equally),
        cmocka_unit_test(weights_sum_to_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
