/* align.h - sizes of arrays that lie one after the other in the caller's memory. */
#ifndef TIA_MATH_ALIGN_H
#define TIA_MATH_ALIGN_H

/* A size, of any integer type, rounded up so that the next array is aligned for uint64_t. */
#define ALIGN(size) (((size) + 7) / 8 * 8)

#endif
