/* two_threads.h - measures the gain of a frame on two threads. */
#ifndef BENCH_TWO_THREADS_H
#define BENCH_TWO_THREADS_H

void bench_threads(void);

#endif
