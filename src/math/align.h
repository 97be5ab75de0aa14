/* align.h - sizes of what lies in the caller's memory, one after the other. */
#ifndef TIA_SRC_ALIGN_H
#define TIA_SRC_ALIGN_H

/* The size, an integer of any width, rounded up so that what follows is aligned for uint64_t. */
#define ALIGN(size) (((size) + 7) / 8 * 8)

#endif
