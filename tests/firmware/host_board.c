/* What of support/board.h images that only write need, on the machine that runs the tests. */
#include <board.h>

#include <stdio.h>
#include <stdlib.h>

void board_write(const char *text)
{
    fputs(text, stdout);
}

void board_exit(int status)
{
    exit(status);
}
