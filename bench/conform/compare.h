/* compare.h - compares what draws triangles with the exact rasteriser, and says what was found. */
#ifndef BENCH_CONFORM_COMPARE_H
#define BENCH_CONFORM_COMPARE_H

#include "trial.h"

struct conform_plan {
    unsigned trials, step; /* corners are multiples of step/256 pixel, 1..256 */
    uint64_t seed;         /* not 0 */
};

struct conform_tested {
    trial_drawer *draw;
    void *ctx;
    const char *driver;
    void (*say)(void *ctx, const char *text); /* receives text in parts; lines end with newlines */
    void *say_ctx;
};

enum conform_result { CONFORM_SAME, CONFORM_DIFFERS, CONFORM_FAILED };

/* Draws all trials; says the smallest finding of each rule, and the numbers. */
int conform_compare(const struct conform_plan *plan, const struct conform_tested *tested);

#endif
