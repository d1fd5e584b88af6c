/* float/filter.h: the filter of the float and double builds (filter.h). */
#ifndef TWIDDLE_FLOAT_FILTER_H
#define TWIDDLE_FLOAT_FILTER_H

TWD_BEGIN_DECLARATIONS

/* The transition of one tick of h seconds, with k = a h / 2 and e = exp(-k). */
struct twd_filter_step {
    /* e (1 + k) */
    twd_num error_from_error;
    /* e k */
    twd_num error_from_velocity;
    /* -e k */
    twd_num velocity_from_error;
    /* e (1 - k) */
    twd_num velocity_from_velocity;
};

/* The state. */
struct twd_filter {
    /* y */
    twd_num value;
    /* y' / (a/2), in the unit of y. */
    twd_num velocity;
};

/* The constants from k and e. */
static inline struct twd_filter_step twd_filter_step_of_decay(twd_num k, twd_num decay)
{
    const twd_num mixed = twd_mul(decay, k);
    const struct twd_filter_step step = {decay + mixed, mixed, -mixed, decay - mixed};
    return step;
}

static inline struct twd_filter twd_filter_start(twd_num value, twd_num target)
{
    const struct twd_filter filter = {value, TWD_NUM(0)};
    (void)target;
    return filter;
}

static inline twd_num twd_filter_velocity(const struct twd_filter *filter, twd_num target)
{
    (void)target;
    return filter->velocity;
}

static inline void twd_filter_advance(struct twd_filter *filter, const struct twd_filter_step *step, twd_num target)
{
    const twd_num error = filter->value - target;
    const twd_num velocity = filter->velocity;

    filter->value = target + twd_mul(step->error_from_error, error) + twd_mul(step->error_from_velocity, velocity);
    filter->velocity = twd_mul(step->velocity_from_error, error) + twd_mul(step->velocity_from_velocity, velocity);
}

TWD_END_DECLARATIONS

#endif
