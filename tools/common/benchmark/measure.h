/* measure.h - measures how many frames are drawn in a second. */
#ifndef TOOLS_BENCHMARK_MEASURE_H
#define TOOLS_BENCHMARK_MEASURE_H

#include "stage.h"

/* The end of a measurement. */
struct benchmark_limit {
    uint32_t frames; /* number of frames; 0: as many as fit into `us`, but at least one */
    uint64_t us;     /* microseconds, including those of a first frame, which does not count, and of the CRCs */
};

struct benchmark_score {
    uint32_t rate; /* frames per 1000 seconds, rounded down, at least 1; 0: no score, since a frame was wrong */
    uint32_t crc;  /* CRC-32 of the last frame that was drawn */
};

/* Draws the stage's frame again and again, and compares the CRC-32 of each drawn frame with the known one. The time is
 * that of benchmark_draw alone: CPU time of the process with one thread, else of the clock. Returns a negative status
 * on failure. */
int benchmark_measure(struct benchmark_stage *stage, const struct tia_simd *simd, struct threads *pool,
                      const struct benchmark_limit *limit, struct benchmark_score *score);

#endif
