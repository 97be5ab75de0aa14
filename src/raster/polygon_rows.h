/* polygon_rows.h - the pixels that a polygon covers, as one run in each row. */
#ifndef TIA_RASTER_POLYGON_ROWS_H
#define TIA_RASTER_POLYGON_ROWS_H

#include "polygon.h"

/* Draws pixels x0 <= x < x1 of row y; x0 < x1. */
typedef void raster_run(void *ctx, int y, int x0, int x1);

/* Calls `run` for each row with covered pixels, downwards. */
void tia_polygon_rows(const struct polygon *p, raster_run *run, void *ctx);

#endif
