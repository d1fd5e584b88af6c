/* main_files.c: a board whose agent is driven over two files of the machine that runs the emulator or debugger, as a
 * rule FIFOs: `to-chip` and `from-chip` in the folder where it was started. `twiddle train --target BOARD` makes
 * them. */
#include "agent/agent_server.h"
#include "board.h"

/* The handles of the two files. */
struct files {
    int to_chip;
    int from_chip;
};

static size_t read_file(void *context, uint8_t *bytes, size_t capacity)
{
    const struct files *const files = context;
    return board_file_read(files->to_chip, bytes, capacity);
}

static bool write_file(void *context, const uint8_t *bytes, size_t count)
{
    const struct files *const files = context;
    return board_file_write(files->from_chip, bytes, count);
}

int main(void)
{
    static struct twd_agent_server server; /* large, so not on the stack */
    struct files files = {board_file_open("to-chip", BOARD_READ), board_file_open("from-chip", BOARD_WRITE)};
    if (files.to_chip < 0 || files.from_chip < 0) {
        board_write("agent: cannot open the files to-chip and from-chip\n");
        return BOARD_FAILURE;
    }
    const struct twd_byte_link link = {read_file, write_file, &files};
    twd_agent_server_start(&server);
    twd_agent_server_run(&server, &link);
    return BOARD_SUCCESS; /* whoever drove the agent has gone */
}
