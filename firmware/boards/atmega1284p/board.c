/* The ATmega1284P at 16 MHz. Start-up is avr-libc's, which calls main, then exit, and stops. */
#include "board.h"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

#include <stdlib.h>

enum { UART0_DIVISOR = 16 }; /* 115,200 baud at 16 MHz and double speed, 2.1 % fast */

static void write_byte(uint8_t byte)
{
    while (!(UCSR0A & _BV(UDRE0)))
        continue;
    UDR0 = byte;
    UCSR0A |= _BV(TXC0); /* writing a one clears it; it is set again when this byte has left */
}

void board_write(const char *text)
{
    if (!(UCSR0B & _BV(TXEN0))) {
        UBRR0 = UART0_DIVISOR;
        UCSR0A = _BV(U2X0);
        UCSR0B = _BV(TXEN0);
    }
    while (*text)
        write_byte((uint8_t)*text++);
}

/* Sleeps only when the last byte has left. */
void board_exit(int status)
{
    if (UCSR0B & _BV(TXEN0)) {
        while (!(UCSR0A & _BV(TXC0)))
            continue;
    }
    GPIOR0 = (uint8_t)status;
    cli();
    for (;;)
        sleep_mode();
}

/* Called by avr-libc with what main returned. */
void exit(int status)
{
    board_exit(status);
}

int board_file_open(const char *path, enum board_file_mode mode)
{
    (void)path;
    (void)mode;
    return -1;
}

size_t board_file_read(int handle, void *data, size_t size)
{
    (void)handle;
    (void)data;
    (void)size;
    return 0;
}

bool board_file_write(int handle, const void *data, size_t size)
{
    (void)handle;
    (void)data;
    (void)size;
    return false;
}

void board_file_close(int handle)
{
    (void)handle;
}
