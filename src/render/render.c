/* render.c - draws a tile, by the view's renderer or by vector units. */
#include "renderer.h"

/* Returns the status after work on a tile, TIA_STOPPED or TIA_OK. Marks the hits as traced if `traces` is set, unless
 * stopped. */
static int ended(const struct tia_view *view, struct tia_hits *hits, bool traces)
{
    if (view_stops(view))
        return TIA_STOPPED;
    if (traces)
        hits_mark_traced(hits);
    return TIA_OK;
}

int tia_drawing_trace(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile)
{
    if (!tia_hits_have(hits, view, tile))
        return TIA_ERR_ARGUMENT;
    if (view_keeps_hits(view))
        view->renderer->trace(view, hits, tile);
    return ended(view, hits, view_keeps_hits(view));
}

static const struct tia_options plain = {0};

/* True if options->colours is NULL, or if the view can write these colours. It cannot with vector units that trace,
 * with a renderer of samples, or with dithering. */
static bool has_colours(const struct tia_view *view, const struct tia_options *options)
{
    return !options->colours || !(!view_keeps_hits(view) || view->renderer->sample || options->dither);
}

int tia_drawing_light(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                      const struct tia_surface *surface, const struct tia_options *options)
{
    if (!tia_hits_have(hits, view, tile) || !surface_is_usable(surface) ||
        (view_keeps_hits(view) && !hits_are_traced(hits)))
        return TIA_ERR_ARGUMENT;
    options = options ? options : &plain;
    if (!has_colours(view, options))
        return TIA_ERR_UNSUPPORTED;
    if (view_keeps_hits(view))
        view->renderer->light(view, hits, tile, surface, options);
    else
        view->simd->enter->light(view, tile, surface, options);
    return view_stops(view) ? TIA_STOPPED : TIA_OK;
}

int tia_drawing_render(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile,
                       const struct tia_surface *surface, const struct tia_options *options)
{
    if (!surface_is_usable(surface))
        return TIA_ERR_ARGUMENT;
    if (tia_hits_have(hits, view, tile) && !view->simd && view->renderer->render) {
        options = options ? options : &plain;
        if (!has_colours(view, options))
            return TIA_ERR_UNSUPPORTED;
        view->renderer->render(view, hits, tile, surface, options);
        return ended(view, hits, true);
    }
    int status = tia_drawing_trace(view, hits, tile);

    return status ? status : tia_drawing_light(view, hits, tile, surface, options);
}
