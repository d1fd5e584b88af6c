/* call_counter.h: what calls of chosen functions cost, and at which instructions the cost arises.
 *
 * Fed with every instruction that an emulator executes. A call of a counted function lasts from its first instruction
 * until the instruction behind the call is reached: the function's own instructions with its return, and those of all
 * that it calls, but not the call itself. A counted function may call another one; a call of itself is not told apart.
 * The cost is in whatever the emulator counts, instructions or cycles. */
#ifndef TWIDDLE_CALL_COUNTER_H
#define TWIDDLE_CALL_COUNTER_H

#include "symbols.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* Functions that one counter counts, and places of 2 bytes in an image's code. */
#define COUNTED_CALLS_MAX 16
#define CODE_PLACES_MAX (512 * 1024 / 2)

/* A counted function. */
struct counted_call {
    const struct function_symbol *function;
    /* Of what was asked for, which the function's name begins with. */
    int name_length;
    /* A call has begun and not ended. */
    bool inside;
    /* Where the call ends. */
    uint32_t return_address;
    /* The total cost when it began. */
    uint64_t begin;
    /* That ended. */
    uint64_t calls;
    /* Of all calls that ended. */
    uint64_t cost;
    /* Cost of a call. */
    uint64_t least;
    uint64_t most;
    /* Cost that arose at each place, from the image's first function. */
    uint64_t part[CODE_PLACES_MAX];
    /* Cost that arose outside these places. */
    uint64_t elsewhere;
};

/* The counter. Big, and all zero at first: a static variable. */
struct call_counter {
    struct symbol_table symbols;
    size_t counted;
    struct counted_call call[COUNTED_CALLS_MAX];
    /* Calls that have begun and not ended. */
    size_t inside;
    /* Of the last instruction. */
    uint32_t address;
    /* Behind it. */
    uint32_t next_address;
    /* The total cost before it. */
    uint64_t total;
};

/* Make `counter`, all zero, a counter for the ELF file `image` that counts nothing yet. On failure, false and a
 * sentence in `error`. */
bool call_counter_make(struct call_counter *counter, const char *image, char *error, size_t error_size);

/* Count calls of `function`, too: a name that symbols_by_name finds. On failure, false and a sentence in `error`. */
bool call_counter_add(struct call_counter *counter, const char *function, char *error, size_t error_size);

/* The instruction at `address`, of `size` bytes, is about to be executed; everything before it cost `total`. */
void call_counter_instruction(struct call_counter *counter, uint32_t address, uint32_t size, uint64_t total);

/* What a row of `part` is. */
enum call_counter_parts { PARTS_BY_FUNCTION = 0, PARTS_BY_ADDRESS = 1 };

/* Write what was counted as CSV: a row a counted function with an empty `part`, then a row a function, or an address
 * of an instruction, where its cost arose. `unit` is what was counted. */
void call_counter_write(const struct call_counter *counter, const char *unit, enum call_counter_parts parts,
                        FILE *file);

#endif
