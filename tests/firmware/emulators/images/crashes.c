/* crashes.c: calls a function where none is. */
#include "board.h"

#include <stdint.h>

int main(void)
{
#ifdef __AVR__
    void (*volatile nowhere)(void) = (void (*)(void))0xFFFE; /* erased flash: no instruction */
#else
    void (*volatile nowhere)(void) = (void (*)(void))(uintptr_t)0xF0000000; /* no memory */
#endif
    board_write("going to crash\n");
    nowhere();
    return BOARD_SUCCESS;
}
