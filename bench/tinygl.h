/* tinygl.h - the polygons of raster.h drawn by TinyGL, a software rasteriser in C with 16-bit depths. */
#ifndef BENCH_TINYGL_H
#define BENCH_TINYGL_H

void bench_tinygl(void);

#endif
