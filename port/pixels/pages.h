/* pages.h - memory in large pages, whose first use is fast: for pictures, and for data of each pixel. */
#ifndef PORT_PAGES_H
#define PORT_PAGES_H

#include <stddef.h>

/* Allocates at least `size` bytes for free(), in pages of 2 MB where the system has them: they cause few page faults at
 * first use, and few TLB misses later. NULL: no memory. */
void *pages_alloc(size_t size);

/* Allocates memory like pages_alloc, all zero and with all pages present: no page fault is left for the first frame. */
void *pages_alloc_cleared(size_t size);

#endif
