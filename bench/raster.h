/* raster.h - the rasteriser: a ground, a ball, a box and a ring of 98 to 86,030 faces. */
#ifndef BENCH_RASTER_H
#define BENCH_RASTER_H

void bench_raster(void);

#endif
