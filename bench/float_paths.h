/* float_paths.h - a small path tracer in scalar float, to compare speed and means. Its estimator is that of
 * tia/integrator.h, with pseudorandom numbers instead of Sobol points.
 *
 * It supports spheres and meshes; point and rectangle lights; Lambert's law, Phong's lobe and mirrors; perspective
 * cameras. */
#ifndef BENCH_FLOAT_PATHS_H
#define BENCH_FLOAT_PATHS_H

#include <tia/scene.h>

struct float_paths;

/* Opens a scene. Returns NULL if the scene has anything else, or if memory is short. */
struct float_paths *float_paths_open(const struct tia_scene *scene, unsigned width, unsigned height);
void float_paths_close(struct float_paths *paths);

/* Stores the mean radiance of `spp` samples of each pixel in `rgb`, three numbers for each pixel. Returns the number of
 * rays traced. */
uint64_t float_paths_draw(const struct float_paths *paths, unsigned spp, float *rgb);

#endif
