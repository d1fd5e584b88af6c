/* fixed_words.h: words to test the fixed build with, all edges and random pairs of all sizes, and exact 64-bit
 * arithmetic, which divides where the library shifts.
 *
 * A product of two words is exact in 64 bits. INT32_MIN, which is no number, counts among the edges, since a saturated
 * result of it must be a number again. */
#ifndef TWIDDLE_FIXED_WORDS_H
#define TWIDDLE_FIXED_WORDS_H

#include "c_test.h"

static const int32_t sizes[] = {0,          1,          2,          3,          0x7FFF,     0x8000,     0x8001,
                                0xFFFF,     0x10000,    0x10001,    0x100000,   0xFFFFFF,   0x1000000,  0xFFFFFFF,
                                0x10000000, 0x10000001, 0x40000000, 0x5A5A5A5A, 0x7FFF0001, 0x7FFFFFFE, INT32_MAX};
enum { SIZES = sizeof sizes / sizeof sizes[0], EDGES = 2 * SIZES + 1 };

/* The edges are the sizes above with both signs, and INT32_MIN. */
static inline int32_t edge(size_t index)
{
    if (index == 2 * SIZES) return INT32_MIN;
    return index < SIZES ? sizes[index] : -sizes[index - SIZES];
}

/* A word of any size: 32 random bits, shifted right by 0 to 31. */
static inline int32_t random_word(uint64_t *random)
{
    *random = *random * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    const int64_t word = (int64_t)(*random >> 32) - ((int64_t)1 << 31);
    return (int32_t)(word / ((int64_t)1 << (*random >> 8 & 31U)));
}

/* Hand all pairs of edges, and a million random pairs, to `check`. */
static inline void for_all_pairs(void (*check)(int32_t a, int32_t b))
{
    uint64_t random = 20110824U;
    for (size_t i = 0; i < EDGES; i++)
        for (size_t k = 0; k < EDGES; k++)
            check(edge(i), edge(k));
    for (int32_t pair = 0; pair < CASES(1000000L); pair++) {
        const int32_t a = random_word(&random);
        check(a, random_word(&random));
    }
}

/* Assert that `operation` of a and b gives what is expected; on chips the low words tell. */
static inline void assert_word(const char *operation, int32_t a, int32_t b, int64_t actual, int64_t expected)
{
    if (actual == expected) return;
    print_error("%s of %ld and %ld: got %ld, expected %ld\n", operation, (long)a, (long)b, (long)actual,
                (long)expected);
    fail();
}

/* The largest whole number that is at most numerator / divisor; divisor > 0. */
static inline int64_t floor_quotient(int64_t numerator, int64_t divisor)
{
    const int64_t truncated = numerator / divisor;
    return numerator % divisor < 0 ? truncated - 1 : truncated;
}

static inline int64_t limited(int64_t value)
{
    if (value > INT32_MAX) return INT32_MAX;
    return value < -(int64_t)INT32_MAX ? -(int64_t)INT32_MAX : value;
}

#endif
