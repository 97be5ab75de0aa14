/* plain.h - the textbook's loop in scalar float, to measure the library against. */
#ifndef BENCH_PLAIN_H
#define BENCH_PLAIN_H

#include <tia/scene.h>

/* Draws the whole picture, ray by ray, as one would write it on a machine with an FPU. */
void plain_render(const struct tia_scene *scene, int width, int height, tia_rgb565 *pixels);

#endif
