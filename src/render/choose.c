/* choose.c - the renderers, the fastest first. */
#include "renderer.h"

const struct renderer *renderer_for(const struct tia_scene *scene)
{
    return span_renderer.draws(scene) ? &span_renderer : &whitted_renderer;
}
