/* core.c - the renderer as one function and as a table. */
#include "num.h"

int tia_render(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile,
               const struct tia_surface *surface, const struct tia_options *options)
{
    int status = tia_trace(view, hits, tile);

    return status ? status : tia_light_tile(view, hits, tile, surface, options);
}

const struct tia_core NUM_CORE = {
    .name = NUM_NAME,
    .view_size = tia_view_size,
    .view_init = tia_view_init,
    .set_lights = tia_view_set_lights,
    .hits_size = tia_hits_size,
    .hits_init = tia_hits_init,
    .hits_object = tia_hits_object,
    .trace = tia_trace,
    .light = tia_light_tile,
};
