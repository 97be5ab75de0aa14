/* checked.h - memory for the benchmarks. */
#ifndef BENCH_CHECKED_H
#define BENCH_CHECKED_H

#include <stdio.h>
#include <stdlib.h>

/* Returns `memory`, or ends the program if it is NULL: there is none left. */
static inline void *checked(void *memory)
{
    if (!memory) {
        (void)fprintf(stderr, "bench: out of memory\n");
        exit(1);
    }
    return memory;
}

#endif
