/* learner_test.h: what the learner's tests share: cmocka with the headers it asks for, and comparisons in double precision. */
#ifndef TWIDDLE_LEARNER_TEST_H
#define TWIDDLE_LEARNER_TEST_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>

#include <twiddle/number.h>

#ifdef TWD_NUMBER_DOUBLE
#define ROUNDING 1e-9 /* the elementary functions are good to 1e-10 */
#else
#define ROUNDING 1e-5 /* the elementary functions are good to 5e-6 */
#endif

/* Assert that two numbers differ by at most `tolerance`; a result that is not a number fails. */
static inline void assert_close(twd_num actual, double expected, double tolerance)
{
    const double difference = fabs((double)actual - expected);
    if (!(difference <= tolerance)) {
        print_error("got %.12g, expected %.12g within %g\n", (double)actual, expected, tolerance);
        fail();
    }
}

#endif
