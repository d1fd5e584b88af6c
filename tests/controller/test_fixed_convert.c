/* The fixed build's conversions from and to double, and its constants, for words of all sizes (fixed_words.h). Words
 * have up to 31 bits, so this asks for a double of 53. */
#include "fixed_words.h"

/* The four formats' conversions. */
static const struct {
    int32_t (*from_double)(double value);
    double (*to_double)(int32_t word);
    double one;
} conversions[] = {
    {twd_num_from_double, twd_num_to_double, 268435456.0},
    {twd_wide_from_double, twd_wide_to_double, 16777216.0},
    {twd_rate_from_double, twd_rate_to_double, 1048576.0},
    {twd_small_from_double, twd_small_to_double, 17179869184.0},
};
enum { CONVERSIONS = sizeof conversions / sizeof conversions[0] };

/* A word comes back from double as it was; what lies between two words goes to the nearer one, a half away from 0. */
static void check_conversions(int32_t word, int32_t unused)
{
    (void)unused;
    const int32_t beyond = word < 0 ? -1 : 1;
    if (limited(word) != word || limited((int64_t)word + beyond) != (int64_t)word + beyond) return;
    for (size_t i = 0; i < CONVERSIONS; i++) {
        const double quarter = 0.25 * beyond / conversions[i].one;
        const double value = conversions[i].to_double(word);
        assert_true(value == (double)word / conversions[i].one);
        assert_word("from double", word, 0, conversions[i].from_double(value), word);
        assert_word("from double, a quarter on", word, 0, conversions[i].from_double(value + quarter), word);
        assert_word("from double, a half on", word, 0, conversions[i].from_double(value + 2 * quarter), word + beyond);
        assert_word("from double, three quarters on", word, 0, conversions[i].from_double(value + 3 * quarter),
                    word + beyond);
    }
}

static void conversions_round_to_nearest(void **state)
{
    (void)state;
    for_all_pairs(check_conversions);
}

/* Beyond the range a value becomes the last number; what is not finite becomes INT32_MIN. */
static void conversions_stay_in_range(void **state)
{
    static const double beyond[] = {1.0, 1.25, 1e3, 1e300, DBL_MAX};
    (void)state;
    for (size_t i = 0; i < CONVERSIONS; i++) {
        const double end = 2147483648.0 / conversions[i].one;
        for (size_t k = 0; k < sizeof beyond / sizeof beyond[0]; k++) {
            const double size = beyond[k] < 1e300 ? end * beyond[k] : beyond[k];
            assert_int_equal(conversions[i].from_double(size), INT32_MAX);
            assert_int_equal(conversions[i].from_double(-size), -INT32_MAX);
        }
        assert_int_equal(conversions[i].from_double((double)INFINITY), INT32_MIN);
        assert_int_equal(conversions[i].from_double(-(double)INFINITY), INT32_MIN);
        assert_int_equal(conversions[i].from_double((double)NAN), INT32_MIN);
        assert_int_equal(conversions[i].from_double(DBL_MIN), 0);
    }
}

/* Constants are rounded to nearest. Expected, by hand: 0.1 2^28 = 26843545.6, 1.3 2^24 = 21810380.8, 0.7 2^20 =
 * 734003.2, 0.01 2^34 = 171798691.84. */
static void constants_are_rounded_to_nearest(void **state)
{
    (void)state;
    assert_int_equal(TWD_NUM(0.1), 26843546);
    assert_int_equal(TWD_NUM(-0.1), -26843546);
    assert_int_equal(TWD_WIDE(-1.3), -21810381);
    assert_int_equal(TWD_RATE(0.7), 734003);
    assert_int_equal(TWD_SMALL(-0.01), -171798692);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(conversions_round_to_nearest),
        cmocka_unit_test(conversions_stay_in_range),
        cmocka_unit_test(constants_are_rounded_to_nearest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
