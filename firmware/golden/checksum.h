/* checksum.h: one number for all the state of the library, the same on every machine: 32-bit FNV-1a over the bytes of
 * its words, low byte first, field by field. */
#ifndef TWIDDLE_GOLDEN_CHECKSUM_H
#define TWIDDLE_GOLDEN_CHECKSUM_H

#include <twiddle/controller.h>
#include <twiddle/learner.h>

#if !defined(TWD_NUMBER_FIXED)
#error "bit identity is promised for the fixed build: compile with TWD_NUMBER_FIXED"
#endif

/* Of nothing. */
#define CHECKSUM_START UINT32_C(0x811C9DC5)

/* Take `count` words into `sum`: phases, counters, or numbers of any type. */
void checksum_words(uint32_t *sum, const uint32_t *word, size_t count);
void checksum_numbers(uint32_t *sum, const int32_t *number, size_t count);

/* Take all that a controller has computed, at set-up and since. */
void checksum_controller(uint32_t *sum, const struct twd_controller *controller);

/* Take all that a learner has learned and remembers. */
void checksum_learner(uint32_t *sum, const struct twd_learner *learner);

#endif
