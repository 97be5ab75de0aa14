/* float_lanes.h - the textbook loop in SIMD lanes of float, without exact results: the baseline of the SIMD kernels. */
#ifndef BENCH_FLOAT_LANES_H
#define BENCH_FLOAT_LANES_H

#include <stdbool.h>
#include <tia/scene.h>

/* Draws a scene of two spheres and one light with the instruction set `simd`. Returns false if this program has no loop
 * for that set. The processor must have the instructions: tia_simd_named checks that. */
bool float_lanes_render(const struct tia_scene *scene, const char *simd, int width, int height, tia_rgb565 *pixels);

/* The scene in float. In each array, elements 0 and 1 are the spheres, and element 2 is the light. */
struct lanes_world {
    float centre[3][3], c[3], radius2[3], per_radius[3];
    float colour[2][3], glow[3], background[3]; /* in levels of RGB565: full intensity is 31 or 63 */
    float start, step, up; /* v.x of the first pixel, step of v from pixel to pixel, v.y of the first row */
    tia_rgb565 sky[16];
};

#define FLOAT_LANES(simd) float_lanes_##simd(const struct lanes_world *, int width, int height, tia_rgb565 *pixels)
void FLOAT_LANES(sse41);
void FLOAT_LANES(avx2);
void FLOAT_LANES(avx512);
void FLOAT_LANES(neon);
void FLOAT_LANES(rvv);

#endif
