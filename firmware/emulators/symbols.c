#include "symbols.h"

#include <fcntl.h>
#include <gelf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The file's section of symbols, or NULL. */
static Elf_Scn *symbol_section(Elf *elf, GElf_Shdr *header)
{
    Elf_Scn *section = NULL;
    while ((section = elf_nextscn(elf, section)) != NULL)
        if (gelf_getshdr(section, header) != NULL && header->sh_type == SHT_SYMTAB) return section;
    return NULL;
}

static int compare(const void *left, const void *right)
{
    const struct function_symbol *const a = left;
    const struct function_symbol *const b = right;
    if (a->address != b->address) return a->address < b->address ? -1 : 1;
    return strcmp(a->name, b->name);
}

/* Functions written in assembler may have no type: libgcc's for the AVR. What has none and is local is a mere label. */
static bool is_function(Elf *elf, const GElf_Sym *symbol)
{
    GElf_Shdr section;
    const unsigned type = GELF_ST_TYPE(symbol->st_info);
    const bool may_be = type == STT_FUNC || (type == STT_NOTYPE && GELF_ST_BIND(symbol->st_info) == STB_GLOBAL);
    if (!may_be || symbol->st_shndx == SHN_UNDEF || symbol->st_shndx >= SHN_LORESERVE) return false;
    return gelf_getshdr(elf_getscn(elf, symbol->st_shndx), &section) != NULL && (section.sh_flags & SHF_EXECINSTR);
}

/* Take the functions of `section` into `table`; false if there are too many. */
static bool take_functions(struct symbol_table *table, Elf *elf, Elf_Scn *section, const GElf_Shdr *header)
{
    GElf_Ehdr file;
    Elf_Data *const data = elf_getdata(section, NULL);
    if (data == NULL || gelf_getehdr(elf, &file) == NULL) return true;
    table->machine = file.e_machine;

    GElf_Sym symbol;
    for (int i = 0; gelf_getsym(data, i, &symbol) != NULL; i++) {
        if (!is_function(elf, &symbol)) continue;
        if (table->count == SYMBOLS_MAX) return false;
        struct function_symbol *const function = &table->function[table->count++];
        function->name = elf_strptr(elf, header->sh_link, symbol.st_name);
        /* On ARM the lowest bit says that the function is Thumb code. */
        function->address = (uint32_t)symbol.st_value & (file.e_machine == EM_ARM ? ~UINT32_C(1) : ~UINT32_C(0));
        function->size = (uint32_t)symbol.st_size;
    }
    qsort(table->function, table->count, sizeof table->function[0], compare);
    return true;
}

bool symbols_read(struct symbol_table *table, const char *path, char *error, size_t error_size)
{
    table->count = 0;
    elf_version(EV_CURRENT);
    const int file = open(path, O_RDONLY);
    Elf *const elf = file < 0 ? NULL : elf_begin(file, ELF_C_READ_MMAP, NULL);
    GElf_Shdr header;
    Elf_Scn *const section = elf == NULL ? NULL : symbol_section(elf, &header);
    const bool fits = section != NULL && take_functions(table, elf, section, &header);
    if (file >= 0) close(file);

    if (table->count > 0 && fits) return true;
    if (section != NULL && !fits)
        snprintf(error, error_size, "%s has more than %d functions", path, SYMBOLS_MAX);
    else
        snprintf(error, error_size, "%s is not an ELF file with a symbol table of functions", path);
    return false;
}

/* Whether a build makes `symbol` of the source's `name`: it appends the number type, perhaps with more behind it. */
static bool is_build_of(const char *symbol, const char *name)
{
    static const char *const number[] = {"_float", "_double", "_fixed"};
    const size_t length = strlen(name);
    if (strncmp(symbol, name, length) != 0) return false;
    for (size_t i = 0; i < sizeof number / sizeof number[0]; i++) {
        const size_t type_length = strlen(number[i]);
        if (strncmp(symbol + length, number[i], type_length) != 0) continue;
        const char after = symbol[length + type_length];
        if (after == '\0' || after == '_') return true;
    }
    return false;
}

const struct function_symbol *symbols_by_name(const struct symbol_table *table, const char *name)
{
    const struct function_symbol *of_a_build = NULL;
    for (size_t i = 0; i < table->count; i++) {
        if (strcmp(table->function[i].name, name) == 0) return &table->function[i];
        if (is_build_of(table->function[i].name, name)) of_a_build = &table->function[i];
    }
    return of_a_build;
}

const struct function_symbol *symbols_by_address(const struct symbol_table *table, uint32_t address)
{
    size_t begin = 0; /* how many functions surely start at or before the address */
    size_t end = table->count;
    while (begin < end) {
        const size_t middle = begin + (end - begin) / 2;
        if (table->function[middle].address <= address)
            begin = middle + 1;
        else
            end = middle;
    }
    if (begin == 0) return NULL;

    const struct function_symbol *function = &table->function[begin - 1];
    while (function > table->function && function[-1].address == function->address)
        function--;
    const bool inside = function->size == 0 || address - function->address < function->size;
    return inside ? function : NULL;
}
