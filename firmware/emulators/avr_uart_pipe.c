#include "avr_uart_pipe.h"

#include <simavr/avr_uart.h>

#include <poll.h>
#include <stdio.h>
#include <unistd.h>

/* UART0's control register, as a data address, and its bit that turns the receiver on. */
enum { UCSR0B_ADDRESS = 0xC1, RXEN0_MASK = 1 << 4 };

static const avr_t *board;
static avr_irq_t *input;
static bool has_room = true;
static bool at_end;

static void sent(struct avr_irq_t *irq, uint32_t value, void *data)
{
    (void)irq;
    (void)data;
    putchar((int)(value & 0xFF));
    /* A reader at the other end may wait for it. */
    fflush(stdout);
}

static void room_changed(struct avr_irq_t *irq, uint32_t value, void *data)
{
    (void)irq;
    (void)value;
    has_room = *(const bool *)data;
}

void avr_uart_pipe_join(avr_t *avr)
{
    static bool yes = true;
    static bool no = false;
    board = avr;
    /* Neither simavr's own printing of lines, nor its sleeping when the image polls. */
    uint32_t flags = 0;
    avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT), sent, NULL);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUT_XON), room_changed, &yes);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUT_XOFF), room_changed, &no);
    input = avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_INPUT);
}

void avr_uart_pipe_feed(void)
{
    struct pollfd waiting = {STDIN_FILENO, POLLIN, 0};
    const bool listens = board->data[UCSR0B_ADDRESS] & RXEN0_MASK;
    if (at_end || !listens || !has_room || poll(&waiting, 1, 0) <= 0) return;
    unsigned char byte;
    at_end = read(STDIN_FILENO, &byte, 1) <= 0;
    if (!at_end) avr_raise_irq(input, byte);
}

bool avr_uart_pipe_flush(void)
{
    return fflush(stdout) == 0 && !ferror(stdout);
}
