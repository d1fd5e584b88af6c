/* fixed/filter.h: the filter of the fixed build (filter.h).
 *
 * With the error d = y - Y and s = d + y' / (a/2), a tick is s <- e s and d <- e (d + k s), where k = a h / 2 and e =
 * exp(-k): three multiplications. They are kept as what is taken away, d <- d - (1 - e) d + e k s, so that a slow
 * filter has all bits of its factors: 16 behind their first, and a shift. A relative error of 2^-16 in 1 - e shifts the
 * course by that part of the time constant. Rounding downwards stops d and s within 1 / (1 - e) units of 2^-28 of the
 * target. */
#ifndef TWIDDLE_FIXED_FILTER_H
#define TWIDDLE_FIXED_FILTER_H

TWD_BEGIN_DECLARATIONS

/* The transition of one tick. */
struct twd_filter_step {
    /* e k, less than 1 - e. */
    twd_factor mixing;
    /* 1 - e, below a half. */
    twd_factor decrease;
};

/* The state. */
struct twd_filter {
    /* y */
    twd_num value;
    /* s */
    twd_num lead;
};

/* The constants from k and e. */
static inline struct twd_filter_step twd_filter_step_of_decay(twd_num k, twd_num decay)
{
    const struct twd_filter_step step = {twd_factor_of_num(twd_mul(decay, k)),
                                         twd_factor_to_subtract(TWD_NUM(1) - decay)};
    return step;
}

static inline struct twd_filter twd_filter_start(twd_num value, twd_num target)
{
    const struct twd_filter filter = {value, value - target};
    return filter;
}

static inline twd_num twd_filter_velocity(const struct twd_filter *filter, twd_num target)
{
    return filter->lead - (filter->value - target);
}

static inline void twd_filter_advance(struct twd_filter *filter, const struct twd_filter_step *step, twd_num target)
{
    const int32_t y = (int32_t)filter->value;
    const int32_t d = y - (int32_t)target;
    const int32_t s = (int32_t)filter->lead;

    const int32_t mixed = twd_add_mul_factor(y, s, step->mixing);
    filter->value = (twd_num)twd_subtract_mul_factor(mixed, d, step->decrease);
    filter->lead = (twd_num)twd_subtract_mul_factor(s, s, step->decrease);
}

TWD_END_DECLARATIONS

#endif
