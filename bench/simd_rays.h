/* simd_rays.h - compares the SIMD kernels for general rays with plain C and double precision. */
#ifndef BENCH_SIMD_RAYS_H
#define BENCH_SIMD_RAYS_H

/* Only scenes whose names contain this text are measured; NULL: all scenes. */
extern const char *bench_scene;

void bench_simd_rays(void);

#endif
