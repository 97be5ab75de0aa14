/* named.c - the renderers that scenes name. */
#include "renderer.h"

const struct renderer *renderer_named(const struct tia_scene *scene)
{
    if (scene->integration.integrator == TIA_OCCLUSION)
        return &ao_renderer;
    if (scene->integration.integrator == TIA_PATHS)
        return &path_renderer;
    return raster_renderer.draws(scene) ? &raster_renderer : NULL;
}
