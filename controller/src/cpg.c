#include <twiddle/cpg.h>

#include <twiddle/phase.h>

#include "checks.h"
#include "cpg_offsets.h"
#include "four_oscillators.h"

/* A coupling pulls by at most R = 0.5 rad/s, the extrapolation at most doubles the sum, and a rate must stay below 16
 * rad/s. */
#if defined(TWD_NUMBER_FIXED) && TWD_MAX_COUPLINGS > 15
#error "TWD_MAX_COUPLINGS is at most 15 in the fixed build"
#endif

static uint16_t offset_of(int index)
{
    return (uint16_t)((unsigned)index * sizeof(struct twd_oscillator));
}

/* Append a network; what it holds has been checked. */
static void append(struct twd_cpg *cpg, const struct twd_topology *topology)
{
    cpg->topology[cpg->networks++] = topology;
    for (uint8_t k = 0; k < topology->couplings; k++) {
        struct twd_running_coupling *const coupling = &cpg->coupling[cpg->couplings++];
        coupling->first = offset_of(cpg->oscillators + topology->coupling[k].first);
        coupling->second = offset_of(cpg->oscillators + topology->coupling[k].second);
    }
    cpg->oscillators = (uint8_t)(cpg->oscillators + topology->oscillators);
    cpg->oscillators_end = offset_of(cpg->oscillators);
    cpg->couplings_end = (uint16_t)(cpg->couplings * sizeof cpg->coupling[0]);
}

#if TWD_FOUR_AT_ONCE
static void make_filters(struct twd_four_filters *filters, const struct twd_filter_step *amplitude,
                         const struct twd_filter_step *centre)
{
    filters->from_same = (struct twd_four){{amplitude->error_from_error, amplitude->velocity_from_velocity,
                                            centre->error_from_error, centre->velocity_from_velocity}};
    filters->from_other = (struct twd_four){{amplitude->error_from_velocity, amplitude->velocity_from_error,
                                             centre->error_from_velocity, centre->velocity_from_error}};
}

static void set_filter_targets(struct twd_cpg *cpg)
{
    for (uint8_t i = 0; i < cpg->oscillators; i++) {
        const struct twd_oscillator *const oscillator = &cpg->oscillator[i];
        cpg->filters.target[i] =
            (struct twd_four){{oscillator->amplitude_target, TWD_NUM(0), oscillator->centre_target, TWD_NUM(0)}};
    }
}
#endif

enum twd_error twd_cpg_init_several(struct twd_cpg *cpg, const struct twd_topology *const *topology, size_t networks,
                                    const struct twd_cpg_config *config)
{
    static const struct twd_cpg_drive at_rest[TWD_MAX_CPGS] = {{TWD_NUM(0), {TWD_NUM(0)}, {TWD_NUM(0)}, {0}}};
    static const twd_phase zero_phase[TWD_MAX_OSCILLATORS] = {0};

    const enum twd_error error = twd_check_cpgs(topology, networks, config);
    if (error != TWD_OK) return error;

    cpg->config = *config;
    cpg->amplitude_step = twd_filter_step_make(cpg->config.amplitude_rate_per_s, cpg->config.tick_s);
    cpg->centre_step = twd_filter_step_make(cpg->config.centre_rate_per_s, cpg->config.tick_s);
    cpg->turn_gain = twd_turn_gain_of_tick(cpg->config.tick_s);
#if TWD_FOUR_AT_ONCE
    make_filters(&cpg->filters, &cpg->amplitude_step, &cpg->centre_step);
#endif
    cpg->networks = 0;
    cpg->oscillators = 0;
    cpg->couplings = 0;
    for (size_t n = 0; n < networks; n++)
        append(cpg, topology[n]);
    twd_cpg_start(cpg, at_rest, zero_phase);
    return TWD_OK;
}

enum twd_error twd_cpg_init(struct twd_cpg *cpg, const struct twd_topology *topology,
                            const struct twd_cpg_config *config)
{
    return twd_cpg_init_several(cpg, &topology, 1, config);
}

