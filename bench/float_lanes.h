/* float_lanes.h - the textbook's loop in lanes of float, without exactness: what the levels are measured against. */
#ifndef BENCH_FLOAT_LANES_H
#define BENCH_FLOAT_LANES_H

#include <tia/scene.h>

/* Draws a scene of two spheres and one light, each object as the ray meets it, in lanes of 4, 8 or 16 floats. False
 * where this processor has none so wide. */
bool float_lanes_render(const struct tia_scene *scene, int lanes, int width, int height, tia_rgb565 *pixels);

#endif
