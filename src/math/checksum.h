/* checksum.h - a checksum of memory, for the machine that computed it: Fletcher's, of 32-bit words modulo 2^32 - 1.
 *
 * With words w_1 .. w_n the value is sum(w_i) and sum((n + 1 - i) w_i). A changed bit changes the first sum by 2^a,
 * which is not 0 modulo 2^32 - 1. Two changed bits leave the first sum as it is only if they are the same bit of two
 * words, changed in opposite directions; then the second sum changes by (j - i) 2^a, which is not 0 below 2^32 - 1
 * words. Takes 5 to 7 instructions a word on a Cortex-M3, a fifth of a CRC's. */
#ifndef TIA_MATH_CHECKSUM_H
#define TIA_MATH_CHECKSUM_H

#include <stddef.h>
#include <stdint.h>

/* All zero at first. */
struct checksum {
    uint64_t first, second;
};

/* Adds `size` bytes; the last word is filled up with zeros. */
void tia_checksum_add(struct checksum *sum, const void *memory, size_t size);

/* Returns the two sums, the first one in the lower half. */
uint64_t tia_checksum_value(const struct checksum *sum);

#endif
