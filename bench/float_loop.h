/* float_loop.h - the textbook loop in scalar float, as a baseline. */
#ifndef BENCH_FLOAT_LOOP_H
#define BENCH_FLOAT_LOOP_H

#include <tia/scene.h>

/* Draws the whole picture ray by ray, as is usual on a machine with an FPU. */
void plain_render(const struct tia_scene *scene, int width, int height, tia_rgb565 *pixels);

#endif
