/* stack_mark.c: how deep the stack of the image `control` really grows. Fills the free memory with a pattern, runs
 * control's main, and looks how much of the pattern is left. Prints one line: `stack N`, in bytes. */
#define main control_main
#include "../examples/control.c"
#undef main

#include <stdint.h>
#include <stdlib.h>

#if defined(__AVR__)
extern char __heap_start[]; /* by avr-libc's linker script */
#define FREE_START __heap_start
#else
extern char board_heap_start[]; /* by boards/sections.ld */
#define FREE_START board_heap_start
#endif

#define PATTERN 0xA5

/* How much is looked at, and how much next to the caller is left alone. */
enum { REACH_BYTES = 6144, NEAR_BYTES = 128 };

/* The bytes from this function's frame to the deepest that control's main changed; 0 if it failed. */
__attribute__((noinline)) static uint16_t measure(void)
{
    volatile uint8_t here = PATTERN;
    const uintptr_t top = (uintptr_t)&here;
    uintptr_t bottom = (uintptr_t)FREE_START;
    if (top - bottom > REACH_BYTES) bottom = top - REACH_BYTES;
    for (uintptr_t address = bottom; address < top - NEAR_BYTES; address++)
        *(volatile uint8_t *)address = PATTERN; /* NOLINT(performance-no-int-to-ptr): memory that is nobody's */
    if (control_main() != BOARD_SUCCESS) return 0;
    while (bottom < top && *(volatile uint8_t *)bottom == PATTERN) /* NOLINT(performance-no-int-to-ptr) */
        bottom++;
    return (uint16_t)(top - bottom);
}

static void write_number(uint16_t number)
{
    char digits[6] = {0};
    for (int i = 4; i >= 0; i--) {
        digits[i] = (char)('0' + number % 10);
        number /= 10;
    }
    board_write(digits);
}

int main(void)
{
    const uint16_t depth_bytes = measure();
    board_write("stack ");
    write_number(depth_bytes);
    board_write("\n");
    return depth_bytes > 0 ? BOARD_SUCCESS : BOARD_FAILURE;
}
