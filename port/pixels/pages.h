/* pages.h - memory in large pages, as fast at first use as later: for pictures, and for data of each pixel. */
#ifndef PORT_PAGES_H
#define PORT_PAGES_H

#include <stddef.h>

/* Returns at least `size` bytes for free(), in pages of 2 MB where the system has them: the first use takes few page
 * faults, and later uses few misses of the TLB. NULL: no memory. */
void *pages_alloc(size_t size);

/* Returns the same, all zero and in memory already: no page fault is left for the first frame. */
void *pages_alloc_cleared(size_t size);

#endif
