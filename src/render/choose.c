/* choose.c - chooses the renderer that a scene names, else the fastest one that can draw it. */
#include "renderer.h"

const struct renderer *renderer_for(const struct tia_scene *scene)
{
    const struct renderer *named = renderer_named(scene);

    if (named)
        return named;
    return span_renderer.draws(scene) ? &span_renderer : &whitted_renderer;
}

bool tia_draws_by_pixel(const struct tia_scene *scene)
{
    return scene && renderer_for(scene)->by_pixel;
}
