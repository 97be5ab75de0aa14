/* world.h - from the coordinates of faces before the camera back to the world's axes and units, without its origin. */
#ifndef TIA_FLAT_WORLD_H
#define TIA_FLAT_WORLD_H

#include "lights.h"

#define TIA_WORLD_BITS 28 /* fraction bits of a place */

struct tia_world {
    /* A vertex q, whose coordinates are those of tia_flat_affine, has its place at m q 2^-places. */
    int64_t m[3][3];
    int places;
    const struct tia_flat_scene *flat;
    /* Q.45. Pixel (x, y) sees at the distance d what is at d (first + x right + y down), or in orthographic views at
     * first + x right + y down + d along. */
    int64_t first[3], right[3], down[3], along[3];
};

void tia_world_init(struct tia_world *world, const struct tia_flat_scene *flat);

/* The place of a vertex that is a point. */
void tia_world_place(const struct tia_world *world, const struct tia_raster_vertex *v, int64_t place[3]);

/* The direction of a vertex at infinity, or that from one point to another: Q1.62. */
void tia_world_direction(const struct tia_world *world, const struct tia_raster_vertex *v, int64_t direction[3]);
void tia_world_from_to(const struct tia_world *world, const struct tia_raster_vertex *from,
                       const struct tia_raster_vertex *to, int64_t direction[3]);

/* What pixel (x, y) sees at a distance from tia_raster_distance. */
void tia_world_seen(const struct tia_world *world, int x, int y, int64_t distance, int64_t place[3]);

#endif
