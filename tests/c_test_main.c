/* c_test_main.c: the tests of one C library as one program, since linking is what costs time. Its argument is the group
 * to run, one file's tests. The build names the groups: TEST_GROUPS is a list of GROUP(name), and the main of that file
 * is name_main. */
#include <stdio.h>
#include <string.h>

#define GROUP(name) extern int name##_main(void);
TEST_GROUPS
#undef GROUP

static const struct {
    const char *name;
    int (*main)(void);
} groups[] = {
#define GROUP(name) {#name, name##_main},
    TEST_GROUPS
#undef GROUP
};

int main(int argc, char **argv)
{
    const size_t count = sizeof groups / sizeof groups[0];
    for (size_t i = 0; i < count && argc == 2; i++)
        if (strcmp(argv[1], groups[i].name) == 0) return groups[i].main();

    fprintf(stderr, "usage: %s GROUP, one of:\n", argv[0]);
    for (size_t i = 0; i < count; i++)
        fprintf(stderr, "    %s\n", groups[i].name);
    return 2;
}
