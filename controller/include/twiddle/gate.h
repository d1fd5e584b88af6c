/* gate.h: the weights with which the selector mixes several CPGs.
 *
 * out = s_1 O_C + s_2 O_M + s_3 O_S with s_k = y_k / sum(y) (Ciancio et al. 2011, eqs. 4 and 5). What becomes of the
 * sum: joint_range.h, and enum twd_saturation of controller.h. */
#ifndef TWIDDLE_GATE_H
#define TWIDDLE_GATE_H

#include <twiddle/detail/controller_names.h>
#include <twiddle/number.h>

#include <stddef.h>

TWD_BEGIN_DECLARATIONS

/* Selector activations y (each > 0) to weights s that sum to 1; both are [count]. */
void twd_gate_normalise(const twd_num *activation, size_t count, twd_num *weight);

TWD_END_DECLARATIONS

#endif
