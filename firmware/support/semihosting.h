/* semihosting.h: one call to the debugger or emulator that runs the image. */
#ifndef TWIDDLE_FIRMWARE_SEMIHOSTING_H
#define TWIDDLE_FIRMWARE_SEMIHOSTING_H

#include <stdint.h>

/* Ask for `operation` with its block of arguments; returns the answer. Without a debugger or emulator it is a fault. */
static inline uintptr_t semihosting_call(uintptr_t operation, const uintptr_t *block)
{
#if defined(__riscv)
    register uintptr_t a0 __asm__("a0") = operation;
    register const uintptr_t *a1 __asm__("a1") = block;
    /* These three, uncompressed and in one page, are the call's signature. */
    __asm__ volatile(".option push\n"
                     ".option norvc\n"
                     ".balign 16\n"
                     "slli x0, x0, 0x1f\n"
                     "ebreak\n"
                     "srai x0, x0, 7\n"
                     ".option pop\n"
                     : "+r"(a0)
                     : "r"(a1)
                     : "memory");
    return a0;
#else
    register uintptr_t r0 __asm__("r0") = operation;
    register const uintptr_t *r1 __asm__("r1") = block;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
#endif
}

#endif
