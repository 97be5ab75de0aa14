/* pages.c - memory in large pages, see pages.h. */
#include "pages.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#define LARGE_PAGE ((size_t)2 << 20)

/* Uses malloc for less than a large page; a system without large pages ignores the advice. */
void *pages_alloc(size_t size)
{
    size_t rounded = (size + LARGE_PAGE - 1) / LARGE_PAGE * LARGE_PAGE;
    void *memory;

    if (size < LARGE_PAGE || rounded < size)
        return malloc(size);
    memory = aligned_alloc(LARGE_PAGE, rounded);
    if (memory)
        (void)madvise(memory, rounded, MADV_HUGEPAGE);
    return memory;
}

void *pages_alloc_cleared(size_t size)
{
    void *memory = pages_alloc(size);

    if (memory)
        memset(memory, 0, size);
    return memory;
}
