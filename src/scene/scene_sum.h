/* scene_sum.h - a scene's memory, step by step: what a step's pointers refer to is in the next step. */
#ifndef TIA_SCENE_SCENE_SUM_H
#define TIA_SCENE_SCENE_SUM_H

#include <tia/scene.h>

/* Steps of a scene: the structure itself, its arrays, their arrays, and the hierarchies of meshes. */
enum { SCENE_SELF, SCENE_ARRAYS, SCENE_PARTS, SCENE_TREES, SCENE_STEPS };

/* Returns the checksum of a step, see math/checksum.h. All earlier steps must be valid. */
uint64_t tia_scene_sum(const struct tia_scene *scene, int step);

#endif
