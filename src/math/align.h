/* align.h - sizes and alignment of consecutive arrays in the caller's memory. */
#ifndef TIA_MATH_ALIGN_H
#define TIA_MATH_ALIGN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Rounds a size of any integer type up to a multiple of 8, so that the next array is aligned for uint64_t. */
#define ALIGN(size) (((size) + 7) / 8 * 8)

/* A struct in which `number` has the alignment of uint64_t as its offset: 1 on an AVR, 4 on an i386, 8 elsewhere. */
struct align_probe {
    char before;
    uint64_t number;
};
#define ALIGN_NUMBER offsetof(struct align_probe, number)

/* True if the caller's memory is not NULL and aligned for uint64_t. */
static inline bool memory_is_usable(const void *memory)
{
    return memory && (uintptr_t)memory % ALIGN_NUMBER == 0;
}

#endif
