/* shadows_gl.h - the polygons of shadows.h drawn by one of Mesa's software rasterisers, on one thread. */
#ifndef BENCH_SHADOWS_GL_H
#define BENCH_SHADOWS_GL_H

/* Measures the driver "llvmpipe" or "softpipe", in a process of its own. */
void bench_shadows_gl(const char *driver);

#endif
