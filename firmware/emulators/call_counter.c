#include "call_counter.h"

#include <inttypes.h>
#include <string.h>

bool call_counter_make(struct call_counter *counter, const char *image, char *error, size_t error_size)
{
    memset(counter, 0, sizeof *counter);
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
    call->least = UINT64_MAX;
    return true;
}

/* Whether `function` holds `address`; faster than to look it up again. */
static bool holds(const struct function_symbol *function, uint32_t address)
{
    return function != NULL && address - function->address < function->size;
}

/* Add the last instruction's cost to the calls that it belongs to. */
static void add_cost(struct call_counter *counter, uint64_t cost)
{
    for (size_t i = 0; i < counter->counted; i++) {
        struct counted_call *const call = &counter->call[i];
        if (!call->inside) continue;
        if (counter->function == NULL)
            call->elsewhere += cost;
        else
            call->part[counter->function - counter->symbols.function] += cost;
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
    if (counter->inside > 0 && !holds(counter->function, address))
        counter->function = symbols_by_address(&counter->symbols, address);
    counter->next_address = address + size;
    counter->total = total;
}

static void write_call(const struct call_counter *counter, const struct counted_call *call, FILE *file)
{
    const char *const name = call->function->name;
    fprintf(file, "%s,,%" PRIu64 ",%" PRIu64 ",%" PRIu64 ",%" PRIu64 "\n", name, call->calls, call->cost,
            call->calls > 0 ? call->least : 0, call->most);
    for (size_t i = 0; i < counter->symbols.count; i++)
        if (call->part[i] > 0)
            fprintf(file, "%s,%s,,%" PRIu64 ",,\n", name, counter->symbols.function[i].name, call->part[i]);
    if (call->elsewhere > 0) fprintf(file, "%s,(elsewhere),,%" PRIu64 ",,\n", name, call->elsewhere);
}

void call_counter_write(const struct call_counter *counter, const char *unit, FILE *file)
{
    fprintf(file, "# %s of calls, from a function's first instruction to its return; `part`: where they arose\n", unit);
    fprintf(file, "function,part,calls,total,least,most\n");
    for (size_t i = 0; i < counter->counted; i++)
        write_call(counter, &counter->call[i], file);
}
