#include "moment.h"

#include <stdlib.h>

#include <tia/bvh.h>
#include <tia/motion.h>

static void *get(void **memory, size_t size)
{
    *memory = size < SIZE_MAX ? malloc(size ? size : 1) : NULL;
    return *memory;
}

int moment_begin(struct moment *moment, struct tia_scene *scene, tia_q16 time)
{
    const struct tia_scene whole = *scene;
    size_t size = tia_scene_at_size(&whole);

    if (!tia_scene_moves(&whole))
        return TIA_OK;
    if (!get(&moment->arrays, size))
        return TIA_ERR_MEMORY;
    int status = tia_scene_at(scene, moment->arrays, size, &whole, time, NULL);
    if (status || !whole.bvh)
        return status;
    size = tia_bvh_move_size(scene);
    if (!get(&moment->boxes, size))
        return TIA_ERR_MEMORY;
    return tia_bvh_move(&scene->bvh, moment->boxes, size, scene, &whole, NULL);
}

void moment_end(struct moment *moment)
{
    free(moment->arrays);
    free(moment->boxes);
    *moment = (struct moment){NULL, NULL};
}
