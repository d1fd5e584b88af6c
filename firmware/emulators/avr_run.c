/* avr_run.c: runs an image for the ATmega1284P in simavr, and counts the cycles of calls of chosen functions.
 *
 *     avr_run [--count FUNCTION]... [--out FILE] [--by-address] [--cycles N] [--stdin] IMAGE
 *
 * What the image sends through UART0 goes to standard output; with --stdin, standard input goes to the UART. The exit
 * status is the one that the image leaves in GPIOR0 when it sleeps with interrupts off. An image that crashes, that
 * stops in a loop of one instruction with interrupts off, or that is not done after N cycles ends with status 3. FILE
 * is the CSV of call_counter.h, with its parts by function, or by address. */
#include "avr_uart_pipe.h"
#include "call_counter.h"

#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>

#include <elf.h>
#include <errno.h>
#include <getopt.h>
#include <inttypes.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { FAILURE = 1, WRONG_USE = 2, FAULT = 3 };

/* The clock for which images set their baud rate. */
enum { FREQUENCY_HZ = 16000000 };

/* Data address of the register for the status. */
enum { GPIOR0_ADDRESS = 0x3E };

/* Cycles from one look at standard input to the next; a byte takes 1,400 at 115,200 baud. */
enum { INPUT_CYCLES = 700 };

#define USAGE "usage: avr_run [--count FUNCTION]... [--out FILE] [--by-address] [--cycles N] [--stdin] IMAGE"

struct options {
    const char *out;
    enum call_counter_parts parts;
    const char *image;
    avr_cycle_count_t cycles; /* most; 0: any number */
    bool with_stdin;
    size_t functions;
    const char *function[COUNTED_CALLS_MAX];
};

static struct call_counter counter;

static void fail(int status, const char *format, ...) __attribute__((format(printf, 2, 3), noreturn));

