/* no_rays.c - stands in for general rays in programs that have no room for them. */
#include "renderer.h"

static bool draws(const struct tia_scene *scene)
{
    (void)scene;
    return true;
}

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

static uint64_t buffer_size(const struct tia_scene *scene, uint32_t pixels)
{
    (void)scene;
    (void)pixels;
    return 0;
}

/* A view that could not be prepared is not drawn: the rest is never called. */
const struct renderer whitted_renderer = {
    .draws = draws,
    .prepared_size = prepared_size,
    .prepare = prepare,
    .buffer_size = buffer_size,
    .part = LEVEL_PARTS,
};

const struct renderer *renderer_named(const struct tia_scene *scene)
{
    (void)scene;
    return NULL;
}
