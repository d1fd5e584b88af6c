/* uart.h: a board's serial line: 115,200 bit/s, 8 data bits, no parity, one stop bit, no flow control; polled, without
 * interrupts. Boards that have one beside semihosting implement it in boards/BOARD/uart.c. */
#ifndef TWIDDLE_FIRMWARE_UART_H
#define TWIDDLE_FIRMWARE_UART_H

#include <stddef.h>
#include <stdint.h>

/* Open the line; call before the others. */
void uart_open(void);

/* Wait for a byte, and read it and what else is there, up to `capacity`. Returns how many came, at least 1. */
size_t uart_read(uint8_t *bytes, size_t capacity);

/* Write `count` bytes; returns when the last is on its way. */
void uart_write(const uint8_t *bytes, size_t count);

#endif
