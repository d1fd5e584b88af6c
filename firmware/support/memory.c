#include "memory.h"

#include <stdint.h>

/* By boards/sections.ld; all multiples of 8 bytes. */
extern uint32_t board_data_start[], board_data_end[], board_bss_start[], board_bss_end[];
extern const uint32_t board_data_source[];

void board_fill_memory(void)
{
    const uint32_t *source = board_data_source;
    for (uint32_t *word = board_data_start; word < board_data_end; word++)
        *word = *source++;
    for (uint32_t *word = board_bss_start; word < board_bss_end; word++)
        *word = 0;
}
