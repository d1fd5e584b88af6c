#include "reference.h"

#include <math.h>

typedef double real;
#define SINE sin
#define COSINE cos
#define EXP exp
#include "real_oscillators.h"

static struct real_network network;

void reference_start(const struct drive *drive)
{
    real_start(&network, drive);
}

void reference_tick(void)
{
    real_tick(&network);
}

double reference_output(size_t index)
{
    return network.output[index];
}
