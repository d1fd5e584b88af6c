/* known_costs.c: calls the functions of known_costs.S, and writes and ends as the tests expect. */
#include "board.h"

void loop_of_100(void);
void calls_it_twice(void);
void loop_of(unsigned char n);
void never_called(void);

void never_called(void)
{
    loop_of_100();
}

int main(void)
{
    loop_of_100();
    calls_it_twice();
    for (unsigned char n = 1; n <= 10; n++)
        loop_of(n);
    void (*volatile if_any)(void) = 0;
    if (if_any == never_called) if_any();
    board_write("called them all\n");
    return 42;
}