/* c of oscillator `index` of a network at t = 0. */
static twd_num initial_centre(const struct twd_cpg *cpg, const struct twd_topology *topology, uint8_t index,
                              twd_num target)
{
    if (cpg->config.centre_start == TWD_CENTRE_START_AT_ZERO) return TWD_NUM(0);
    if (cpg->config.centre_start == TWD_CENTRE_START_AT_TARGET) return target;
    return topology->initial_centre[index];
}

static void find_output_with_centre(struct twd_oscillator *oscillator)
{
    oscillator->output =
        twd_oscillator_output_with_centre(oscillator->centre.value, oscillator->amplitude.value, oscillator->phase);
}

static void find_output_without_centre(struct twd_oscillator *oscillator)
{
    oscillator->output = twd_oscillator_output_without_centre(oscillator->amplitude.value, oscillator->phase);
}

/* Start one network's oscillators and couplings, which begin at these. */
static void start_network(const struct twd_cpg *cpg, const struct twd_topology *topology,
                          const struct twd_cpg_drive *drive, struct twd_oscillator *oscillator,
                          struct twd_running_coupling *coupling)
{
    /* All amplitudes are 0 at the start, and so is every pull: the extrapolation starts from its true value. */
    static const struct twd_oscillator at_rest = {
        0,         {TWD_NUM(0), TWD_NUM(0)}, {TWD_NUM(0), TWD_NUM(0)}, TWD_NUM(0), TWD_NUM(0), TWD_WIDE(0), TWD_WIDE(0),
        TWD_NUM(0)};

    for (uint8_t k = 0; k < topology->couplings; k++)
        coupling[k].lag_and_quarter = drive->phase_lag[k] + TWD_QUARTER_TURN;
    for (uint8_t i = 0; i < topology->oscillators; i++, oscillator++) {
        const twd_num centre_target = cpg->config.with_centre ? drive->centre[i] : TWD_NUM(0);
        *oscillator = at_rest;
        oscillator->amplitude_target = drive->amplitude[i];
        oscillator->centre_target = centre_target;
        oscillator->amplitude = twd_filter_start(TWD_NUM(0), drive->amplitude[i]);
        oscillator->centre = twd_filter_start(initial_centre(cpg, topology, i, centre_target), centre_target);
    }
}

void twd_cpg_start(struct twd_cpg *cpg, const struct twd_cpg_drive *drive, const twd_phase *initial_phase)
{
    cpg->intrinsic_advance = twd_phase_from_frequency(drive->frequency_hz, cpg->config.tick_s);

    struct twd_oscillator *oscillator = cpg->oscillator;
    struct twd_running_coupling *coupling = cpg->coupling;
    for (uint8_t n = 0; n < cpg->networks; n++) {
        const struct twd_topology *const topology = cpg->topology[n];
        start_network(cpg, topology, &drive[n], oscillator, coupling);
        oscillator += topology->oscillators;
        coupling += topology->couplings;
    }
    for (uint8_t i = 0; i < cpg->oscillators; i++) {
        cpg->oscillator[i].phase = initial_phase[i];
        if (cpg->config.with_centre)
            find_output_with_centre(&cpg->oscillator[i]);
        else
            find_output_without_centre(&cpg->oscillator[i]);
    }
#if TWD_FOUR_AT_ONCE
    set_filter_targets(cpg);
#endif
}

/* Place the oscillator at one end of `coupling` by the one at its other end; whether there was one to place. */
static bool place_by_coupling(struct twd_coupling coupling, twd_phase phase_lag, bool *placed, twd_phase *phase)
{
    if (placed[coupling.first] == placed[coupling.second]) return false;

    if (placed[coupling.first]) {
        phase[coupling.second] = phase[coupling.first] + phase_lag;
        placed[coupling.second] = true;
        return true;
    }
    phase[coupling.first] = phase[coupling.second] - phase_lag;
    placed[coupling.first] = true;
    return true;
}

