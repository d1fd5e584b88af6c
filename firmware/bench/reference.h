/* reference.h: the seven oscillators in double with the C library's sin and cos, that all others are compared with. On
 * the AVR a double is a float, and so no reference. */
#ifndef TWIDDLE_BENCH_REFERENCE_H
#define TWIDDLE_BENCH_REFERENCE_H

#include "drive.h"

#include <stddef.h>

/* As those of seven.h. */
void reference_start(const struct drive *drive);
void reference_tick(void);
double reference_output(size_t index);

#endif
