/* raster.h - measures the rasteriser alone, on the polygons of mesh_scene.h. */
#ifndef BENCH_RASTER_H
#define BENCH_RASTER_H

#include "mesh_scene.h"

#include <tia/raster.h>

/* A mesh projected to an image, and the image's buffers. */
struct raster_bench {
    struct tia_raster_grid grid;
    struct tia_raster_target target;
    struct tia_raster_vertex (*polygon)[3];
    uint32_t count;
    void *memory;
};

/* Ends the program if `fine` is false. */
void raster_bench_must(bool fine);

/* Makes the mesh of a level (the depth of bench_mesh) in *m, and projects it to an image whose buffers are the set
 * `buffers` of TIA_BUFFER_.... */
void raster_bench_init(struct raster_bench *b, struct mesh *m, int level, uint16_t width, uint16_t height,
                       unsigned buffers);
void raster_bench_free(struct raster_bench *b);

/* Draws the nearest face of each pixel into a target, which may have fewer buffers than the benchmark's. */
void raster_bench_nearest(const struct raster_bench *b, struct tia_raster_target *target);

void bench_raster(void);

#endif
