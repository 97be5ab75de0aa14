/* world.h - converts the coordinates of vertices back to the world's axes and units; positions stay relative to the
 * eye. */
#ifndef TIA_FLAT_WORLD_H
#define TIA_FLAT_WORLD_H

#include "light_vertices.h"

#define TIA_WORLD_BITS 28 /* fraction bits of a position */

struct tia_world {
    /* matrix: a vertex q, in the coordinates of tia_flat_affine, is at m q 2^-places */
    int64_t m[3][3];
    int places;
    const struct tia_flat_scene *flat;
    /* Q.45. Pixel (x, y) shows, at the distance d, the point d (first + x right + y down), or in orthographic views
     * first + x right + y down + d along. */
    int64_t first[3], right[3], down[3], along[3];
};

void tia_world_init(struct tia_world *world, const struct tia_flat_scene *flat);

/* Gives the position of a vertex that is a point, with TIA_WORLD_BITS fraction bits. */
void tia_world_place(const struct tia_world *world, const struct tia_raster_vertex *v, int64_t place[3]);

/* Gives the direction of a vertex at infinity, Q1.62. */
void tia_world_direction(const struct tia_world *world, const struct tia_raster_vertex *v, int64_t direction[3]);
/* Gives the direction from one point to another, Q1.62. */
void tia_world_from_to(const struct tia_world *world, const struct tia_raster_vertex *from,
                       const struct tia_raster_vertex *to, int64_t direction[3]);

/* Gives the point that pixel (x, y) shows at a distance, as tia_raster_distance returns it. The point has
 * TIA_WORLD_BITS fraction bits. */
void tia_world_seen(const struct tia_world *world, int x, int y, int64_t distance, int64_t place[3]);

#endif
