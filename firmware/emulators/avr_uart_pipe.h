/* avr_uart_pipe.h: UART0 of an emulated AVR, joined to this program's standard output and input. */
#ifndef TWIDDLE_AVR_UART_PIPE_H
#define TWIDDLE_AVR_UART_PIPE_H

#include <simavr/sim_avr.h>

#include <stdbool.h>

/* Join UART0 of `avr` to standard output. */
void avr_uart_pipe_join(avr_t *avr);

/* Hand the UART one byte of standard input, if there is one and the image listens and keeps up; never waits. */
void avr_uart_pipe_feed(void);

/* Whether all that was sent could be written. */
bool avr_uart_pipe_flush(void);

#endif
