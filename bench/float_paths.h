/* float_paths.h - what a small path tracer in scalar float makes of a scene: to compare speed and means with. The
 * estimator is that of tia/integrator.h, its random numbers are plain ones.
 *
 * It knows spheres, meshes and point and rectangle lights; Lambert's law, Phong's lobe and mirrors; perspective. */
#ifndef BENCH_FLOAT_PATHS_H
#define BENCH_FLOAT_PATHS_H

#include <tia/scene.h>

struct float_paths;

/* NULL when the scene has more than that, or memory is short. */
struct float_paths *float_paths_open(const struct tia_scene *scene, unsigned width, unsigned height);
void float_paths_close(struct float_paths *paths);

/* The mean radiance of `spp` samples of each pixel, three numbers a pixel. Returns how many rays were traced. */
uint64_t float_paths_draw(const struct float_paths *paths, unsigned spp, float *rgb);

#endif
