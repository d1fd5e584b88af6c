/* Each assertion once where it holds, and once where it does not: the tests named *_fails. Compiled against cmocka and
 * against firmware/tests/cmocka.h, the same tests must fail. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <string.h>

static const char text[] = "text";
static const char same_text[] = "text";
static const char other_text[] = "test";

static void what_holds_passes(void **state)
{
    (void)state;
    assert_true(strlen(text) == 4);
    assert_non_null(text);
    assert_int_equal(-7, -7);
    assert_int_equal(INT64_C(1) << 40, INT64_C(1) << 40);
    assert_int_not_equal(1, 2);
    assert_in_range(5, 5, 7);
    assert_memory_equal(text, same_text, sizeof text);
    assert_memory_not_equal(text, other_text, sizeof text);
    assert_string_equal(text, same_text);
    assert_string_not_equal(text, other_text);
}

#define FAILING_TEST(name, assertion)                                                                                  \
    static void name##_fails(void **state)                                                                             \
    {                                                                                                                  \
        (void)state;                                                                                                   \
        assertion;                                                                                                     \
    }

FAILING_TEST(true, assert_true(strlen(text) == 3))
FAILING_TEST(non_null, assert_non_null(strchr(text, 'z')))
FAILING_TEST(int_equal, assert_int_equal(-7, 7))
FAILING_TEST(int_equal_in_the_upper_half, assert_int_equal(INT64_C(1) << 40, INT64_C(1) << 41))
FAILING_TEST(int_not_equal, assert_int_not_equal(2, 2))
FAILING_TEST(in_range, assert_in_range(8, 5, 7))
FAILING_TEST(memory_equal, assert_memory_equal(text, other_text, sizeof text))
FAILING_TEST(memory_not_equal, assert_memory_not_equal(text, same_text, sizeof text))
FAILING_TEST(string_equal, assert_string_equal(text, other_text))
FAILING_TEST(string_not_equal, assert_string_not_equal(text, same_text))
FAILING_TEST(fail, fail())

/* What stands behind a failure does not run; what was printed before it is printed. */
static void nothing_runs_behind_a_failure(void **state)
{
    (void)state;
    print_message("number %.3f of %d\n", 0.25, 12);
    assert_int_equal(1, 2);
    print_message("behind the failure\n");
}

static void a_test_behind_a_failure_runs(void **state)
{
    (void)state;
    print_error("the last test runs\n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_holds_passes),
        cmocka_unit_test(true_fails),
        cmocka_unit_test(non_null_fails),
        cmocka_unit_test(int_equal_fails),
        cmocka_unit_test(int_equal_in_the_upper_half_fails),
        cmocka_unit_test(int_not_equal_fails),
        cmocka_unit_test(in_range_fails),
        cmocka_unit_test(memory_equal_fails),
        cmocka_unit_test(memory_not_equal_fails),
        cmocka_unit_test(string_equal_fails),
        cmocka_unit_test(string_not_equal_fails),
        cmocka_unit_test(fail_fails),
        cmocka_unit_test(nothing_runs_behind_a_failure),
        cmocka_unit_test(a_test_behind_a_failure_runs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
