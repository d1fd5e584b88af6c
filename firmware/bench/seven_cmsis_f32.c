/* The seven oscillators in float with CMSIS-DSP's arm_sin_f32 and arm_cos_f32. */
#include "seven.h"

#include <dsp/fast_math_functions.h>

typedef float real;
#define SINE arm_sin_f32
#define COSINE arm_cos_f32
#define EXP expf
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
