/* distance.h - the distance of a plane's point at a pixel. */
#ifndef TIA_RASTER_DISTANCE_H
#define TIA_RASTER_DISTANCE_H

#include <tia/raster.h>

/* Does the work of tia_raster_distance without its checks: (x, y) is a pixel of the image. */
int64_t tia_plane_distance(const struct tia_raster_plane *plane, const struct tia_lattice *lattice, int x, int y);

#endif
