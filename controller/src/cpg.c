#include <twiddle/cpg.h>

#include <twiddle/phase.h>

#include "checks.h"

/* A coupling pulls by at most R = 0.5 rad/s, the extrapolation at most doubles the sum, and a rate must stay below 16 rad/s. */
#if defined(TWD_NUMBER_FIXED) && TWD_MAX_COUPLINGS > 15
#error "TWD_MAX_COUPLINGS is at most 15 in the fixed build"
#endif

enum twd_error twd_cpg_init(struct twd_cpg *cpg, const struct twd_topology *topology,
                            const struct twd_cpg_config *config)
{
    static const struct twd_cpg_drive at_rest = {TWD_NUM(0), {TWD_NUM(0)}, {TWD_NUM(0)}, {0}};
    static const twd_phase zero_phase[TWD_MAX_OSCILLATORS] = {0};

    const enum twd_error error = twd_check_cpg(topology, config);
    if (error != TWD_OK) return error;

    cpg->topology = topology;
    cpg->config = *config;
    cpg->amplitude_step = twd_filter_step_make(cpg->config.amplitude_rate_per_s, cpg->config.tick_s);
    cpg->centre_step = twd_filter_step_make(cpg->config.centre_rate_per_s, cpg->config.tick_s);
    cpg->turn_gain = twd_turn_gain_of_tick(cpg->config.tick_s);
    twd_cpg_start(cpg, &at_rest, zero_phase);
    return TWD_OK;
}

/* c of oscillator `index` at t = 0. */
static twd_num initial_centre(const struct twd_cpg *cpg, uint8_t index)
{
    if (cpg->config.centre_start == TWD_CENTRE_START_AT_ZERO) return TWD_NUM(0);
    if (cpg->config.centre_start == TWD_CENTRE_START_AT_TARGET) return cpg->drive.centre[index];
    return cpg->topology->initial_centre[index];
}

twd_num twd_cpg_amplitude(const struct twd_cpg *cpg, uint8_t index)
{
    return twd_filter_value(&cpg->oscillator[index].amplitude, cpg->drive.amplitude[index]);
}

twd_num twd_cpg_centre(const struct twd_cpg *cpg, uint8_t index)
{
    return twd_filter_value(&cpg->oscillator[index].centre, cpg->drive.centre[index]);
}

static void find_outputs(struct twd_cpg *cpg)
{
    const uint8_t oscillators = cpg->topology->oscillators;
    if (cpg->config.with_centre) {
        for (uint8_t i = 0; i < oscillators; i++)
            cpg->output[i] = twd_oscillator_output_with_centre(twd_cpg_centre(cpg, i), twd_cpg_amplitude(cpg, i),
                                                               cpg->oscillator[i].phase);
    } else {
        for (uint8_t i = 0; i < oscillators; i++)
            cpg->output[i] = twd_oscillator_output_without_centre(twd_cpg_amplitude(cpg, i), cpg->oscillator[i].phase);
    }
}

void twd_cpg_start(struct twd_cpg *cpg, const struct twd_cpg_drive *drive, const twd_phase *initial_phase)
{
    cpg->drive = *drive;
    cpg->intrinsic_advance = twd_phase_from_frequency(drive->frequency_hz, cpg->config.tick_s);
    for (uint8_t i = 0; i < TWD_MAX_OSCILLATORS; i++) {
        const bool used = i < cpg->topology->oscillators;
        struct twd_oscillator *const oscillator = &cpg->oscillator[i];
        oscillator->phase = used ? initial_phase[i] : 0;
        oscillator->amplitude = twd_filter_start(TWD_NUM(0), used ? drive->amplitude[i] : TWD_NUM(0));
        oscillator->centre =
            twd_filter_start(used ? initial_centre(cpg, i) : TWD_NUM(0), used ? drive->centre[i] : TWD_NUM(0));
        /* All amplitudes are 0 at the start, and so is every pull: the extrapolation starts from its true value. */
        cpg->last_pull[i] = TWD_WIDE(0);
        cpg->output[i] = TWD_NUM(0);
    }
    find_outputs(cpg);
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

/* The coupling sums of all oscillators, rad/s. */
static void pulls(const struct twd_cpg *cpg, twd_wide *pull)
{
    const struct twd_topology *const topology = cpg->topology;
    for (uint8_t i = 0; i < topology->oscillators; i++)
        pull[i] = TWD_WIDE(0);

    for (uint8_t k = 0; k < topology->couplings; k++) {
        const struct twd_coupling coupling = topology->coupling[k];
        const twd_phase first = cpg->oscillator[coupling.first].phase;
        const twd_phase second = cpg->oscillator[coupling.second].phase;
        const twd_phase lag = cpg->drive.phase_lag[k];
        const twd_num sine = twd_sin(second - first - lag);
        /* With phi_ji = -phi_ij, the sine of the other direction is the negative of this one. */
        const twd_num return_sine =
            cpg->config.return_lag == TWD_RETURN_LAG_EQUAL ? twd_sin(first - second - lag) : -sine;
        pull[coupling.first] += twd_wide_product(twd_cpg_amplitude(cpg, coupling.second), sine);
        pull[coupling.second] += twd_wide_product(twd_cpg_amplitude(cpg, coupling.first), return_sine);
    }
}

static void advance_phases(struct twd_cpg *cpg)
{
    twd_wide pull[TWD_MAX_OSCILLATORS];
    pulls(cpg, pull);
    for (uint8_t i = 0; i < cpg->topology->oscillators; i++) {
        /* Adams-Bashforth: (3/2) of this tick's rate less (1/2) of the last one's. */
        const twd_wide rate_rad_s = pull[i] + twd_wide_half(pull[i] - cpg->last_pull[i]);
        cpg->last_pull[i] = pull[i];
        cpg->oscillator[i].phase += cpg->intrinsic_advance + twd_phase_from_rate(rate_rad_s, cpg->turn_gain);
    }
}

void twd_cpg_tick(struct twd_cpg *cpg)
{
    const uint8_t oscillators = cpg->topology->oscillators;
    advance_phases(cpg);
    for (uint8_t i = 0; i < oscillators; i++)
        twd_filter_advance(&cpg->oscillator[i].amplitude, &cpg->amplitude_step, cpg->drive.amplitude[i]);
    if (cpg->config.with_centre)
        for (uint8_t i = 0; i < oscillators; i++)
            twd_filter_advance(&cpg->oscillator[i].centre, &cpg->centre_step, cpg->drive.centre[i]);
    find_outputs(cpg);
}

twd_num twd_cpg_output(const struct twd_cpg *cpg, uint8_t index)
{
    return cpg->output[index];
}
