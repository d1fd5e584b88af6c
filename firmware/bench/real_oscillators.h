/* real_oscillators.h: the seven oscillators in a floating-point type, with a library's sine and cosine; otherwise as
 * controller/src/cpg.c and twiddle/filter.h have them.
 *
 * The source that includes it defines the type `real` and the macros SINE, COSINE and EXP first. Angles are in rad. */
#include "drive.h"

#include <stddef.h>

#define TWO_PI ((real)6.283185307179586)

struct real_filter {
    real value;
    /* Divided by half the rate. */
    real velocity;
};

struct real_oscillator {
    /* [0, 2 pi) */
    real phase_rad;
    real last_pull;
    struct real_filter amplitude;
    struct real_filter centre;
};

struct real_network {
    struct real_oscillator oscillator[DRIVE_OSCILLATORS];
    real target_amplitude[DRIVE_OSCILLATORS];
    real target_centre[DRIVE_OSCILLATORS];
    real lag_rad[DRIVE_COUPLINGS];
    /* In a tick, from the frequency. */
    real advance_rad;
    real error_from_error;
    /* Error from velocity, and less velocity from error. */
    real mixed;
    real velocity_from_velocity;
    real output[DRIVE_OSCILLATORS];
};

static void real_start(struct real_network *network, const struct drive *drive)
{
    const real k = (real)(DRIVE_RATE_PER_S * DRIVE_TICK_S / 2);
    const real decay = EXP(-k);
    network->error_from_error = decay * (1 + k);
    network->mixed = decay * k;
    network->velocity_from_velocity = decay * (1 - k);
    network->advance_rad = TWO_PI * (real)drive->frequency_hz * (real)DRIVE_TICK_S;
    for (size_t i = 0; i < DRIVE_OSCILLATORS; i++) {
        const struct real_oscillator at_start = {0, 0, {0, 0}, {(real)drive->initial_centre[i], 0}};
        network->oscillator[i] = at_start;
        network->target_amplitude[i] = (real)drive->amplitude[i];
        network->target_centre[i] = (real)drive->centre[i];
    }
    for (size_t i = 0; i < DRIVE_COUPLINGS; i++)
        network->lag_rad[i] = TWO_PI * (real)drive->lag_turns[i];
}

static inline void real_filter_advance(const struct real_network *network, struct real_filter *filter, real target)
{
    const real error = filter->value - target;
    const real velocity = filter->velocity;
    filter->value = target + network->error_from_error * error + network->mixed * velocity;
    filter->velocity = network->velocity_from_velocity * velocity - network->mixed * error;
}

static inline void real_tick(struct real_network *network)
{
    real pull[DRIVE_OSCILLATORS] = {0};
    for (size_t k = 0; k < DRIVE_COUPLINGS; k++) {
        const struct drive_coupling coupling = drive_coupling[k];
        const struct real_oscillator *const first = &network->oscillator[coupling.first];
        const struct real_oscillator *const second = &network->oscillator[coupling.second];
        const real sine = SINE(second->phase_rad - first->phase_rad - network->lag_rad[k]);
        pull[coupling.first] += second->amplitude.value * sine;
        pull[coupling.second] -= first->amplitude.value * sine;
    }
    for (size_t i = 0; i < DRIVE_OSCILLATORS; i++) {
        struct real_oscillator *const oscillator = &network->oscillator[i];
        const real rate_rad_s = (real)1.5 * pull[i] - (real)0.5 * oscillator->last_pull;
        oscillator->last_pull = pull[i];
        oscillator->phase_rad += network->advance_rad + rate_rad_s * (real)DRIVE_TICK_S;
        if (oscillator->phase_rad >= TWO_PI) oscillator->phase_rad -= TWO_PI;
        if (oscillator->phase_rad < 0) oscillator->phase_rad += TWO_PI;
        real_filter_advance(network, &oscillator->amplitude, network->target_amplitude[i]);
        real_filter_advance(network, &oscillator->centre, network->target_centre[i]);
        network->output[i] = oscillator->centre.value + oscillator->amplitude.value * COSINE(oscillator->phase_rad);
    }
}
