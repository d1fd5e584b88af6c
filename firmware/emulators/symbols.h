/* symbols.h: the functions of an image, by name and by address, from the ELF file's symbol table. */
#ifndef TWIDDLE_SYMBOLS_H
#define TWIDDLE_SYMBOLS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Functions in one image at most. */
#define SYMBOLS_MAX 4096

/* A function of the image. */
struct function_symbol {
    /* Lives as long as the program: the file is kept in memory. */
    const char *name;
    /* Of its first instruction. */
    uint32_t address;
    /* Bytes; 0 if the file does not say, as for some functions written in assembler. */
    uint32_t size;
};

/* All functions of an image, by ascending address; those at one address by name. */
struct symbol_table {
    /* EM_ARM, EM_AVR, ... of <elf.h>. */
    uint16_t machine;
    size_t count;
    struct function_symbol function[SYMBOLS_MAX];
};

/* Read the functions of the ELF file `path`. On failure, false and a sentence in `error`, [error_size]. */
bool symbols_read(struct symbol_table *table, const char *path, char *error, size_t error_size);

/* The function called `name`, or NULL. A function of the C libraries may go by its name in the source, without what its
 * build appends (twiddle/detail/build.h). */
const struct function_symbol *symbols_by_name(const struct symbol_table *table, const char *name);

/* The function that holds the instruction at `address`, or NULL. */
const struct function_symbol *symbols_by_address(const struct symbol_table *table, uint32_t address);

#endif
