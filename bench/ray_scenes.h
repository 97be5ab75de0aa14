/* ray_scenes.h - scenes of any size for the ray renderer, with their hierarchies. */
#ifndef BENCH_RAY_SCENES_H
#define BENCH_RAY_SCENES_H

#include <tia/tia.h>

#include "mesh_scene.h"

struct ray_scene {
    struct tia_scene scene;
    double built[2];     /* milliseconds to build the hierarchy by one thread and by two */
    size_t memory_bytes; /* memory of the hierarchy */
    void *memory[5];
};

/* Makes the sphere flake of the Standard Procedural Databases: (9^(depth + 1) - 1)/8 spheres on the ground and under
 * the lights of balls_1.nff. Depths 1 to 4 give balls_1.nff to balls_4.nff. */
void ray_scene_balls(struct ray_scene *s, int depth);

/* Makes the solids of bench_mesh as one mesh of 84 4^depth + 12 faces. */
void ray_scene_mesh(struct ray_scene *s, int depth);

void ray_scene_free(struct ray_scene *s);

/* Calls malloc, and ends the program if that fails. */
void *ray_scene_memory(size_t size);

#endif
