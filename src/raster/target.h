/* target.h - indices of pixels in a target's buffers, and parts of targets. */
#ifndef TIA_RASTER_TARGET_H
#define TIA_RASTER_TARGET_H

#include <tia/raster.h>

/* Returns the index of pixel (x, y) of the image in buffers with one value per pixel. */
static inline size_t target_index(const struct tia_raster_target *t, int x, int y)
{
    return ((size_t)y - t->area.y) * (size_t)t->pitch + ((size_t)x - t->area.x);
}

/* Returns the column right of the target's area. */
static inline int target_right(const struct tia_raster_target *t)
{
    return (int)t->area.x + (int)t->area.width;
}

/* Returns the row below the target's area. */
static inline int target_bottom(const struct tia_raster_target *t)
{
    return (int)t->area.y + (int)t->area.height;
}

/* Makes *part a target for the pixels of `area`, in the buffers of another target. Returns TIA_OK, or TIA_ERR_ARGUMENT
 * when the area is empty or not inside. Threads may draw at the same time into parts that share no pixel, if the planes
 * are already stored. */
int tia_raster_part(struct tia_raster_target *part, const struct tia_raster_target *target, struct tia_tile area);

/* Gives the plane of a polygon as tia_raster_draw stores it, with the same errors. */
int tia_raster_plane_init(struct tia_raster_plane *plane, const struct tia_raster_grid *grid,
                          const struct tia_raster_vertex *corners, unsigned count);

#endif
