/* runs.h - what a vector unit takes over from the rasteriser: the runs of pixels in which nearness is stepped. Only
 * integers, so every unit gives the bits of plain C. */
#ifndef TIA_RASTER_RUNS_H
#define TIA_RASTER_RUNS_H

#include "depth.h"

/* Data that all runs of a polygon share. */
struct raster_polygon {
    uint64_t *nearness; /* the target's */
    uint32_t *face, *count;
    uint64_t step; /* of the polygon's nearness, from a pixel to the next */
    uint32_t own;  /* its face */
    bool nearer;   /* count where it is nearer, else where it is not */
    uint32_t one;  /* what to add there */

    /* Where the filter is unsure, and what is there is another face: whether the polygon is nearer at that index. */
    bool (*is_nearer)(const void *ctx, size_t at);
    const void *ctx;
};

/* A run of `pixels` from index `at` on, where the polygon's nearness is z. */
typedef void raster_run_kernel(const struct raster_polygon *p, size_t at, int pixels, uint64_t z);

struct tia_raster_runs {
    raster_run_kernel *nearest; /* where the polygon is nearer, its nearness and face are put */
    raster_run_kernel *add;     /* counts */
};

/* Plain C. */
extern const struct tia_raster_runs tia_raster_runs_plain;

#endif
