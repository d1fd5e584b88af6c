/* input_map.h: what the learner sees of an object, a population code over shape x size.
 *
 * One row of units a shape; the units of the object's shape respond to its size with Gaussian tuning curves, the other
 * rows are silent. The squared norm of the response, about 10 for sizes in the map's range, multiplies both learning
 * rates: it is the learner's effective gain (docs/PAPER.md). */
#ifndef TWIDDLE_INPUT_MAP_H
#define TWIDDLE_INPUT_MAP_H

#include <twiddle/detail/learner_names.h>
#include <twiddle/number.h>

#include <stddef.h>

TWD_BEGIN_DECLARATIONS

/* Rows of the map. */
enum twd_shape { TWD_SHAPE_SPHERE = 0, TWD_SHAPE_CYLINDER = 1, TWD_SHAPE_CUBE = 2, TWD_SHAPES = 3 };

/* Units a row, preferring 24, 26, ... 40 mm, each with a tuning width (standard deviation) of 2 mm. */
#define TWD_INPUT_SIZES 9

/* Units of the map. */
#define TWD_INPUTS (TWD_SHAPES * TWD_INPUT_SIZES)

/* Write the response to an object of `shape` and `size_m` (its radius, or the cube's diagonal, m) into `input`,
 * [TWD_INPUTS]. `squared_norm` is the sum of the squared responses for a size well inside the map, [0, 100]; values
 * beyond are clamped. */
void twd_input_map(enum twd_shape shape, twd_num size_m, twd_wide squared_norm, twd_num *input);

TWD_END_DECLARATIONS

#endif
