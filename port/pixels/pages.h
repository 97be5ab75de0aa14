/* pages.h - memory that is as fast at first use as later: for pictures, and for what is kept of each pixel. */
#ifndef PORT_PAGES_H
#define PORT_PAGES_H

#include <stddef.h>

/* At least `size` bytes for free(), in pages of 2 MB where the system has them, so that using them for the first time
 * takes few page faults, and later the processor finds them at once. NULL: no memory. */
void *pages_alloc(size_t size);

/* The same, all zero and in memory already: no page fault is left for the first frame. */
void *pages_alloc_cleared(size_t size);

#endif
