/* hangs.c: says so, and never ends. */
#include "board.h"

int main(void)
{
    board_write("going to hang\n");
    for (volatile unsigned turns = 0;; turns++)
        continue;
}
