/* fixed/filter.h: the filter of the fixed build (filter.h).
 *
 * With the error d = y - Y and s = d + y' / (a/2), a tick is s <- e s and d <- e (d + k s), where k = a h / 2 and e = exp(-k): three
 * multiplications. They are kept as what is taken away, d <- d - (1 - e) d + e k s, so that a slow filter has all bits of its factors:
 * 16 behind their first, and a shift. A relative error of 2^-16 in 1 - e shifts the course by that part of the time constant.
 * Rounding downwards stops d and s within 1 / (1 - e) units of 2^-28 of the target. */
#ifndef TWIDDLE_FIXED_FILTER_H
#define TWIDDLE_FIXED_FILTER_H

/* The transition of one tick. */
struct twd_filter_step {
    uint16_t decrease; /* (1 - e) 2^(17 + shift), below 2^16: 1 - e is below a half */
    uint16_t mixing;   /* e k 2^(17 + shift), less than `decrease` */
    uint8_t shift;
};

/* The state. */
struct twd_filter {
    twd_num error;              /* d */
    twd_num error_and_velocity; /* s */
};

/* A word of Q4.28, below a half, as a factor of 2^-17. */
static inline uint16_t twd_filter_factor(int32_t word)
{
    const int32_t factor = (word + (1 << 10)) >> 11;
    return factor > UINT16_MAX ? UINT16_MAX : (uint16_t)factor;
}

/* The constants from k and e. */
static inline struct twd_filter_step twd_filter_step_of_decay(twd_num k, twd_num decay)
{
    int32_t decrease = (int32_t)(TWD_NUM(1) - decay);
    int32_t mixing = (int32_t)twd_mul(decay, k);
    uint8_t shift = 0;
    while (decrease < (int32_t)TWD_NUM(0.25) && shift < 15) {
        decrease *= 2;
        mixing *= 2;
        shift++;
    }
    const struct twd_filter_step step = {twd_filter_factor(decrease), twd_filter_factor(mixing), shift};
    return step;
}

static inline struct twd_filter twd_filter_start(twd_num value, twd_num target)
{
    const struct twd_filter filter = {value - target, value - target};
    return filter;
}

static inline twd_num twd_filter_value(const struct twd_filter *filter, twd_num target)
{
    return target + filter->error;
}

static inline twd_num twd_filter_velocity(const struct twd_filter *filter)
{
    return filter->error_and_velocity - filter->error;
}

static inline void twd_filter_advance(struct twd_filter *filter, const struct twd_filter_step *step, twd_num target)
{
    const int32_t d = (int32_t)filter->error;
    const int32_t s = (int32_t)filter->error_and_velocity;
    (void)target;

    const int32_t change = twd_scaled(s, step->mixing, 1) - twd_scaled(d, step->decrease, 1);
    filter->error = (twd_num)(d + (change >> step->shift));
    filter->error_and_velocity = (twd_num)(s - (twd_scaled(s, step->decrease, 1) >> step->shift));
}

#endif
