/* runs.h - runs of pixels in which nearness is stepped: the part of the rasteriser of which vector units have versions
 * of their own. All is in integers, so every version gives the same bits as plain C. */
#ifndef TIA_RASTER_RUNS_H
#define TIA_RASTER_RUNS_H

#include "depth.h"

struct tia_shadow_kernels;

/* Data that all runs of a polygon share. */
struct raster_polygon {
    uint64_t *nearness; /* buffer of the target, like face and count */
    uint32_t *face, *count;
    uint64_t step; /* step of the polygon's nearness to the next pixel */
    uint32_t own;  /* the polygon's face number */
    bool nearer;   /* true: counts change where the polygon is nearer; false: where it is not */
    uint32_t one;  /* the increment of the counts */

    /* True if the polygon is nearer than a different face, stored at this index; for pixels where nearness does not
     * decide. */
    bool (*is_nearer)(const void *ctx, size_t at);
    const void *ctx;
    const uint32_t *equal; /* last face found to be in the polygon's plane: all its pixels have one answer */
};

/* Draws a run of `pixels` pixels from index `at` on, where the polygon's nearness is z. */
typedef void raster_run_kernel(const struct raster_polygon *p, size_t at, int pixels, uint64_t z);

struct tia_raster_runs {
    raster_run_kernel *nearest;               /* stores nearness and face where the polygon is nearer */
    raster_run_kernel *add;                   /* adds to the counts */
    const struct tia_shadow_kernels *shadows; /* see shadow/kernels.h; NULL: plain C */
};

/* The runs in plain C. */
extern const struct tia_raster_runs tia_raster_runs_plain;

#endif
