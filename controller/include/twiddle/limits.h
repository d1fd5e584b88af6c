/* limits.h: the compile-time sizes of every array in the library.
 *
 * All memory is static, so the largest network is decided here. Each limit may be raised or lowered with
 * -DNAME=value; the library and the code that includes its headers must then be compiled with the same value. */
#ifndef TWIDDLE_LIMITS_H
#define TWIDDLE_LIMITS_H

/* Oscillators of one controller, of all its CPGs together. */
#ifndef TWD_MAX_OSCILLATORS
#define TWD_MAX_OSCILLATORS 8
#endif

/* Couplings (edges, each acting both ways) of one controller, of all its CPGs together. */
#ifndef TWD_MAX_COUPLINGS
#define TWD_MAX_COUPLINGS 12
#endif

/* Joints that one controller drives. */
#ifndef TWD_MAX_JOINTS
#define TWD_MAX_JOINTS 8
#endif

/* CPGs that one controller mixes. */
#ifndef TWD_MAX_CPGS
#define TWD_MAX_CPGS 3
#endif

/* Joints of one serial finger chain, moving and held together. */
#ifndef TWD_MAX_CHAIN_JOINTS
#define TWD_MAX_CHAIN_JOINTS 4
#endif

/* Finger chains whose weight one controller compensates. */
#ifndef TWD_MAX_CHAINS
#define TWD_MAX_CHAINS 5
#endif

#endif
