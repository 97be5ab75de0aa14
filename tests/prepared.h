/* prepared.h - prepared shapes without a scene. */
#ifndef TESTS_PREPARED_H
#define TESTS_PREPARED_H

#include "render/geometry/shape.h"

/* Prepares a shape: PREPARE(&shape, TIA_BOX, box, {min, max}). */
#define PREPARE(shape, KIND, field, ...)                                                                               \
    shape_prepare(shape, &(const struct tia_scene){.shape_count = 0},                                                  \
                  &(const struct tia_shape){.kind = KIND, .field = __VA_ARGS__})

static inline void prepare_mesh_alone(struct shape *shape, const struct tia_mesh *mesh, const struct tia_bvh_tree *tree)
{
    const struct tia_bvh bvh = {.meshes = tree};
    const struct tia_scene scene = {.meshes = mesh, .bvh = tree ? &bvh : NULL};

    shape_prepare(shape, &scene, &(const struct tia_shape){.kind = TIA_MESH});
}

static inline void prepare_grid_alone(struct shape *shape, const struct tia_grid *grid)
{
    const struct tia_scene scene = {.grids = grid};

    shape_prepare(shape, &scene, &(const struct tia_shape){.kind = TIA_GRID});
}

#endif
