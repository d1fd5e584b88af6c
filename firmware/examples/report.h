/* report.h: what the examples say at their end, without printf. */
#ifndef TWIDDLE_EXAMPLES_REPORT_H
#define TWIDDLE_EXAMPLES_REPORT_H

#include <twiddle/number.h>

#include <stddef.h>

/* Write `what` and a count, or numbers with three digits behind the point (cut, not rounded), and end the line. */
void report_count(const char *what, uint32_t count);
void report_numbers(const char *what, const twd_num *number, size_t count);

/* The same in the fixed build alone, whose words are the same on every board: a checksum. */
void report_checksum(const char *what, uint32_t sum);

/* Of nothing. */
#define REPORT_CHECKSUM_START UINT32_C(0x811C9DC5)

/* `sum` and `count` numbers more: 32-bit FNV-1a over the bytes of their words, low byte first. In the other builds
 * `sum` alone. */
uint32_t report_checksum_of(uint32_t sum, const twd_num *number, size_t count);

#endif
