/* choose.c - the fastest renderer that can draw a scene. */
#include "renderer.h"

const struct renderer *renderer_for(const struct tia_scene *scene)
{
    if (raster_renderer.draws(scene))
        return &raster_renderer;
    return span_renderer.draws(scene) ? &span_renderer : &whitted_renderer;
}

bool tia_draws_by_pixel(const struct tia_scene *scene)
{
    return renderer_for(scene)->by_pixel;
}
