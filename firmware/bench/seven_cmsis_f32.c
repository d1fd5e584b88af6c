/* The seven oscillators in float with CMSIS-DSP's arm_sin_f32 and arm_cos_f32. */
#include <dsp/fast_math_functions.h>

typedef float real;
#define SINE arm_sin_f32
#define COSINE arm_cos_f32
#define EXP expf
#include "seven_real.h"
