/* seven.h: one way to compute CPG-H's seven oscillators; each bench image links one. What is counted is seven_tick. */
#ifndef TWIDDLE_BENCH_SEVEN_H
#define TWIDDLE_BENCH_SEVEN_H

#include "drive.h"

#include <stddef.h>

/* Start `drive`, which `parameter` says. */
void seven_start(const double *parameter, const struct drive *drive);

/* Advance all by one tick, and compute their outputs. */
void seven_tick(void) __attribute__((noinline));

/* Output of oscillator `index` after the last tick, of the joint's range. */
double seven_output(size_t index);

/* Run all sets of drive.h, and write the largest error of an output against reference.h. */
void seven_run(void);

#endif
