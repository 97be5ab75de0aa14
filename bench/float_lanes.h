/* float_lanes.h - the textbook's loop in lanes of float, without exactness: what the levels are measured against. */
#ifndef BENCH_FLOAT_LANES_H
#define BENCH_FLOAT_LANES_H

#include <stdbool.h>
#include <tia/scene.h>

/* Draws a scene of two spheres and one light, each object as the ray meets it, with the instructions of a level. False
 * where this program has no loop for it; whether the processor has them is for tia_simd_named. */
bool float_lanes_render(const struct tia_scene *scene, const char *simd, int width, int height, tia_rgb565 *pixels);

/* What of the scene a pixel needs: spheres, then the light. */
struct lanes_world {
    float centre[3][3], c[3], radius2[3], per_radius[3];
    float colour[2][3], glow[3], background[3]; /* in levels of 31 and 63 */
    float start, step, up; /* v.x of the first pixel, and from one to the next; v.y of the first row */
    tia_rgb565 sky[16];
};

#define FLOAT_LANES(simd) float_lanes_##level(const struct lanes_world *, int width, int height, tia_rgb565 *pixels)
void FLOAT_LANES(sse41);
void FLOAT_LANES(avx2);
void FLOAT_LANES(avx512);
void FLOAT_LANES(neon);

#endif
