/* The seven oscillators in float with the C library's sinf and cosf. */
#include "seven.h"

#include <math.h>

typedef float real;
/* In avr-libc the names stand for the functions of doubles, which are floats there. */
#define SINE(angle_rad) ((real)sinf(angle_rad))
#define COSINE(angle_rad) ((real)cosf(angle_rad))
#define EXP(exponent) ((real)expf(exponent))
#include "real_oscillators.h"

static struct real_network network;

void seven_start(const double *parameter, const struct drive *drive)
{
    (void)parameter;
    real_start(&network, drive);
}

void seven_tick(void)
{
    real_tick(&network);
}

double seven_output(size_t index)
{
    return (double)network.output[index];
}
