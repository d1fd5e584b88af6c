/* error.h: what a set-up function can answer. Per-tick functions cannot fail; they saturate and count. */
#ifndef TWIDDLE_ERROR_H
#define TWIDDLE_ERROR_H

#include <twiddle/detail/controller_names.h>

TWD_BEGIN_DECLARATIONS

/* Zero is success, every error is negative. A function that fails leaves its object as it was. */
enum twd_error {
    TWD_OK = 0,
    TWD_ERROR_TICK = -1,                 /* the tick must be in (0, 0.1] s */
    TWD_ERROR_TOO_MANY_OSCILLATORS = -2, /* more than TWD_MAX_OSCILLATORS, or none */
    TWD_ERROR_TOO_MANY_COUPLINGS = -3,   /* more than TWD_MAX_COUPLINGS */
    TWD_ERROR_COUPLING = -4,             /* a coupling names an oscillator that is not there, or itself */
    TWD_ERROR_TOO_MANY_JOINTS = -5,      /* more than TWD_MAX_JOINTS, or none, or CPGs that disagree on their number */
    TWD_ERROR_JOINT_OSCILLATOR = -6,     /* a joint is driven by an oscillator that is not there */
    TWD_ERROR_TOO_MANY_CPGS = -7,        /* more than TWD_MAX_CPGS, or none */
    TWD_ERROR_CHAIN = -8,                /* a finger chain is too long, or moves a joint that is not there */
    TWD_ERROR_RANGE = -9,                /* a range is empty, not finite, or outside what its field allows */
    TWD_ERROR_PARAMETER_COUNT = -10,     /* not as many parameters as the model has */
    TWD_ERROR_PARAMETER = -11,           /* a parameter is outside [0, 1] or not a number */
    TWD_ERROR_LEARNER_SIZE = -12,        /* more units or inputs than the learner's arrays hold, or none */
    TWD_ERROR_NULL = -13,                /* a table or a pointer that is needed is null */
};

/* One plain sentence for `error`, in flash; never a null pointer. */
const char *twd_error_text(enum twd_error error);

TWD_END_DECLARATIONS

#endif
