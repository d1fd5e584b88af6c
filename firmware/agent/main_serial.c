/* main_serial.c: a board whose agent is driven over its serial line. `twiddle train --port PATH` drives it. */
#include "agent/agent_server.h"
#include "uart.h"

static size_t read_line(void *context, uint8_t *bytes, size_t capacity)
{
    (void)context;
    return uart_read(bytes, capacity);
}

static bool write_line(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    uart_write(bytes, count);
    return true;
}

int main(void)
{
    static struct twd_agent_server server; /* large, so not on the stack */
    const struct twd_byte_link link = {read_line, write_line, NULL};
    uart_open();
    twd_agent_server_start(&server);
    twd_agent_server_run(&server, &link); /* for ever: the line has no end */
    return 0;
}
