#include <twiddle/random.h>

static uint32_t rotate_left(uint32_t value, unsigned bits)
{
    return (value << bits) | (value >> (32U - bits));
}

/* One output of SplitMix64, whose state is a counter in steps of the golden ratio. */
static uint64_t splitmix64(uint64_t *counter)
{
    *counter += 0x9E3779B97F4A7C15U;
    uint64_t mixed = *counter;
    mixed = (mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9U;
    mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EBU;
    return mixed ^ (mixed >> 31);
}

void twd_random_seed(struct twd_random *random, uint64_t seed)
{
    /* SplitMix64 maps its counter one to one, so two outputs in a row are never both 0, and no seed gives the all-zero
     * state. */
    for (int word = 0; word < 4; word += 2) {
        const uint64_t output = splitmix64(&seed);
        random->state[word] = (uint32_t)output;
        random->state[word + 1] = (uint32_t)(output >> 32);
    }
}

uint32_t twd_random_next(struct twd_random *random)
{
    uint32_t *const state = random->state;
    const uint32_t result = rotate_left(state[0] + state[3], 7) + state[0];
    const uint32_t shifted = state[1] << 9;

    state[2] ^= state[0];
    state[3] ^= state[1];
    state[1] ^= state[2];
    state[0] ^= state[3];
    state[2] ^= shifted;
    state[3] = rotate_left(state[3], 11);
    return result;
}

twd_num twd_random_symmetric(struct twd_random *random, twd_num half_range)
{
    const int32_t half = (int32_t)1 << 23;
    const int32_t draw = (int32_t)(twd_random_next(random) >> 8) - half;
    return twd_mul(half_range, twd_ratio(draw, half));
}
