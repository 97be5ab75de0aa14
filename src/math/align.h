/* align.h - arrays that lie one after the other in the caller's memory: their sizes, and whether it can hold them. */
#ifndef TIA_MATH_ALIGN_H
#define TIA_MATH_ALIGN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A size, of any integer type, rounded up so that the next array is aligned for uint64_t. */
#define ALIGN(size) (((size) + 7) / 8 * 8)

/* What alignment for uint64_t is here: 1 on an AVR, 4 on an i386, 8 elsewhere. */
struct align_probe {
    char before;
    uint64_t number;
};
#define ALIGN_NUMBER offsetof(struct align_probe, number)

/* Whether the caller's memory is there, and aligned for uint64_t. */
static inline bool memory_is_usable(const void *memory)
{
    return memory && (uintptr_t)memory % ALIGN_NUMBER == 0;
}

#endif
