/* Start-up of QEMU's riscv32 `virt`: one hart, machine mode. */
#include "board.h"
#include "memory.h"

extern int main(void);

/* Any trap is a fault; no interrupt is ever enabled. The two lowest bits of mtvec are no part of the address. */
__attribute__((interrupt("machine"), aligned(4))) static void fault(void)
{
    board_write("the processor met a fault\n");
    board_exit(BOARD_FAULT);
}

__attribute__((used)) static void run(void)
{
    __asm__ volatile(".option push\n"
                     ".option arch, +zicsr\n"
                     "csrw mtvec, %0\n"
                     ".option pop\n" ::"r"(fault));
    board_fill_memory();
    board_exit(main());
}

/* The first instructions: registers that compiled code relies on. */
__attribute__((naked, used, section(".start"))) static void start(void)
{
    __asm__ volatile(".option push\n"
                     ".option norelax\n"
                     "la gp, __global_pointer$\n"
                     ".option pop\n"
                     "la sp, board_stack_top\n"
                     "la tp, board_thread_start\n"
                     "j %0\n" ::"i"(run));
}
