/* thread_pool.h - tia_workers (tia/job.h) on POSIX threads. No other file starts threads. */
#ifndef TOOLS_THREAD_POOL_H
#define TOOLS_THREAD_POOL_H

#include <tia/job.h>

#define THREADS_MAX 1024u

struct threads;

/* Returns the number of processors that this process may use, 1..THREADS_MAX. */
unsigned threads_processors(void);

/* Creates a pool of `count` threads: the caller of run and count - 1 others, which block signals. The pool has fewer if
 * the system permits no more. Returns NULL if there is no memory. */
struct threads *threads_create(unsigned count);

/* Returns the number of threads, including the caller of run. */
unsigned threads_count(const struct threads *pool);

/* Ends the threads. NULL is allowed. */
void threads_destroy(struct threads *pool);

/* Runs jobs, see tia_workers.run. Do not call it from a job, nor from two threads at once. */
void threads_run(struct threads *pool, void (*job)(void *arg, unsigned index), void *arg, unsigned count);

/* Returns the pool's threads as workers, valid as long as the pool; NULL without a pool. */
const struct tia_workers *threads_workers(const struct threads *pool);

#endif
