/* float_paths.h - a small path tracer in scalar float, to compare speed and means. Its estimator is that of
 * tia/integrator.h, with pseudorandom numbers instead of Sobol points.
 *
 * It supports spheres and meshes; point and rectangle lights; Lambert's law, Phong's lobe and mirrors; perspective
 * cameras. */
#ifndef BENCH_FLOAT_PATHS_H
#define BENCH_FLOAT_PATHS_H

#include <tia/scene.h>

#include "float_world.h"

struct float_paths;

/* How rays meet items: by a function like float_world_meet, with its first argument. */
struct float_meeting {
    void (*meet)(const void *world, const struct float_ray *ray, bool any, struct float_hit *hit);
    const void *world;
};

/* Opens a scene. Returns NULL if the scene has anything else, or if memory is short. */
struct float_paths *float_paths_open(const struct tia_scene *scene, unsigned width, unsigned height);
void float_paths_close(struct float_paths *paths);

/* Returns the items of the scene. */
const struct float_world *float_paths_world(const struct float_paths *paths);

/* Stores the mean radiance of `spp` samples of each pixel in `rgb`, three numbers for each pixel. Rays meet items by
 * `meeting`; NULL: by the hierarchy of float_world.h. Returns the number of rays traced. */
uint64_t float_paths_draw(const struct float_paths *paths, const struct float_meeting *meeting, unsigned spp,
                          float *rgb);

#endif