void twd_cpg_phases_at_lag(const struct twd_topology *topology, const twd_phase *phase_lag, twd_phase *phase)
{
    bool placed[TWD_MAX_OSCILLATORS] = {false};

    for (uint8_t root = 0; root < topology->oscillators; root++) {
        if (placed[root]) continue;
        phase[root] = 0;
        placed[root] = true;

        bool more = true;
        while (more) {
            more = false;
            for (uint8_t k = 0; k < topology->couplings; k++)
                if (place_by_coupling(topology->coupling[k], phase_lag[k], placed, phase)) more = true;
        }
    }
}

/* Add what the couplings pull, with phi_ji = -phi_ij: the sine of the second direction is the negative of the first. */
static void pull_with_negated_return(struct twd_cpg *cpg)
{
    const struct twd_running_coupling *const end = end_of_couplings(cpg);
    for (const struct twd_running_coupling *coupling = cpg->coupling; coupling < end; coupling++) {
        struct twd_oscillator *const first = at_offset(cpg, coupling->first);
        struct twd_oscillator *const second = at_offset(cpg, coupling->second);
        const twd_num sine = twd_cos(second->phase - first->phase - coupling->lag_and_quarter);
        first->pull += twd_wide_product(second->amplitude.value, sine);
        second->pull -= twd_wide_product(first->amplitude.value, sine);
    }
}

/* The same with phi_ji = phi_ij. */
static void pull_with_equal_return(struct twd_cpg *cpg)
{
    const struct twd_running_coupling *const end = end_of_couplings(cpg);
    for (const struct twd_running_coupling *coupling = cpg->coupling; coupling < end; coupling++) {
        struct twd_oscillator *const first = at_offset(cpg, coupling->first);
        struct twd_oscillator *const second = at_offset(cpg, coupling->second);
        const twd_phase lag = coupling->lag_and_quarter;
        first->pull += twd_wide_product(second->amplitude.value, twd_cos(second->phase - first->phase - lag));
        second->pull += twd_wide_product(first->amplitude.value, twd_cos(first->phase - second->phase - lag));
    }
}

/* What all oscillators share in a tick: copied, so that compilers know that no oscillator's state is part of it. */
struct pace {
    struct twd_filter_step amplitude_step;
    struct twd_filter_step centre_step;
    twd_turn_gain turn_gain;
    twd_phase intrinsic_advance;
};

static inline void advance_phase_and_amplitude(struct twd_oscillator *oscillator, const struct pace *pace)
{
    const twd_wide pull = oscillator->pull;
    /* Adams-Bashforth: (3/2) of this tick's rate less (1/2) of the last one's. */
    oscillator->phase += pace->intrinsic_advance + twd_phase_from_rates(pull, oscillator->last_pull, pace->turn_gain);
    oscillator->last_pull = pull;
    oscillator->pull = TWD_WIDE(0);
    twd_filter_advance(&oscillator->amplitude, &pace->amplitude_step, oscillator->amplitude_target);
}

void twd_cpg_tick(struct twd_cpg *cpg)
{
#if TWD_FOUR_AT_ONCE
    if (four_oscillators_fit(cpg)) {
        four_oscillators_tick(cpg);
        return;
    }
#endif
    if (cpg->config.return_lag != TWD_RETURN_LAG_NEGATED)
        pull_with_equal_return(cpg);
    else
        pull_with_negated_return(cpg);

    const struct pace pace = {cpg->amplitude_step, cpg->centre_step, cpg->turn_gain, cpg->intrinsic_advance};
    struct twd_oscillator *oscillator = cpg->oscillator; /* there is at least one */
    struct twd_oscillator *const end = at_offset(cpg, cpg->oscillators_end);
    if (cpg->config.with_centre) {
        do {
            advance_phase_and_amplitude(oscillator, &pace);
            twd_filter_advance(&oscillator->centre, &pace.centre_step, oscillator->centre_target);
            find_output_with_centre(oscillator);
        } while (++oscillator < end);
    } else {
        do {
            advance_phase_and_amplitude(oscillator, &pace);
            find_output_without_centre(oscillator);
        } while (++oscillator < end);
    }
}

twd_num twd_cpg_output(const struct twd_cpg *cpg, uint8_t index)
{
    return cpg->oscillator[index].output;
}
