/* strips.h - the rows of a tile on displays without a limit. */
#ifndef TIA_VIEWER_STRIPS_H
#define TIA_VIEWER_STRIPS_H

#include <tia/render.h>

/* Returns the rows of a tile behind the rasteriser, for a frame of width x height pixels that `workers` draw. */
unsigned tia_strips_raster_rows(const struct tia_scene *scene, unsigned width, unsigned height, unsigned workers);

#endif
