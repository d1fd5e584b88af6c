/* known_costs.S: functions whose cost follows from the instruction set, by hand:
 *
 *                              loop_of_100   calls_it_twice         loop_of(n)
 *   Arm, instructions          202           408 (4 of its own)     2 n + 1
 *   RISC-V, instructions       202           411 (7 of its own)     2 n + 1
 *   AVR, cycles                304           618 (10 of its own)    3 n + 3
 *
 * AVR: DEC and LDI take 1 cycle, BRNE 2 if taken and 1 if not, RCALL 3, RET 4 (with a program counter of 16 bits). */

.macro begin name
.text
.global \name
.type \name, %function
.balign 4
\name:
.endm

.macro end name
.size \name, . - \name
.endm

#if defined(__arm__)

.syntax unified
.thumb

.thumb_func
begin loop_of_100
    movs r0, #100
1:  subs r0, #1
    bne 1b
    bx lr
end loop_of_100

.thumb_func
begin calls_it_twice
    push {r4, lr}
    bl loop_of_100
    bl loop_of_100
    pop {r4, pc}
end calls_it_twice

.thumb_func
begin loop_of
1:  subs r0, #1
    bne 1b
    bx lr
end loop_of

#elif defined(__riscv)

begin loop_of_100
    li a0, 100
1:  addi a0, a0, -1
    bnez a0, 1b
    ret
end loop_of_100

begin calls_it_twice
    addi sp, sp, -16
    sw ra, 12(sp)
    jal loop_of_100
    jal loop_of_100
    lw ra, 12(sp)
    addi sp, sp, 16
    ret
end calls_it_twice

begin loop_of
1:  addi a0, a0, -1
    bnez a0, 1b
    ret
end loop_of

#elif defined(__AVR__)

begin loop_of_100
    ldi r24, 100
1:  dec r24
    brne 1b
    ret
end loop_of_100

begin calls_it_twice
    rcall loop_of_100
    rcall loop_of_100
    ret
end calls_it_twice

begin loop_of
1:  dec r24
    brne 1b
    ret
end loop_of

#endif
