/* number.h: the number types of the library, and which operations there are.
 *
 * The build chooses one family: TWD_NUMBER_FLOAT (default), TWD_NUMBER_DOUBLE or TWD_NUMBER_FIXED. Each quantity has a
 * type by its range, so that 32 bits serve it well:
 *
 *     type       fixed     range           step      quantities
 *     twd_num    Q4.28     +-8             3.7e-9    angles (rad), sines, fractions, parameters, amplitudes, centres,
 *                                                    frequencies (Hz), actor weights, inputs, learning rates, torques
 *                                                    (N m), gains (N m/rad, N m s/rad), masses (kg), lengths (m),
 *                                                    weights (N)
 *     twd_wide   Q8.24     +-128           6.0e-8    rewards, values, TD errors, critic weights, activations, coupling
 *                                                    sums (rad/s), squared norms, accelerations (m/s2)
 *     twd_rate   Q12.20    +-2048          9.5e-7    joint velocities (rad/s), filter rates (1/s)
 *     twd_small     +-0.125         5.8e-11   ticks and periods (s), moments of inertia (kg m2)
 *     twd_phase  turns     one turn        2.3e-10   angles on the circle, in every build
 *
 * In the float and double builds the first four are one type. In the fixed build they are 32-bit words; sums,
 * differences and comparisons of one type are native, products and quotients are the named functions of fixed/number.h
 * and float/number.h, which have the same names and arguments. `saturated` functions stay at the ends of the range, at
 * plus or minus the largest number; the others are for results that are known to stay inside it. Nothing here calls
 * libm. */
#ifndef TWIDDLE_NUMBER_H
#define TWIDDLE_NUMBER_H

#include <twiddle/detail/build.h>

#include <stdbool.h>
#include <stdint.h>

TWD_BEGIN_DECLARATIONS

/* An angle on the circle: 2^32 is one turn, and overflow is the wrap-around. */
typedef uint32_t twd_phase;

TWD_END_DECLARATIONS

#if defined(TWD_NUMBER_FIXED)
#include <twiddle/fixed/number.h>
#else
#include <twiddle/float/number.h>
#endif

#endif
