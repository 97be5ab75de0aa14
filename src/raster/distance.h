/* distance.h - the distance of the point of a plane that a pixel shows. */
#ifndef TIA_RASTER_DISTANCE_H
#define TIA_RASTER_DISTANCE_H

#include <tia/raster.h>

#define TIA_DISTANCE_BITS 45

/* Returns the distance from the eye, along the line of sight, of the plane's point at pixel (x, y) of the image: w, or
 * in orthographic views -h; at most 2^62. It has TIA_DISTANCE_BITS fraction bits, and a relative error below 2^-58,
 * plus half a unit. Returns 0 where the plane is not in front of the eye, and outside the image. */
int64_t tia_raster_distance(const struct tia_raster_plane *plane, const struct tia_raster_grid *grid, int x, int y);

/* Does the work of tia_raster_distance without its checks: (x, y) is a pixel of the image. */
int64_t tia_plane_distance(const struct tia_raster_plane *plane, const struct tia_raster_grid *grid, int x, int y);

#endif
