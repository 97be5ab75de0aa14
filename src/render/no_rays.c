/* no_rays.c - stands in for general rays in programs that have no room for them. */
#include "renderer.h"

static size_t prepared_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    (void)scene;
    (void)light_capacity;
    return 0;
}

static int prepare(struct tia_view *view)
{
    (void)view;
    return TIA_ERR_UNSUPPORTED;
}

/* Views cannot be prepared: the other functions are never called. */
const struct renderer whitted_renderer = {
    .prepared_size = prepared_size,
    .prepare = prepare,
    .part = SIMD_PARTS,
};

const struct renderer *renderer_named(const struct tia_scene *scene)
{
    (void)scene;
    return NULL;
}
