/* avr_echo.c: sends back what comes through UART0, in upper case, until the end of a line. */
#include "board.h"

#include <avr/io.h>

#include <ctype.h>

int main(void)
{
    board_write("echo: "); /* sets UART0 up for sending */
    UCSR0B |= _BV(RXEN0);
    char text[2] = " ";
    do {
        while (!(UCSR0A & _BV(RXC0)))
            continue;
        text[0] = (char)toupper(UDR0);
        board_write(text);
    } while (text[0] != '\n');
    return BOARD_SUCCESS;
}
