/* pages.h - memory that is as fast at first use as later: for pictures, and for data of each pixel. */
#ifndef PORT_PAGES_H
#define PORT_PAGES_H

#include <stddef.h>

/* Allocates at least `size` bytes for free(), in pages of 2 MB where the system has them: first use takes few page
 * faults, and later the processor needs few page tables. NULL: memory is short. */
void *pages_alloc(size_t size);

/* Allocates memory like pages_alloc, all zero and with all pages present: no page fault is left for the first frame. */
void *pages_alloc_cleared(size_t size);

#endif
