/* instruction_counter.c: a QEMU plugin that counts the instructions of calls of chosen functions, to the instruction.
 *
 *     -plugin instruction_counter.so,image=FILE,count=FUNCTION[,count=FUNCTION...],out=FILE[,parts=address]
 *
 * `image` is the ELF file that runs, `out` the CSV that is written when QEMU ends (call_counter.h), with its parts by
 * function, or by address. An instruction whose
 * condition fails counts, as it does on the chip. For boards with one core and addresses of 32 bits. */
#include "qemu_plugin.h"

#include "call_counter.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

int qemu_plugin_version = QEMU_PLUGIN_VERSION;

static struct call_counter counter;
static uint64_t executed;
static const char *out;
static enum call_counter_parts parts;

/* Where an instruction is; travels as the bits of the pointer that QEMU hands to its callback. */
struct place {
    uint32_t address;
    uint32_t size;
};
typedef char a_pointer_holds_a_place[sizeof(void *) == sizeof(struct place) ? 1 : -1];

static void before_instruction(unsigned int cpu, void *data)
{
    (void)cpu;
    struct place place;
    memcpy(&place, &data, sizeof place);
    call_counter_instruction(&counter, place.address, place.size, executed);
    executed++;
}

static void after_translation(qemu_plugin_id_t id, struct qemu_plugin_tb *block)
{
    (void)id;
    const size_t count = qemu_plugin_tb_n_insns(block);
    for (size_t i = 0; i < count; i++) {
        struct qemu_plugin_insn *const instruction = qemu_plugin_tb_get_insn(block, i);
        const struct place place = {(uint32_t)qemu_plugin_insn_vaddr(instruction),
                                    (uint32_t)qemu_plugin_insn_size(instruction)};
        void *data;
        memcpy(&data, &place, sizeof data);
        qemu_plugin_register_vcpu_insn_exec_cb(instruction, before_instruction, QEMU_PLUGIN_CB_NO_REGS, data);
    }
}

static void refuse(int status, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fputs("instruction_counter: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(status);
}

static void at_exit(qemu_plugin_id_t id, void *data)
{
    (void)id;
    (void)data;
    FILE *const file = fopen(out, "w");
    if (file != NULL) call_counter_write(&counter, "instructions", parts, file);
    /* QEMU is ending, with the image's exit status: a missing file must be told from here. */
    if (file == NULL || fclose(file) != 0) fprintf(stderr, "instruction_counter: cannot write %s\n", out);
}

/* The value of `argument` if it is NAME=VALUE, otherwise NULL. */
static const char *value_of(const char *argument, const char *name)
{
    const size_t length = strlen(name);
    return strncmp(argument, name, length) == 0 && argument[length] == '=' ? argument + length + 1 : NULL;
}

static void read_arguments(int argc, char **argv)
{
    char error[512];
    const char *image = NULL;
    for (int i = 0; i < argc; i++) {
        if (value_of(argv[i], "image")) image = value_of(argv[i], "image");
        if (value_of(argv[i], "out")) out = value_of(argv[i], "out");
        if (strcmp(argv[i], "parts=address") == 0) parts = PARTS_BY_ADDRESS;
    }
    if (image == NULL || out == NULL) refuse(2, "expected image=FILE and out=FILE");
    out = strdup(out);
    if (out == NULL) refuse(1, "out of memory");
    if (!call_counter_make(&counter, image, error, sizeof error)) refuse(2, "%s", error);
    for (int i = 0; i < argc; i++) {
        const char *const function = value_of(argv[i], "count");
        if (function != NULL && !call_counter_add(&counter, function, error, sizeof error)) refuse(2, "%s", error);
    }
}

int qemu_plugin_install(qemu_plugin_id_t id, const struct qemu_info_t *info, int argc, char **argv)
{
    (void)info;
    read_arguments(argc, argv);
    qemu_plugin_register_vcpu_tb_trans_cb(id, after_translation);
    qemu_plugin_register_atexit_cb(id, at_exit, NULL);
    return 0;
}
