/* render.c - a tile, by the view's renderer. */
#include "renderer.h"

static bool is_inside(struct tia_tile tile, struct tia_tile area)
{
    return tile.width && tile.height && tile.x >= area.x && tile.y >= area.y && tile.width <= area.width &&
           tile.height <= area.height && tile.x - area.x <= area.width - tile.width &&
           tile.y - area.y <= area.height - tile.height;
}

static bool has_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile)
{
    struct tia_tile image = {0, 0, (uint16_t)view->width, (uint16_t)view->height};

    return is_inside(tile, image) && is_inside(tile, hits->area);
}

int tia_trace(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile)
{
    if (!has_tile(view, hits, tile))
        return TIA_ERR_ARGUMENT;
    if (!view->level) /* a level finds what is seen while it lights */
        view->renderer->trace(view, hits, tile);
    return view_stops(view) ? TIA_STOPPED : TIA_OK;
}

static const struct tia_options plain = {0};

int tia_light_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                   const struct tia_surface *surface, const struct tia_options *options)
{
    if (!has_tile(view, hits, tile) || !surface->pixels)
        return TIA_ERR_ARGUMENT;
    options = options ? options : &plain;
    if (view->level)
        level_renderer_for(view->level, view->renderer)->light(view, tile, surface, options);
    else
        view->renderer->light(view, hits, tile, surface, options);
    return view_stops(view) ? TIA_STOPPED : TIA_OK;
}

int tia_render(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile,
               const struct tia_surface *surface, const struct tia_options *options)
{
    if (!view->level && view->renderer->render) {
        if (!has_tile(view, hits, tile) || !surface->pixels)
            return TIA_ERR_ARGUMENT;
        view->renderer->render(view, hits, tile, surface, options ? options : &plain);
        return view_stops(view) ? TIA_STOPPED : TIA_OK;
    }
    int status = tia_trace(view, hits, tile);

    return status ? status : tia_light_tile(view, hits, tile, surface, options);
}
