/* shadows.h - measures shadow volumes of the scene in shadow_scene.h, alone and beside OpenGL's rasterisers. */
#ifndef BENCH_SHADOWS_H
#define BENCH_SHADOWS_H

void bench_shadows(void);

#endif
