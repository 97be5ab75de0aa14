/* two_threads.h - how much faster a frame is on two threads. */
#ifndef BENCH_TWO_THREADS_H
#define BENCH_TWO_THREADS_H

void bench_threads(void);

#endif
