/* drive.h: the parameter sets that every bench image runs, the same on every board and in every number format.
 *
 * Each parameter has 16 bits, so that it and all that drives an oscillator is exact in float, in Q4.28 and in q31:
 * what differs between two formats after some ticks came about in the ticks. */
#ifndef TWIDDLE_BENCH_DRIVE_H
#define TWIDDLE_BENCH_DRIVE_H

/* Sets, and ticks of each. */
enum { DRIVE_SETS = 5, DRIVE_TICKS = 300 };

/* CPG-H with centre: parameters, oscillators and couplings. */
enum { DRIVE_PARAMETERS = 22, DRIVE_OSCILLATORS = 7, DRIVE_COUPLINGS = 4 };

/* What all sets share. */
#define DRIVE_TICK_S 0.01
#define DRIVE_RATE_PER_S 20.0 /* of amplitudes and centres */
#define DRIVE_FREQUENCY_LOWER_HZ 0.25
#define DRIVE_FREQUENCY_UPPER_HZ 1.09375
#define DRIVE_AMPLITUDE_UPPER 0.5

/* What drives the seven oscillators: those of CPG-C, then CPG-M's, then CPG-S's. All phases start at 0. */
struct drive {
    double frequency_hz;
    /* R, of the joint's range. */
    double amplitude[DRIVE_OSCILLATORS];
    /* C, of the joint's range. */
    double centre[DRIVE_OSCILLATORS];
    /* c at t = 0. */
    double initial_centre[DRIVE_OSCILLATORS];
    /* [0, 1) */
    double lag_turns[DRIVE_COUPLINGS];
};

/* Which oscillators the couplings join. */
struct drive_coupling {
    unsigned char first;
    unsigned char second;
};
extern const struct drive_coupling drive_coupling[DRIVE_COUPLINGS];

/* Draw the parameters of `set`, each in (0, 1), in the order of twiddle/model.h. */
void drive_draw(unsigned set, double *parameter);

/* What `parameter` says, with the limits above and a centre in [0, 1]. */
void drive_read(const double *parameter, struct drive *drive);

#endif
