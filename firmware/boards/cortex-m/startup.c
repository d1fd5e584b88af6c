/* Start-up of a Cortex-M: the vector table, the FPU where there is one, memory, main. */
#include "board.h"
#include "memory.h"

#include <stdint.h>

extern int main(void);
extern uint32_t board_stack_top[]; /* by boards/sections.ld */

static void run(void)
{
#ifdef __ARM_FP
    volatile uint32_t *const coprocessor_access = (volatile uint32_t *)0xE000ED88;
    *coprocessor_access |= UINT32_C(0xF) << 20; /* full access to the FPU */
    __asm__ volatile("dsb\n"
                     "isb\n" ::
                         : "memory");
#endif
    board_fill_memory();
    board_exit(main());
}

static void fault(void)
{
    board_write("the processor met a fault\n");
    board_exit(BOARD_FAULT);
}

/* What the processor reads at reset and on its own exceptions; no interrupt is ever enabled. */
static const struct {
    uint32_t *stack_top;
    void (*handler[15])(void);
} vectors __attribute__((section(".start"), used)) = {
    board_stack_top,
    {run, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault},
};
