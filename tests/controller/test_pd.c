#include "controller_test.h"

#include <twiddle/pd.h>

/* T = g + Kp (desired - actual) - Kd velocity: 0.01 + 0.21 x 0.2 - 0.0069 x 3 = 0.0313. */
static void pd_law_is_the_papers(void **state)
{
    (void)state;
    const struct twd_pd pd = {TWD_NUM(0.21), TWD_NUM(0.0069), TWD_NUM(1)};
    const twd_num torque = twd_pd_torque(&pd, TWD_NUM(0.5), TWD_NUM(0.3), TWD_NUM(3), TWD_NUM(0.01));
    assert_close(torque, 0.0313, BY_NUMBER(1e-15, 1e-8));
}

/* At the desired angle and at rest, the torque is gravity's alone. */
static void pd_law_at_rest_holds_the_weight(void **state)
{
    (void)state;
    const struct twd_pd pd = {TWD_NUM(0.21), TWD_NUM(0.0069), TWD_NUM(1)};
    assert_true(twd_pd_torque(&pd, TWD_NUM(0.4), TWD_NUM(0.4), TWD_NUM(0), TWD_NUM(0.02)) == TWD_NUM(0.02));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pd_law_is_the_papers),
        cmocka_unit_test(pd_law_at_rest_holds_the_weight),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
