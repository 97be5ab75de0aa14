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
const struct renderer whitted_renderer = {draws, prepared_size, prepare, NULL,  buffer_size,
                                          NULL,  NULL,          false,   false, NULL};

static bool draws_none(const struct tia_scene *scene)
{
    (void)scene;
    return false;
}

const struct renderer raster_renderer = {draws_none, prepared_size, prepare, NULL,  buffer_size,
                                         NULL,       NULL,          false,   false, NULL};
