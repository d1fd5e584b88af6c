#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>

#include <cmocka.h>

#include "board.h"

static jmp_buf test_end;

/* Tests that the build leaves out, by name: TEST_LEFT_OUT is a list of LEFT_OUT(name). */
static bool is_left_out(const char *name)
{
    (void)name; /* if there are none */
#define LEFT_OUT(left_out)                                                                                             \
    if (strcmp(name, #left_out) == 0) return true;
    TEST_LEFT_OUT
#undef LEFT_OUT
    return false;
}

static void print(const char *format, va_list arguments)
{
    char text[160];
    (void)vsnprintf(text, sizeof text, format, arguments);
    board_write(text);
}

void print_message(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print(format, arguments);
    va_end(arguments);
}

void print_error(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print(format, arguments);
    va_end(arguments);
}

void test_fail(const char *reason, const char *file, int line)
{
    const char *const slash = strrchr(file, '/');
    print_error("%s:%d: %s\n", slash ? slash + 1 : file, line, reason);
    longjmp(test_end, 1);
}

void test_require(int holds, const char *otherwise, const char *file, int line)
{
    if (!holds) test_fail(otherwise, file, line);
}

void test_require_equal(int64_t a, int64_t b, const char *file, int line)
{
    if (a == b) return;
    print_error("%ld is not %ld\n", (long)a, (long)b);
    test_fail("the integers differ", file, line);
}

int test_run_group(const struct CMUnitTest *tests, size_t count)
{
    /* Volatile, since longjmp comes back to values that are otherwise lost. */
    volatile size_t index;
    volatile int failures = 0;
    for (index = 0; index < count; index++) {
        if (is_left_out(tests[index].name)) {
            print_message("left out: %s\n", tests[index].name);
        } else if (setjmp(test_end) == 0) {
            void *state = NULL;
            tests[index].function(&state);
        } else {
            print_error("FAILED: %s\n", tests[index].name);
            failures++;
        }
    }
    return failures;
}
