/* no_rays.c - stands in for general rays in programs that have no room for them. */
#include "render/whitted/rays.h"

size_t ray_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    (void)scene;
    (void)light_capacity;
    return 0;
}

int ray_prepare(struct tia_view *view, void *memory)
{
    (void)view;
    (void)memory;
    return TIA_ERR_UNSUPPORTED;
}

void ray_set_lights(struct tia_view *view)
{
    (void)view;
}

void ray_trace(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile)
{
    (void)view;
    (void)hits;
    (void)tile;
}

void ray_light(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
               const struct tia_surface *surface, const struct tia_options *options)
{
    (void)view;
    (void)hits;
    (void)tile;
    (void)surface;
    (void)options;
}
