/* cmocka.h: what the tests of the C libraries use of cmocka, for boards that cmocka does not run on.
 *
 * The same test files compile against this header as against cmocka's. A failed assertion prints its place and ends its
 * test; the next test runs. Set-up and teardown functions are not supported: pass NULL. */
#ifndef TWIDDLE_FIRMWARE_CMOCKA_H
#define TWIDDLE_FIRMWARE_CMOCKA_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* One test: its name, and the function; `state` is not used. */
struct CMUnitTest {
    const char *name;
    void (*function)(void **state);
};

#define cmocka_unit_test(function)                                                                                     \
    {                                                                                                                  \
#function, function                                                                                            \
    }

/* Run an array of tests; the value is the number of those that failed. */
#define cmocka_run_group_tests(tests, setup, teardown)                                                                 \
    ((void)(setup), (void)(teardown), test_run_group(tests, sizeof(tests) / sizeof(tests)[0]))

#define assert_true(condition) test_require((condition) ? 1 : 0, "the condition is false", __FILE__, __LINE__)
#define assert_non_null(pointer) test_require((pointer) != NULL, "the pointer is null", __FILE__, __LINE__)
#define assert_int_equal(a, b) test_require_equal((int64_t)(a), (int64_t)(b), __FILE__, __LINE__)
#define assert_int_not_equal(a, b) test_require((a) != (b), "the integers agree", __FILE__, __LINE__)
#define assert_in_range(value, minimum, maximum)                                                                       \
    test_require((value) >= (minimum) && (value) <= (maximum), "out of range", __FILE__, __LINE__)
#define assert_memory_equal(a, b, size) test_require(memcmp(a, b, size) == 0, "bytes differ", __FILE__, __LINE__)
#define assert_memory_not_equal(a, b, size) test_require(memcmp(a, b, size) != 0, "bytes agree", __FILE__, __LINE__)
#define assert_string_equal(a, b) test_require(strcmp(a, b) == 0, "strings differ", __FILE__, __LINE__)
#define assert_string_not_equal(a, b) test_require(strcmp(a, b) != 0, "strings agree", __FILE__, __LINE__)
#define fail() test_fail("failed", __FILE__, __LINE__)

/* As printf; up to 159 characters. */
void print_message(const char *format, ...) __attribute__((format(printf, 1, 2)));
void print_error(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* What the macros stand for. */
int test_run_group(const struct CMUnitTest *tests, size_t count);
void test_require(int holds, const char *otherwise, const char *file, int line);
void test_require_equal(int64_t a, int64_t b, const char *file, int line);
void test_fail(const char *reason, const char *file, int line) __attribute__((noreturn));

#endif
