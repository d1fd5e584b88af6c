/* The seven oscillators in q31 with CMSIS-DSP's arm_sin_q31 and arm_cos_q31; otherwise as controller/src/cpg.c and
 * twiddle/filter.h have them.
 *
 * Phases are in turns, [0, 1), as those functions take them. Amplitudes, centres, pulls and outputs are halved: an
 * output reaches from -0.5 to 1.5. */
#include "seven.h"

#include <dsp/fast_math_functions.h>

struct q31_filter {
    q31_t value;
    q31_t velocity; /* divided by half the rate */
};

struct q31_oscillator {
    q31_t phase;
    q31_t last_pull;
    struct q31_filter amplitude;
    struct q31_filter centre;
};

static struct {
    struct q31_oscillator oscillator[DRIVE_OSCILLATORS];
    q31_t target_amplitude[DRIVE_OSCILLATORS];
    q31_t target_centre[DRIVE_OSCILLATORS];
    q31_t lag[DRIVE_COUPLINGS];
    q31_t advance; /* turns a tick, from the frequency */
    q31_t error_from_error;
    q31_t mixed; /* error from velocity, and less velocity from error */
    q31_t velocity_from_velocity;
    q31_t turns_from_pull; /* of a tick, from half a pull in rad/s */
    q31_t output[DRIVE_OSCILLATORS];
} network;

static q31_t q31(double value)
{
    return (q31_t)lround(value * 2147483648.0);
}

void seven_start(const double *parameter, const struct drive *drive)
{
    (void)parameter;
    const double k = DRIVE_RATE_PER_S * DRIVE_TICK_S / 2;
    network.error_from_error = q31(exp(-k) * (1 + k));
    network.mixed = q31(exp(-k) * k);
    network.velocity_from_velocity = q31(exp(-k) * (1 - k));
    network.advance = q31(drive->frequency_hz * DRIVE_TICK_S);
    network.turns_from_pull = q31(2 * DRIVE_TICK_S / 6.283185307179586);
    for (size_t i = 0; i < DRIVE_OSCILLATORS; i++) {
        const struct q31_oscillator at_start = {0, 0, {0, 0}, {q31(drive->initial_centre[i] / 2), 0}};
        network.oscillator[i] = at_start;
        network.target_amplitude[i] = q31(drive->amplitude[i] / 2);
        network.target_centre[i] = q31(drive->centre[i] / 2);
    }
    for (size_t i = 0; i < DRIVE_COUPLINGS; i++)
        network.lag[i] = q31(drive->lag_turns[i]);
}

/* As arm_mult_q31 multiplies, whose saturation no product here needs. */
static inline q31_t multiply(q31_t a, q31_t b)
{
    return (q31_t)((uint32_t)(((q63_t)a * b) >> 32) << 1);
}

/* A phase in [0, 1) turn. */
static inline q31_t wrap(uint32_t phase)
{
    return (q31_t)(phase & 0x7FFFFFFF);
}

static inline void advance(struct q31_filter *filter, q31_t target)
{
    const q31_t error = filter->value - target;
    const q31_t velocity = filter->velocity;
    filter->value = target + multiply(network.error_from_error, error) + multiply(network.mixed, velocity);
    filter->velocity = multiply(network.velocity_from_velocity, velocity) - multiply(network.mixed, error);
}

void seven_tick(void)
{
    q31_t pull[DRIVE_OSCILLATORS] = {0};
    for (size_t k = 0; k < DRIVE_COUPLINGS; k++) {
        const struct drive_coupling coupling = drive_coupling[k];
        const struct q31_oscillator *const first = &network.oscillator[coupling.first];
        const struct q31_oscillator *const second = &network.oscillator[coupling.second];
        const uint32_t lead = (uint32_t)second->phase - (uint32_t)first->phase - (uint32_t)network.lag[k];
        const q31_t sine = arm_sin_q31(wrap(lead));
        pull[coupling.first] += multiply(second->amplitude.value, sine);
        pull[coupling.second] -= multiply(first->amplitude.value, sine);
    }
    for (size_t i = 0; i < DRIVE_OSCILLATORS; i++) {
        struct q31_oscillator *const oscillator = &network.oscillator[i];
        const q31_t rate = pull[i] + ((pull[i] - oscillator->last_pull) >> 1);
        oscillator->last_pull = pull[i];
        const q31_t pulled = multiply(rate, network.turns_from_pull);
        oscillator->phase = wrap((uint32_t)oscillator->phase + (uint32_t)network.advance + (uint32_t)pulled);
        advance(&oscillator->amplitude, network.target_amplitude[i]);
        advance(&oscillator->centre, network.target_centre[i]);
        network.output[i] =
            oscillator->centre.value + multiply(oscillator->amplitude.value, arm_cos_q31(oscillator->phase));
    }
}

double seven_output(size_t index)
{
    return (double)network.output[index] / 1073741824.0;
}
