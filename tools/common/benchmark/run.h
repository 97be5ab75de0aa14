/* run.h - runs the benchmark: a table of scores, row by row, and the line of the result. */
#ifndef TOOLS_BENCHMARK_RUN_H
#define TOOLS_BENCHMARK_RUN_H

#include <stdio.h>

#include "line.h"
#include "measure.h"

struct benchmark_wish {
    const struct benchmark_frame *frames; /* [BENCHMARK_FRAMES]: benchmark_frames */
    const struct tia_simd *widest;        /* the widest instruction set; NULL: plain C alone */
    unsigned threads;                     /* most threads; measured are 1, 2, 4 ... and this number */
    uint32_t each;                        /* frames of a score; 0: the time is shared out */
    uint64_t us;                          /* microseconds for all scores */
    FILE *out;
};

/* The results: all scores; some frames were wrong, so there is no total and no line; the output cannot be written; the
 * drawing failed, with the reason in why[BENCHMARK_WHY]. */
enum { BENCHMARK_FINE, BENCHMARK_WRONG, BENCHMARK_NO_OUTPUT, BENCHMARK_FAILED };

int benchmark_run(const struct benchmark_wish *wish, char *why);

#endif
