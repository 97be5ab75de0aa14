/* threads.h - tia_workers (tia/port.h) on POSIX threads: the one place that starts any. */
#ifndef PORT_THREADS_H
#define PORT_THREADS_H

#include <tia/port.h>

#define THREADS_MAX 1024u

struct threads;

/* How many processors this process may use, 1..THREADS_MAX. */
unsigned threads_processors(void);

/* A pool that works on `count` threads: the caller of run and count - 1 more, which take no
 * signals. With fewer threads to be had it works on those. NULL: no memory. */
struct threads *threads_create(unsigned count);

/* On how many threads it works. */
unsigned threads_count(const struct threads *pool);

/* Ends the threads. NULL is fine. */
void threads_destroy(struct threads *pool);

/* Its context is the pool. Not to be called from a job, nor from two threads at once. */
extern const struct tia_workers threads_workers;

#endif
