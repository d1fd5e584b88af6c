/* arguments.c: writes the command line that semihosting tells. */
#include "board.h"
#include "semihosting.h"

enum { SYS_GET_CMDLINE = 0x15 };

int main(void)
{
    static char line[200];
    uintptr_t block[] = {(uintptr_t)line, sizeof line};
    if (semihosting_call(SYS_GET_CMDLINE, block) != 0) return BOARD_FAILURE;
    board_write(line);
    board_write("\n");
    return BOARD_SUCCESS;
}
