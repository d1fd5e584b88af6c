/* learner_limits.h: the compile-time sizes of the learner's arrays. Raise or lower them with -DNAME=value, the same for
 * the library and the code that includes its headers. */
#ifndef TWIDDLE_LEARNER_LIMITS_H
#define TWIDDLE_LEARNER_LIMITS_H

/* Actor units: the parameters of a model, CPG-H's 22 at most by default. */
#ifndef TWD_MAX_UNITS
#define TWD_MAX_UNITS 22
#endif

/* Input units: the map of object shape and size. */
#ifndef TWD_MAX_INPUTS
#define TWD_MAX_INPUTS 27
#endif

#if TWD_MAX_UNITS > 255 || TWD_MAX_INPUTS > 255
#error "TWD_MAX_UNITS and TWD_MAX_INPUTS are counted in 8 bits: 255 at most"
#endif

#endif
