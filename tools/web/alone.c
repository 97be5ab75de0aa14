/* alone.c - replaces the thread pool: a page has one thread, so there are no workers. */
#include <stddef.h>

#include "common/thread_pool.h"

const struct tia_workers *threads_workers(const struct threads *pool)
{
    (void)pool;
    return NULL;
}

struct threads *threads_create(unsigned count)
{
    (void)count;
    return NULL;
}

void threads_destroy(struct threads *pool)
{
    (void)pool;
}
