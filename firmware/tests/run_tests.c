/* The test programs of an image, one after another. The build names them: TEST_PROGRAMS is a list of PROGRAM(name), and
 * each program's main is name_main. */
#include "board.h"

#include <cmocka.h>

#define PROGRAM(name) extern int name##_main(void);
TEST_PROGRAMS
#undef PROGRAM

static const struct {
    const char *name;
    int (*main)(void);
} programs[] = {
#define PROGRAM(name) {#name, name##_main},
    TEST_PROGRAMS
#undef PROGRAM
};

int main(void)
{
    int failures = 0;
    for (size_t i = 0; i < sizeof programs / sizeof programs[0]; i++) {
        print_message("%s\n", programs[i].name);
        failures += programs[i].main();
    }
    if (failures > 0) {
        print_error("%d tests failed\n", failures);
        return BOARD_FAILURE;
    }
    board_write("all tests passed\n");
    return BOARD_SUCCESS;
}
