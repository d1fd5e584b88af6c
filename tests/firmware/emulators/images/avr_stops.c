/* avr_stops.c: stops in a loop of one instruction with interrupts off, as a program does that calls avr-libc's abort. */
#include <avr/interrupt.h>

int main(void)
{
    cli();
    for (;;)
        continue;
}
