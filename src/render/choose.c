/* choose.c - the choice of a renderer: the first of the core's list that draws the scene. */
#include "renderer.h"

const struct renderer *tia_renderer_for(const struct tia_core *core, const struct tia_scene *scene)
{
    const struct renderer *const *renderer = core->renderers->list;

    while (*renderer && (*renderer)->draws && !(*renderer)->draws(scene))
        renderer++;
    return *renderer;
}

bool tia_core_draws_by_pixel(const struct tia_core *core, const struct tia_scene *scene)
{
    const struct renderer *renderer = core && scene ? tia_renderer_for(core, scene) : NULL;

    return renderer && renderer->by_pixel;
}
