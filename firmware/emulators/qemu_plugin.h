/* qemu_plugin.h: the part of QEMU's plugin interface, version 1, that instruction_counter.c uses.
 *
 * QEMU 7.2 as Debian builds it loads plugins but ships no header. These declarations follow the interface as QEMU
 * documents it ("QEMU TCG Plugins" in its developers' manual); QEMU itself defines the functions, and checks
 * `qemu_plugin_version` when it loads a plugin. */
#ifndef TWIDDLE_QEMU_PLUGIN_H
#define TWIDDLE_QEMU_PLUGIN_H

#include <stddef.h>
#include <stdint.h>

#define QEMU_PLUGIN_VERSION 1
#define QEMU_PLUGIN_EXPORT __attribute__((visibility("default")))

typedef uint64_t qemu_plugin_id_t;

/* Of the machine to be emulated; nothing of it is used. */
struct qemu_info_t;

/* A block of guest instructions that QEMU has just translated, and one of them; both live as long as the callback. */
struct qemu_plugin_tb;
struct qemu_plugin_insn;

/* Whether a callback looks at the guest's registers. */
enum qemu_plugin_cb_flags { QEMU_PLUGIN_CB_NO_REGS = 0 };

typedef void (*qemu_plugin_vcpu_tb_trans_cb_t)(qemu_plugin_id_t id, struct qemu_plugin_tb *block);
typedef void (*qemu_plugin_vcpu_udata_cb_t)(unsigned int cpu, void *data);
typedef void (*qemu_plugin_udata_cb_t)(qemu_plugin_id_t id, void *data);

/* What a plugin exports. Install returns 0, or QEMU refuses to start. */
QEMU_PLUGIN_EXPORT extern int qemu_plugin_version;
QEMU_PLUGIN_EXPORT int qemu_plugin_install(qemu_plugin_id_t id, const struct qemu_info_t *info, int argc, char **argv);

/* Call `callback` whenever a block is translated. */
void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t id, qemu_plugin_vcpu_tb_trans_cb_t callback);

/* Call `callback` before each execution of `instruction`. */
void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn *instruction, qemu_plugin_vcpu_udata_cb_t callback,
                                            enum qemu_plugin_cb_flags flags, void *data);

/* Call `callback` when QEMU ends. */
void qemu_plugin_register_atexit_cb(qemu_plugin_id_t id, qemu_plugin_udata_cb_t callback, void *data);

/* The instructions of a block, and their addresses and sizes in bytes. */
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *block);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *block, size_t index);
uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *instruction);
size_t qemu_plugin_insn_size(const struct qemu_plugin_insn *instruction);

#endif