static void fail(int status, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    avr_uart_pipe_flush();
    fputs("avr_run: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(status);
}

static avr_cycle_count_t read_cycles(const char *text)
{
    char *end;
    errno = 0;
    const unsigned long long cycles = strtoull(text, &end, 10);
    if (text[0] < '0' || text[0] > '9' || *end != '\0' || errno != 0 || cycles == 0)
        fail(WRONG_USE, "--cycles expects a whole number above 0, not '%s'", text);
    return cycles;
}

static struct options read_options(int argc, char **argv)
{
    static const struct option known[] = {
        {"count", required_argument, NULL, 'c'}, {"out", required_argument, NULL, 'o'},
        {"by-address", no_argument, NULL, 'a'},  {"cycles", required_argument, NULL, 'n'},
        {"stdin", no_argument, NULL, 'i'},       {NULL, 0, NULL, 0}};
    struct options options = {.functions = 0};
    for (int option = 0; (option = getopt_long(argc, argv, "", known, NULL)) != -1;) {
        if (option == '?') fail(WRONG_USE, USAGE);
        if (option == 'c' && options.functions == COUNTED_CALLS_MAX)
            fail(WRONG_USE, "%d functions at most can be counted at once", COUNTED_CALLS_MAX);
        if (option == 'c') options.function[options.functions++] = optarg;
        if (option == 'o') options.out = optarg;
        if (option == 'a') options.parts = PARTS_BY_ADDRESS;
        if (option == 'n') options.cycles = read_cycles(optarg);
        if (option == 'i') options.with_stdin = true;
    }
    if (argc - optind != 1) fail(WRONG_USE, USAGE);
    if ((options.functions > 0) != (options.out != NULL)) fail(WRONG_USE, "--count and --out need each other");
    options.image = argv[optind];
    return options;
}

static void prepare_counter(const struct options *options)
{
    char error[512];
    if (!call_counter_make(&counter, options->image, error, sizeof error)) fail(WRONG_USE, "%s", error);
    if (counter.symbols.machine != EM_AVR) fail(WRONG_USE, "%s is not an image for an AVR", options->image);
    for (size_t i = 0; i < options->functions; i++)
        if (!call_counter_add(&counter, options->function[i], error, sizeof error)) fail(WRONG_USE, "%s", error);
}

/* simavr would say on standard output what it loads. */
static void log_errors(avr_t *avr, const int level, const char *format, va_list arguments)
{
    (void)avr;
    if (level <= LOG_ERROR) vfprintf(stderr, format, arguments);
}

/* The board with the image in its flash. */
static avr_t *make_avr(const struct options *options)
{
    static elf_firmware_t firmware;
    avr_global_logger_set(log_errors);
    if (elf_read_firmware(options->image, &firmware) != 0 || firmware.flashsize == 0)
        fail(WRONG_USE, "simavr cannot load %s", options->image);
    avr_t *const avr = avr_make_mcu_by_name("atmega1284p");
    if (avr == NULL) fail(FAILURE, "this simavr knows no atmega1284p");
    avr_init(avr);
    avr->frequency = FREQUENCY_HZ;
    firmware.frequency = FREQUENCY_HZ;
    avr_load_firmware(avr, &firmware);
    /* One instruction a call of avr_run, so that each is seen. */
    if (options->functions > 0) avr->run_cycle_limit = 1;
    avr_uart_pipe_join(avr);
    return avr;
}

static uint16_t opcode_at(const avr_t *avr, avr_flashaddr_t address)
{
    return (uint16_t)(avr->flash[address] | avr->flash[address + 1] << 8);
}

/* In bytes: LDS, STS, JMP and CALL have two words. */
static uint32_t instruction_size(uint16_t opcode)
{
    const bool is_lds_or_sts = (opcode & 0xFC0F) == 0x9000;
    const bool is_jmp_or_call = (opcode & 0xFE0C) == 0x940C;
    return is_lds_or_sts || is_jmp_or_call ? 4 : 2;
}

/* `rjmp .` with interrupts off, where avr-libc's exit and many a fault handler end. */
static bool stopped_for_ever(const avr_t *avr)
{
    return opcode_at(avr, avr->pc) == 0xCFFF && !avr->sreg[S_I];
}

/* Run to the end; returns the image's status. */
static int run(avr_t *avr, const struct options *options)
{
    avr_cycle_count_t next_input = options->with_stdin ? 0 : UINT64_MAX;
    int state = cpu_Running;
    while (state != cpu_Done) {
        if (options->functions > 0)
            call_counter_instruction(&counter, avr->pc, instruction_size(opcode_at(avr, avr->pc)), avr->cycle);
        state = avr_run(avr);
        if (state == cpu_Crashed) fail(FAULT, "%s crashed at address 0x%04x", options->image, avr->pc);
        if (stopped_for_ever(avr)) fail(FAULT, "%s stopped at address 0x%04x", options->image, avr->pc);
        if (options->cycles > 0 && avr->cycle > options->cycles)
            fail(FAULT, "%s is not done after %" PRIu64 " cycles", options->image, options->cycles);
        if (avr->cycle >= next_input) {
            avr_uart_pipe_feed();
            next_input = avr->cycle + INPUT_CYCLES;
        }
    }
    return avr->data[GPIOR0_ADDRESS];
}

static void write_counts(const struct options *options)
{
    FILE *const file = fopen(options->out, "w");
    if (file != NULL) call_counter_write(&counter, "cycles", options->parts, file);
    if (file == NULL || fclose(file) != 0) fail(FAILURE, "cannot write %s", options->out);
}

int main(int argc, char **argv)
{
    const struct options options = read_options(argc, argv);
    prepare_counter(&options);
    const int status = run(make_avr(&options), &options);
    if (!avr_uart_pipe_flush()) fail(FAILURE, "cannot write the image's output");
    if (options.out != NULL) write_counts(&options);
    return status;
}
