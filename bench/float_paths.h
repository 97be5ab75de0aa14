/* float_paths.h - a small path tracer in scalar float, to compare speed and means. The estimator is that of
 * tia/integrator.h, its random numbers are pseudorandom, not Sobol points.
 *
 * It supports spheres, meshes and point and rectangle lights; Lambert's law, Phong's lobe and mirrors; perspective. */
#ifndef BENCH_FLOAT_PATHS_H
#define BENCH_FLOAT_PATHS_H

#include <tia/scene.h>

struct float_paths;

/* Opens a scene; NULL when it has anything else, or memory is short. */
struct float_paths *float_paths_open(const struct tia_scene *scene, unsigned width, unsigned height);
void float_paths_close(struct float_paths *paths);

/* Gives the mean radiance of `spp` samples of each pixel, as three numbers. Returns the number of rays traced. */
uint64_t float_paths_draw(const struct float_paths *paths, unsigned spp, float *rgb);

#endif
