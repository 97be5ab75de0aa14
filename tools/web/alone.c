/* alone.c - a page has one thread: there is no pool, and who asks for one works alone. */
#include <stddef.h>

#include "common/thread_pool.h"

const struct tia_workers threads_workers = {NULL, NULL, NULL};

struct threads *threads_create(unsigned count)
{
    (void)count;
    return NULL;
}

void threads_destroy(struct threads *pool)
{
    (void)pool;
}
