/* The board's interface by semihosting, the calls that a debugger or emulator answers: "Semihosting for AArch32 and
 * AArch64", Arm, and "RISC-V Semihosting". */
#include "board.h"

#include "semihosting.h"

#include <stdint.h>
#include <string.h>

enum operation {
    SYS_OPEN = 0x01,
    SYS_CLOSE = 0x02,
    SYS_WRITE = 0x05,
    SYS_READ = 0x06,
    SYS_EXIT_EXTENDED = 0x20,
};

/* What SYS_OPEN calls the modes "rb" and "wb", and the reason for an exit that the program asked for. */
enum { OPEN_READ_BINARY = 1, OPEN_WRITE_BINARY = 5, APPLICATION_EXIT = 0x20026 };

static int open_as(const char *path, uintptr_t mode)
{
    const uintptr_t block[] = {(uintptr_t)path, mode, strlen(path)};
    return (int)semihosting_call(SYS_OPEN, block);
}

int board_file_open(const char *path, enum board_file_mode mode)
{
    return open_as(path, mode == BOARD_READ ? OPEN_READ_BINARY : OPEN_WRITE_BINARY);
}

/* READ and WRITE answer with the number of bytes that are left over. */
size_t board_file_read(int handle, void *data, size_t size)
{
    const uintptr_t block[] = {(uintptr_t)handle, (uintptr_t)data, size};
    const uintptr_t left = semihosting_call(SYS_READ, block);
    return left < size ? size - left : 0;
}

bool board_file_write(int handle, const void *data, size_t size)
{
    const uintptr_t block[] = {(uintptr_t)handle, (uintptr_t)data, size};
    return semihosting_call(SYS_WRITE, block) == 0;
}

void board_file_close(int handle)
{
    const uintptr_t block[] = {(uintptr_t)handle};
    (void)semihosting_call(SYS_CLOSE, block);
}

void board_write(const char *text)
{
    static int console = -1;
    if (console < 0) console = open_as(":tt", OPEN_WRITE_BINARY); /* the name of standard output */
    (void)board_file_write(console, text, strlen(text));
}

void board_exit(int status)
{
    const uintptr_t block[] = {APPLICATION_EXIT, (uintptr_t)status};
    for (;;)
        (void)semihosting_call(SYS_EXIT_EXTENDED, block);
}
