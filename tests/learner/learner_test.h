/* learner_test.h: what the learner's tests share beside c_test.h: a tolerance. */
#ifndef TWIDDLE_LEARNER_TEST_H
#define TWIDDLE_LEARNER_TEST_H

#include "c_test.h"

/* The elementary functions are good to 1e-10 (double) and 5e-6 (float); in the fixed build they are good to 2e-7, and a
 * sum of 27 products errs by 27 steps of 2^-24. */
#define ROUNDING BY_NUMBER(1e-9, 1e-5, 2e-6)

#endif
