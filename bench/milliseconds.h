/* milliseconds.h - the benchmarks' clock. */
#ifndef BENCH_MILLISECONDS_H
#define BENCH_MILLISECONDS_H

#include "clock.h"

static inline double milliseconds(void)
{
    return (double)clock_now_us() * 1e-3;
}

#endif
