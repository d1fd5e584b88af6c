/* exported.h: two exported runs of each number type, for a C99 and a C++ program. */
#ifndef TWIDDLE_EXPORTED_H
#define TWIDDLE_EXPORTED_H

#include <double_odd.h>
#include <double_plain.h>
#include <fixed_odd.h>
#include <fixed_plain.h>
#include <float_odd.h>
#include <float_plain.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { EXPORTED_RUNS = 6 };

/* A run's constants. */
struct exported {
    const char *number;
    const char *folder;
    const struct twd_skill *skill;
    const struct twd_learner_snapshot *learner;
    twd_wide reward_per_rad;
};

/* All of them, as a C compiler reads them. */
struct exported exported_in_c(int run);

#ifdef __cplusplus
}
#endif
#endif
