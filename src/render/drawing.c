/* drawing.c - the public functions of a view, which call through its core. */
#include "renderer.h"

const struct tia_drawing tia_drawing = {
    .set_lights = tia_drawing_set_lights,
    .hits_init = tia_drawing_hits_init,
    .hits_object = tia_drawing_hits_object,
    .trace = tia_drawing_trace,
    .light = tia_drawing_light,
    .render = tia_drawing_render,
};

/* Returns the functions of the view's core; NULL stands for the library's functions. A program's own struct tia_view
 * begins with a pointer to its core, as the library's does. */
static const struct tia_drawing *drawing_of(const struct tia_view *view)
{
    return (*(const struct tia_core *const *)(const void *)view)->drawing;
}

/* Returns the view of the hits, to which their first member points, also in a program's own struct tia_hits. */
static const struct tia_view *view_of(const struct tia_hits *hits)
{
    return *(const struct tia_view *const *)(const void *)hits;
}

int tia_view_set_lights(struct tia_view *view, const struct tia_light *lights, uint32_t count)
{
    if (!view)
        return TIA_ERR_ARGUMENT;
    const struct tia_drawing *own = drawing_of(view);

    return own ? own->set_lights(view, lights, count) : tia_drawing_set_lights(view, lights, count);
}

int tia_hits_init(struct tia_hits **hits, void *memory, size_t size, const struct tia_view *view, struct tia_tile area)
{
    if (!view)
        return TIA_ERR_ARGUMENT;
    const struct tia_drawing *own = drawing_of(view);

    return own ? own->hits_init(hits, memory, size, view, area) : tia_drawing_hits_init(hits, memory, size, view, area);
}

uint32_t tia_hits_object(const struct tia_hits *hits, unsigned x, unsigned y)
{
    if (!hits || !view_of(hits))
        return TIA_NO_OBJECT;
    const struct tia_drawing *own = drawing_of(view_of(hits));

    return own ? own->hits_object(hits, x, y) : tia_drawing_hits_object(hits, x, y);
}

int tia_view_trace(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile)
{
    if (!view)
        return TIA_ERR_ARGUMENT;
    const struct tia_drawing *own = drawing_of(view);

    return own ? own->trace(view, hits, tile) : tia_drawing_trace(view, hits, tile);
}

int tia_view_light(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                   const struct tia_surface *surface, const struct tia_options *options)
{
    if (!view)
        return TIA_ERR_ARGUMENT;
    const struct tia_drawing *own = drawing_of(view);

    return own ? own->light(view, hits, tile, surface, options) : tia_drawing_light(view, hits, tile, surface, options);
}

int tia_view_draw(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile,
                  const struct tia_surface *surface, const struct tia_options *options)
{
    if (!view)
        return TIA_ERR_ARGUMENT;
    const struct tia_drawing *own = drawing_of(view);

    return own ? own->render(view, hits, tile, surface, options)
               : tia_drawing_render(view, hits, tile, surface, options);
}
