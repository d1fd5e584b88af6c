/* accuracy.h: what one number build computes, as a stream of doubles, for comparison with another build.
 *
 * Each build has a recorder of its own, which runs one of the courses below and writes its quantities to standard
 * output, and compare_accuracy reads the recorders side by side.
 *
 *     record_accuracy trials CENTRES TICK   for each set and tick: oscillator outputs, joint outputs, torques, phases;
 *                                           CENTRES is 1 or 0, TICK is in ms
 *     record_accuracy sigmoid               twd_sigmoid on a grid over +-SIGMOID_END
 *     record_accuracy sine                  twd_sin, and sine and cosine of twd_sine_cosine, all round the circle
 *     record_accuracy learning              for each seed: reward of the learned policy, mean reward of the last trials
 *
 * What is given to the builds (parameters, angles, velocities, arguments) is exact in all of them, so that the rounding
 * of inputs is not counted; what they compute with it, and settings as a user writes them (the tick of 0.01 s), are. */
#ifndef TWIDDLE_ACCURACY_H
#define TWIDDLE_ACCURACY_H

/* CPG-H's trials. */
enum { ACCURACY_SETS = 1000, ACCURACY_TICKS = 300, ACCURACY_OSCILLATORS = 7, ACCURACY_JOINTS = 4 };

/* Arguments of the sigmoid: 0, and so many on each side, a step of 2^-SIGMOID_BITS apart. */
enum { SIGMOID_END = 50, SIGMOID_BITS = 14, SIGMOID_STEPS = SIGMOID_END << SIGMOID_BITS };

/* Phases of the sines: so many, a golden section of the turn apart, which spreads them evenly and over all bits. */
enum { SINE_STEPS = 1 << 20 };

/* The learner's runs, and the trials at their end that count for the mean. */
enum { LEARNING_SEEDS = 8, LEARNING_TRIALS = 5000, LEARNING_LAST_TRIALS = 500 };

#endif
