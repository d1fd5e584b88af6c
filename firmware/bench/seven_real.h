/* seven_real.h: seven.h in a floating-point type, with a library's sine and cosine. The source that includes it defines
 * what real_oscillators.h asks for. */
#include "real_oscillators.h"
#include "seven.h"

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
