/* random.h: a small seeded generator, xoshiro128++ 1.0 by Blackman and Vigna (prng.di.unimi.it), seeded by SplitMix64.
 *
 * 32-bit additions, shifts and rotations only, so that it costs little on any core. Not for cryptography. */
#ifndef TWIDDLE_RANDOM_H
#define TWIDDLE_RANDOM_H

#include <twiddle/detail/learner_names.h>
#include <twiddle/number.h>

TWD_BEGIN_DECLARATIONS

/* The state; never all zero. */
struct twd_random {
    uint32_t state[4];
};

/* Seed from any 64-bit number: the state is two outputs of SplitMix64, low word first. */
void twd_random_seed(struct twd_random *random, uint64_t seed);

/* The next 32 random bits. */
uint32_t twd_random_next(struct twd_random *random);

/* A uniform number in [-half_range, half_range), from the upper 24 bits of one draw, the same draw in every number
 * build. */
twd_num twd_random_symmetric(struct twd_random *random, twd_num half_range);

TWD_END_DECLARATIONS

#endif
