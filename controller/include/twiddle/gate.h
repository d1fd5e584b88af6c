/* gate.h: the selector's mixture of several CPGs, and its map onto the joints.
 *
 * out = s_1 O_C + s_2 O_M + s_3 O_S with s_k = y_k / sum(y) (Ciancio et al. 2011, eqs. 4 and 5); the sum is then
 * saturated to [0, 1] and remapped onto each joint's range, in this order. controller.h can saturate each output too. */
#ifndef TWIDDLE_GATE_H
#define TWIDDLE_GATE_H

#include <twiddle/detail/controller_names.h>
#include <twiddle/number.h>

#include <stddef.h>

TWD_BEGIN_DECLARATIONS

/* Selector activations y (each > 0) to weights s that sum to 1; both are [count]. */
void twd_gate_normalise(const twd_num *activation, size_t count, twd_num *weight);

/* A fraction of a joint's range, saturated to [0, 1], as an angle in [lower_rad, upper_rad]. */
twd_num twd_gate_remap(twd_num fraction, twd_num lower_rad, twd_num upper_rad);

TWD_END_DECLARATIONS

#endif
