/* Six legs in a wave: a user-defined CPG of six oscillators in a ring, each a sixth of a turn ahead of the last.
 *
 * The network is the const table below; twiddle's sources know nothing of it. Prints 3 s of the six outputs, fractions
 * of each leg's range, as CSV. */
#include <twiddle/convert.h>
#include <twiddle/cpg.h>
#include <twiddle/phase.h>

#include <stdio.h>

#define LEGS 6
#define TICKS 300

static const struct twd_coupling coupling[LEGS] = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}};
static const uint8_t leg_oscillator[LEGS] = {0, 1, 2, 3, 4, 5};
static const twd_num initial_centre[LEGS] = {TWD_NUM(0.5), TWD_NUM(0.5), TWD_NUM(0.5),
                                             TWD_NUM(0.5), TWD_NUM(0.5), TWD_NUM(0.5)};

static const struct twd_topology legs = {
    .name = "six legs",
    .oscillators = LEGS,
    .couplings = LEGS,
    .joints = LEGS,
    .chooses_frequency = true,
    .coupling = coupling,
    .joint_oscillator = leg_oscillator,
    .initial_centre = initial_centre,
};

int main(void)
{
    const struct twd_cpg_config config = {
        .with_centre = true,
        .tick_s = TWD_SMALL(0.01),
        .amplitude_rate_per_s = TWD_RATE(20),
        .centre_rate_per_s = TWD_RATE(20),
    };
    struct twd_cpg cpg;
    const enum twd_error error = twd_cpg_init(&cpg, &legs, &config);
    if (error != TWD_OK) {
        fprintf(stderr, "ring: %s\n", twd_error_text(error));
        return 1;
    }

    struct twd_cpg_drive drive = {.frequency_hz = TWD_NUM(1)};
    for (int leg = 0; leg < LEGS; leg++) {
        drive.amplitude[leg] = TWD_NUM(0.4);
        drive.centre[leg] = TWD_NUM(0.5);
        drive.phase_lag[leg] = twd_phase_from_fraction(TWD_NUM(1.0 / LEGS));
    }
    twd_phase phase[LEGS];
    twd_cpg_phases_at_lag(&legs, drive.phase_lag, phase);
    twd_cpg_start(&cpg, &drive, phase);

    puts("# six oscillators in a ring; time in s, outputs as fractions of each leg's range");
    puts("time_s,leg_1,leg_2,leg_3,leg_4,leg_5,leg_6");
    for (int tick = 1; tick <= TICKS; tick++) {
        twd_cpg_tick(&cpg);
        printf("%.2f", 0.01 * tick);
        for (uint8_t leg = 0; leg < LEGS; leg++)
            printf(",%.6f", twd_num_to_double(twd_cpg_output(&cpg, leg)));
        putchar('\n');
    }
    return 0;
}
