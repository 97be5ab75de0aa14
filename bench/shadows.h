/* shadows.h - shadow volumes of the scene in mesh_scene.h, alone and beside OpenGL's rasterisers. */
#ifndef BENCH_SHADOWS_H
#define BENCH_SHADOWS_H

void bench_shadows(void);

#endif
