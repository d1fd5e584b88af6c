#include "drive.h"

#include <twiddle/random.h>

#include <stddef.h>

/* CPG-C's 1-2, 1-3, 3-4 and CPG-M's 1-2; CPG-S has one oscillator. */
const struct drive_coupling drive_coupling[DRIVE_COUPLINGS] = {{0, 1}, {0, 2}, {2, 3}, {4, 5}};

static const double initial_centre[DRIVE_OSCILLATORS] = {0, 0.5, 0, 0, 0, 0, 0};

void drive_draw(unsigned set, double *parameter)
{
    struct twd_random random;
    twd_random_seed(&random, set);
    for (size_t i = 0; i < DRIVE_PARAMETERS; i++)
        parameter[i] = ((double)(twd_random_next(&random) >> 17) + 0.5) / 32768;
}

void drive_read(const double *parameter, struct drive *drive)
{
    static const size_t oscillators[] = {4, 2, 1};
    static const size_t couplings[] = {3, 1, 0};
    drive->frequency_hz =
        DRIVE_FREQUENCY_LOWER_HZ + *parameter++ * (DRIVE_FREQUENCY_UPPER_HZ - DRIVE_FREQUENCY_LOWER_HZ);
    size_t oscillator = 0;
    size_t coupling = 0;
    for (size_t cpg = 0; cpg < 3; cpg++) {
        for (size_t i = 0; i < oscillators[cpg]; i++)
            drive->amplitude[oscillator + i] = DRIVE_AMPLITUDE_UPPER * *parameter++;
        for (size_t i = 0; i < oscillators[cpg]; i++)
            drive->centre[oscillator + i] = *parameter++;
        for (size_t i = 0; i < couplings[cpg]; i++)
            drive->lag_turns[coupling + i] = *parameter++;
        oscillator += oscillators[cpg];
        coupling += couplings[cpg];
    }
    for (size_t i = 0; i < DRIVE_OSCILLATORS; i++)
        drive->initial_centre[i] = initial_centre[i];
}
