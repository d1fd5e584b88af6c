/* agent_test.h: what the tests of the link share: cmocka with the headers it asks for, and a seeded generator that is
 * not the library's. */
#ifndef TWIDDLE_AGENT_TEST_H
#define TWIDDLE_AGENT_TEST_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <string.h>

/* Numerical Recipes' 64-bit linear congruential generator: the next number below `end`. */
static inline uint32_t random_below(uint64_t *random, uint32_t end)
{
    *random = *random * 6364136223846793005U + 1442695040888963407U;
    return (uint32_t)((*random >> 32) * end >> 32);
}

#endif
