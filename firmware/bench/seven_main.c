/* seven_main.c: main of a bench image that has the seven oscillators and nothing else. */
#include "board.h"
#include "seven.h"

int main(void)
{
    seven_run();
    return BOARD_SUCCESS;
}
