/* milliseconds.h - the benchmarks' clocks. */
#ifndef BENCH_MILLISECONDS_H
#define BENCH_MILLISECONDS_H

#include <stdlib.h>
#include <time.h>

#include "clock.h"

static inline double milliseconds(void)
{
    return (double)clock_now_us() * 1e-3;
}

/* Returns this process's CPU time in milliseconds, which other programs do not increase. */
static inline double cpu_milliseconds(void)
{
    struct timespec t;

    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

static inline int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

/* Returns the median of an odd number of measurements, and sorts them. */
static inline double median(double *values, size_t count)
{
    qsort(values, count, sizeof *values, by_value);
    return values[count / 2];
}

/* Updates the minimum of several measurements; *least is 0 before the first one. */
static inline void keep_least(double *least, double ms)
{
    if (*least <= 0 || ms < *least)
        *least = ms;
}

#endif
