#include "call_counter.h"

#include <inttypes.h>
#include <string.h>

bool call_counter_make(struct call_counter *counter, const char *image, char *error, size_t error_size)
{
    return symbols_read(&counter->symbols, image, error, error_size);
}

bool call_counter_add(struct call_counter *counter, const char *function, char *error, size_t error_size)
{
    if (counter->counted == COUNTED_CALLS_MAX) {
        snprintf(error, error_size, "%d functions at most can be counted at once", COUNTED_CALLS_MAX);
        return false;
    }
    const struct function_symbol *const symbol = symbols_by_name(&counter->symbols, function);
    if (symbol == NULL) {
        snprintf(error, error_size, "the image has no function %s to count", function);
        return false;
    }
    struct counted_call *const call = &counter->call[counter->counted++];
    call->function = symbol;
    call->name_length = (int)strlen(function);
    call->least = UINT64_MAX;
    return true;
}

/* Add the last instruction's cost to the calls that it belongs to. */
static void add_cost(struct call_counter *counter, uint64_t cost)
{
    const uint32_t place = (counter->address - counter->symbols.function[0].address) / 2;
    for (size_t i = 0; i < counter->counted; i++) {
        struct counted_call *const call = &counter->call[i];
        if (!call->inside) continue;
        if (place < CODE_PLACES_MAX)
            call->part[place] += cost;
        else
            call->elsewhere += cost;
    }
}

/* End the calls whose return address is reached, begin those whose first instruction is. */
static void begin_and_end(struct call_counter *counter, uint32_t address, uint64_t total)
{
    for (size_t i = 0; i < counter->counted; i++) {
        struct counted_call *const call = &counter->call[i];
        if (call->inside && address == call->return_address) {
            const uint64_t cost = total - call->begin;
            call->inside = false;
            call->calls++;
            call->cost += cost;
            if (cost < call->least) call->least = cost;
            if (cost > call->most) call->most = cost;
            counter->inside--;
        }
        if (!call->inside && address == call->function->address) {
            call->inside = true;
            call->return_address = counter->next_address;
            call->begin = total;
            counter->inside++;
        }
    }
}

void call_counter_instruction(struct call_counter *counter, uint32_t address, uint32_t size, uint64_t total)
{
    if (counter->inside > 0) add_cost(counter, total - counter->total);
    begin_and_end(counter, address, total);
    counter->address = address;
    counter->next_address = address + size;
    counter->total = total;
}

static void write_part(const struct counted_call *call, const char *part, uint64_t cost, FILE *file)
{
    if (cost > 0) fprintf(file, "%.*s,%s,,%" PRIu64 ",,\n", call->name_length, call->function->name, part, cost);
}

static void write_addresses(const struct counted_call *call, uint32_t first_address, FILE *file)
{
    for (uint32_t place = 0; place < CODE_PLACES_MAX; place++) {
        char address[16];
        snprintf(address, sizeof address, "0x%08" PRIx32, first_address + 2 * place);
        write_part(call, address, call->part[place], file);
    }
}

/* Neighbouring places of one function make one row. */
static void write_functions(const struct counted_call *call, const struct symbol_table *symbols, FILE *file)
{
    const struct function_symbol *last = NULL;
    uint64_t cost = 0;
    uint64_t elsewhere = call->elsewhere;
    for (uint32_t place = 0; place < CODE_PLACES_MAX; place++) {
        if (call->part[place] == 0) continue;
        const struct function_symbol *const function =
            symbols_by_address(symbols, symbols->function[0].address + 2 * place);
        if (function == NULL) {
            elsewhere += call->part[place];
            continue;
        }
        if (last != NULL && function != last) {
            write_part(call, last->name, cost, file);
            cost = 0;
        }
        last = function;
        cost += call->part[place];
    }
    if (last != NULL) write_part(call, last->name, cost, file);
    write_part(call, "(elsewhere)", elsewhere, file);
}

void call_counter_write(const struct call_counter *counter, const char *unit, enum call_counter_parts parts, FILE *file)
{
    fprintf(file, "# %s of calls, from a function's first instruction to its return; `part`: where they arose\n", unit);
    fprintf(file, "function,part,calls,total,least,most\n");
    for (size_t i = 0; i < counter->counted; i++) {
        const struct counted_call *const call = &counter->call[i];
        fprintf(file, "%.*s,,%" PRIu64 ",%" PRIu64 ",%" PRIu64 ",%" PRIu64 "\n", call->name_length,
                call->function->name, call->calls, call->cost, call->calls > 0 ? call->least : 0, call->most);
        if (parts == PARTS_BY_ADDRESS)
            write_addresses(call, counter->symbols.function[0].address, file);
        else
            write_functions(call, &counter->symbols, file);
    }
}
