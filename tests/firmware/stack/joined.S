/* Assembly as in C libraries, without frames on record. `joined` pushes, jumps to `joint`, which pushes again, calls
 * `leaf` and jumps back to the middle of `joined`, which takes everything off. */
    .section .text
    .global joined
    .global main
#if defined(__AVR__)
/* 2 bytes of return address, 2 pushed, 1 pushed, 2 of return address: 7; with main's return address 9. */
    .type joined, @function
joined:
    push r16
    push r17
    rjmp joint
back:
    pop r18
    pop r17
    pop r16
    ret
joint:
    push r18
    rcall leaf
    sbrc r18, 7
    rjmp back
    rjmp back
leaf:
    ret
main:
    rcall joined
    ret
#elif defined(__riscv)
/* 16 and 32 bytes: 48; main has 16: 64. */
    .type joined, @function
    .type main, @function
joined:
    addi sp, sp, -16
    sw ra, 12(sp)
    j joint
back:
    addi sp, sp, 32
    lw ra, 12(sp)
    addi sp, sp, 16
    ret
joint:
    addi sp, sp, -32
    call leaf
    j back
leaf:
    ret
main:
    addi sp, sp, -16
    sw ra, 12(sp)
    call joined
    lw ra, 12(sp)
    addi sp, sp, 16
    ret
#else
/* 2 and 3 registers: 20 bytes; main has 2: 28. */
    .syntax unified
    .thumb
    .global back
    .type joined, %function
    .type joint, %function
    .type back, %function
    .type leaf, %function
    .type main, %function
joined:
    push {r4, lr}
    b joint
back:
    pop {r5, r6, r7}
    pop {r4, pc}
joint:
    push {r5, r6, r7}
    bl leaf
    b back
leaf:
    bx lr
main:
    push {r4, lr}
    bl joined
    pop {r4, pc}
#endif
