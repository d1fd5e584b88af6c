/* The seven oscillators in float with the C library's sinf and cosf. */
#include <math.h>

typedef float real;
/* In avr-libc the names stand for the functions of doubles, which are floats there. */
#define SINE(angle_rad) ((real)sinf(angle_rad))
#define COSINE(angle_rad) ((real)cosf(angle_rad))
#define EXP(exponent) ((real)expf(exponent))
#include "seven_real.h"
