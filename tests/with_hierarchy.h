/* with_hierarchy.h - gives a scene a hierarchy, for tests of SIMD kernels, which draw no rays without one. */
#ifndef TESTS_WITH_HIERARCHY_H
#define TESTS_WITH_HIERARCHY_H

#include <stdlib.h>
#include <tia/bvh.h>

#include "check.h"

/* Calls then() with the scene and the number while the scene has a hierarchy. */
static inline void with_hierarchy(struct tia_scene *scene, void (*then)(const struct tia_scene *, unsigned),
                                  unsigned number)
{
    size_t size = tia_bvh_size(scene);
    void *memory = malloc(size);

    CHECK_EQ(tia_bvh_build(&scene->bvh, memory, size, NULL, scene, NULL), TIA_OK);
    then(scene, number);
    scene->bvh = NULL;
    free(memory);
}

#endif
