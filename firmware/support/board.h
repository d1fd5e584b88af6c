/* board.h: the one interface between an image and the board that it runs on.
 *
 * An image defines `int main(void)`. The board's start-up calls it, and ends the run with the status that it returns.
 *
 * Arm and RISC-V boards speak by semihosting: the emulator or debugger that runs the image writes the text to its
 * standard output, opens files for it, and ends with its exit status (QEMU: -semihosting-config
 * enable=on,target=native). The ATmega1284P sends text through UART0 (115,200 baud at 16 MHz, 8N1) and knows no files.
 * It ends a run by leaving the status in the register GPIOR0 and sleeping with interrupts off, on which simavr ends. */
#ifndef TWIDDLE_FIRMWARE_BOARD_H
#define TWIDDLE_FIRMWARE_BOARD_H

#include <stdbool.h>
#include <stddef.h>

/* Statuses that an image ends with; any other 0..255 is the image's own. */
enum board_status {
    BOARD_SUCCESS = 0,
    BOARD_FAILURE = 1,
    BOARD_FAULT = 3 /* the processor met a fault: a bad address or instruction, a stack outside the RAM */
};

/* Write `text`; returns when it is on its way. */
void board_write(const char *text);

/* End the run with `status`, 0..255. */
void board_exit(int status) __attribute__((noreturn));

/* What a file is opened for. A FIFO or a terminal device is a file, too. */
enum board_file_mode { BOARD_READ = 0, BOARD_WRITE = 1 };

/* Open the file `path` of the machine that runs the emulator or debugger. Returns its handle, or -1 if that failed or
 * the board has no files. */
int board_file_open(const char *path, enum board_file_mode mode);

/* Read up to `size` bytes; waits until there is at least one. Returns how many came: 0 at the end of the file or after
 * an error. */
size_t board_file_read(int handle, void *data, size_t size);

/* Write `size` bytes; false if not all of them were. */
bool board_file_write(int handle, const void *data, size_t size);

/* Close the file; the handle is then no longer valid. */
void board_file_close(int handle);

#endif
