/* memory.h: what an image finds in RAM before main, on boards linked by boards/sections.ld. */
#ifndef TWIDDLE_FIRMWARE_MEMORY_H
#define TWIDDLE_FIRMWARE_MEMORY_H

/* Give variables their first values: .data from flash, .bss zero. */
void board_fill_memory(void);

#endif
