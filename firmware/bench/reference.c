#include "reference.h"

#include <math.h>

typedef double real;
#define SINE sin
#define COSINE cos
#define EXP exp
#include "libm_oscillators.h"

static struct libm_network network;

void reference_start(const struct drive *drive)
{
    libm_start(&network, drive);
}

void reference_tick(void)
{
    libm_tick(&network);
}

double reference_output(size_t index)
{
    return network.output[index];
}
