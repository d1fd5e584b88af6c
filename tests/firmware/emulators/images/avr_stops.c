/* avr_stops.c: stops in a loop of one instruction with interrupts off, as avr-libc's abort does. */
#include <avr/interrupt.h>

int main(void)
{
    cli();
    for (;;)
        continue;
}
