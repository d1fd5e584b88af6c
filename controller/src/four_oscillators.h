/* four_oscillators.h: the tick of a CPG, four couplings and four oscillators at a time where that pays. Inline, not
 * installed. Its results are twd_cpg_tick's to the last bit. */
#ifndef TWIDDLE_FOUR_OSCILLATORS_H
#define TWIDDLE_FOUR_OSCILLATORS_H

#include "cpg_offsets.h"
#include "four.h"

#if TWD_FOUR_AT_ONCE

/* Whether `cpg` ticks so: with centres, and with couplings that ask for the same difference at both ends. */
static inline bool four_oscillators_fit(const struct twd_cpg *cpg)
{
    return cpg->config.with_centre && cpg->config.return_lag == TWD_RETURN_LAG_NEGATED;
}

/* The cosines of `count` phases. Both arrays are as long as a multiple of four. */
static inline void four_cosines(const twd_phase *phase, size_t count, twd_num *cosine)
{
    for (size_t k = 0; k < count; k += 4)
        four_cosine(&phase[k], &cosine[k]);
}

/* What the couplings pull. */
static inline void four_oscillators_pull(struct twd_cpg *cpg)
{
    const struct twd_running_coupling *const coupling = cpg->coupling;
    const size_t couplings = cpg->couplings;
    twd_phase difference[TWD_MAX_COUPLINGS + 3] = {0};
    twd_num sine[TWD_MAX_COUPLINGS + 3];
    for (size_t k = 0; k < couplings; k++)
        difference[k] = at_offset(cpg, coupling[k].second)->phase - at_offset(cpg, coupling[k].first)->phase -
                        coupling[k].lag_and_quarter;
    four_cosines(difference, couplings, sine);
    for (size_t k = 0; k < couplings; k++) {
        struct twd_oscillator *const first = at_offset(cpg, coupling[k].first);
        struct twd_oscillator *const second = at_offset(cpg, coupling[k].second);
        first->pull += twd_wide_product(second->amplitude.value, sine[k]);
        second->pull -= twd_wide_product(first->amplitude.value, sine[k]);
    }
}

/* As twd_phase_from_rates, but that what is beyond half a turn a tick, which no network of the library's reaches, wraps
 * instead of being clamped. */
static inline twd_phase four_phase_from_rates(twd_wide rate_rad_s, twd_wide last_rate_rad_s, twd_turn_gain gain)
{
    const twd_num extrapolated = rate_rad_s + twd_mul(rate_rad_s - last_rate_rad_s, TWD_NUM(0.5));
    return (twd_phase)(int64_t)twd_mul(extrapolated, gain);
}

static inline void four_advance_filters(struct twd_oscillator *oscillator, struct twd_four from_same,
                                        struct twd_four from_other, const struct twd_four *target)
{
    struct twd_filter *const amplitude = &oscillator->amplitude, *const centre = &oscillator->centre;
    const struct twd_four state = {{amplitude->value, amplitude->velocity, centre->value, centre->velocity}};
    const struct twd_four error = four_subtract(state, *target);
    const struct twd_four next =
        four_multiply_add(from_other, four_swap(error), four_multiply_add(from_same, error, *target));
    amplitude->value = next.of[0];
    amplitude->velocity = next.of[1];
    centre->value = next.of[2];
    centre->velocity = next.of[3];
}

/* Advance all but the outputs; write the cosines of the oscillators' phases, for which there is room for a multiple of
 * four. */
static inline void four_oscillators_advance(struct twd_cpg *cpg, twd_num *cosine)
{
    four_oscillators_pull(cpg);

    const struct twd_four from_same = cpg->filters.from_same, from_other = cpg->filters.from_other;
    const twd_turn_gain turn_gain = cpg->turn_gain;
    const twd_phase intrinsic_advance = cpg->intrinsic_advance;
    const size_t oscillators = cpg->oscillators;
    twd_phase phase[TWD_MAX_OSCILLATORS + 3] = {0};
    for (size_t i = 0; i < oscillators; i++) {
        struct twd_oscillator *const oscillator = &cpg->oscillator[i];
        const twd_wide pull = oscillator->pull;
        phase[i] =
            oscillator->phase + intrinsic_advance + four_phase_from_rates(pull, oscillator->last_pull, turn_gain);
        oscillator->phase = phase[i];
        oscillator->last_pull = pull;
        oscillator->pull = TWD_WIDE(0);
        four_advance_filters(oscillator, from_same, from_other, &cpg->filters.target[i]);
    }
    four_cosines(phase, oscillators, cosine);
}

/* Write and return the output of an oscillator whose phase has this cosine. */
static inline twd_num four_output(struct twd_oscillator *oscillator, twd_num cosine)
{
    const twd_num output = oscillator->centre.value + twd_mul_short(oscillator->amplitude.value, cosine);
    oscillator->output = output;
    return output;
}

/* twd_cpg_tick, if it fits. */
static inline void four_oscillators_tick(struct twd_cpg *cpg)
{
    twd_num cosine[TWD_MAX_OSCILLATORS + 3];
    four_oscillators_advance(cpg, cosine);
    for (size_t i = 0; i < cpg->oscillators; i++)
        (void)four_output(&cpg->oscillator[i], cosine[i]);
}

#endif

#endif
