/* stage.h - draws a frame of the benchmark, as often as one likes. */
#ifndef TOOLS_BENCHMARK_STAGE_H
#define TOOLS_BENCHMARK_STAGE_H

#include <stdatomic.h>

#include <tia/tia.h>

#include "benchmark.h"
#include "common/thread_pool.h"

struct benchmark_memory {
    void *at;
    size_t size;
};

struct benchmark_stage {
    const struct benchmark_frame *frame;
    struct tia_scene scene; /* with its hierarchy */
    unsigned job_rows;
    tia_rgb565 *pixels; /* of the whole frame */
    uint32_t *crcs;     /* CRC-32 of each job's rows */
    struct tia_view *view;
    struct tia_hits *hits;
    struct benchmark_memory scene_memory, boxes, view_memory, hits_memory, simd_memory;
    atomic_int status; /* the last error of a job */
};

/* Reads the frame's scene, builds its hierarchy and allocates the pixels. Returns a negative status on failure;
 * benchmark_close is to be called in any case. */
int benchmark_open(struct benchmark_stage *stage, const struct benchmark_frame *frame);
void benchmark_close(struct benchmark_stage *stage);

/* Prepares the view, as benchmark_draw does at first, for that number of threads. */
int benchmark_prepare(struct benchmark_stage *stage, const struct tia_simd *simd, unsigned threads);

/* Draws the frame from its scene: the view, its lights, all pixels. `simd`: an instruction set, NULL for plain C. The
 * first time with more threads, or another instruction set, memory is allocated. Returns a negative status on failure.
 */
int benchmark_draw(struct benchmark_stage *stage, const struct tia_simd *simd, struct threads *pool);

/* Returns the CRC-32 of the pixels, and overwrites them, so that no pixel of one frame can pass for one of the next. */
uint32_t benchmark_check_pixels(struct benchmark_stage *stage, struct threads *pool);

#endif
