/* raster_light.c - shading of rasterised pixels: a technique for shadows finds the lights that no flat face blocks; the
 * ray renderer computes the colours. */
#include "curved_hits.h"
#include "diffuse.h"
#include "raster_view.h"
#include "render/core/dither.h"
#include "render/whitted/whitted.h"

#define SHARES_SIDE 64 /* side of a part whose pixels have several shares of lights */

struct rasterised {
    struct first_hits first;
    const struct raster_view *raster;
    const struct ray_view *rays;
    const struct tia_hits *hits;
    struct diffuse diffuse;
};

static const tia_share *shares_at(const struct rasterised *r, const struct raster_buffers *b, size_t at)
{
    return r->raster->shares ? (const tia_share *)(const void *)b->more + r->raster->shares * at : NULL;
}

/* Moves the hit to the true surface. Faces of a tessellated surface only decide visibility and shadow; the colour is
 * that of the curved surface, behind or in front of the face. If the ray misses that surface, which is possible if the
 * shape is open, the hit stays on the face. */
static void show_surface(const struct rasterised *r, uint32_t face, const struct ray *ray, struct hit *hit)
{
    struct hit met;

    if (hit->object == TIA_NO_OBJECT || !tia_flat_object_of(&r->raster->shadow->flat, face)->divided)
        return;
    ray_intersect_object(r->rays, ray, hit->object, &met);
    if (met.object != TIA_NO_OBJECT)
        *hit = met;
}

static bool find_hit(const struct first_hits *first, int x, int y, int sample, const struct ray *ray, struct hit *hit,
                     struct arrivals *lit)
{
    const struct rasterised *r = (const struct rasterised *)(const void *)first;
    const struct raster_buffers b = raster_buffers(r->raster, r->hits, (unsigned)sample);
    size_t at = hits_index(r->hits, (unsigned)x, (unsigned)y);

    uint32_t object = raster_object(b.object[at]);

    if (object != TIA_NO_OBJECT && b.face[at] == TIA_NO_FACE) {
        ray_intersect_object(r->rays, ray, object, hit);
        return false;
    }
    lit->bits = b.lit[at];
    lit->shares = shares_at(r, &b, at);
    raster_find_face(r->rays, &r->raster->shadow[sample].flat, b.face[at], x, y, ray, hit);
    show_surface(r, b.face[at], ray, hit);
    return true;
}

/* True if light that passes all faces also passes the curved objects. */
static bool passes(const struct first_hits *first, const struct ray *shadow, num_length distance, uint32_t *blocker)
{
    const struct rasterised *r = (const struct rasterised *)(const void *)first;

    return curved_passes(r->rays, shadow, distance, blocker);
}

/* True if the vertices have changed since a pixel of the tile was traced. */
static bool is_outdated(const struct raster_view *raster, const struct tia_hits *hits, struct tia_tile tile)
{
    const struct raster_buffers b = raster_buffers(raster, hits, 0);

    for (unsigned y = tile.y; y < (unsigned)tile_bottom(tile); y++)
        for (unsigned x = tile.x; x < (unsigned)tile_right(tile); x++)
            if (b.object[hits_index(hits, x, y)] >> RASTER_OBJECT_BITS != raster->range)
                return true;
    return false;
}

static void light_sample(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                         unsigned sample, struct cancel *cancel)
{
    const struct tia_shadow_technique *technique = tia_shadow_technique(view->scene->shadows);
    const struct raster_view *raster = raster_of(view);
    const struct tia_shadow_view *shadow = &raster->shadow[sample];
    struct raster_buffers b = raster_buffers(raster, hits, sample);
    struct tia_shadow_tile open;

    raster_open_tile(view, hits, tile, sample, &b, &open);
    for (unsigned y = 0; y < tile.height; y++)
        for (unsigned x = 0; x < tile.width; x++)
            open.lit[(size_t)y * (size_t)open.target.pitch + x] = 0;
    for (unsigned i = 0; i < shadow->sample_count && !cancelled(cancel, CANCEL_INTERVAL); i++)
        technique->light(shadow, &open, i, cancel);
}

/* Several shares of a pixel are stored one after the other, so all lights of a part of the tile come before the next
 * part, as long as it is in a cache. */
static void light_parts(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile, unsigned sample,
                        struct cancel *cancel)
{
    unsigned side = raster_of(view)->shares > 1 ? SHARES_SIDE : TIA_SIZE_MAX;

    for (unsigned y = tile.y; y < (unsigned)tile_bottom(tile); y += side)
        for (unsigned x = tile.x; x < (unsigned)tile_right(tile); x += side) {
            unsigned width = (unsigned)tile_right(tile) - x, height = (unsigned)tile_bottom(tile) - y;
            struct tia_tile part = {(uint16_t)x, (uint16_t)y, (uint16_t)(width < side ? width : side),
                                    (uint16_t)(height < side ? height : side)};
            light_sample(view, hits, part, sample, cancel);
        }
}

/* Lights pixels x0..x1-1 of row y, ray by ray. */
static void light_run(const struct rasterised *r, const struct tia_view *view, struct tia_tile tile, int y, int x0,
                      int x1, const struct tia_surface *surface, const struct tia_options *options)
{
    struct tia_tile run = {(uint16_t)x0, (uint16_t)y, (uint16_t)(x1 - x0), 1};
    char *first = (char *)surface->pixels + (y - (int)tile.y) * surface->pitch + (x0 - (int)tile.x) * surface->step;
    struct tia_surface part = *surface;

    part.pixels = (tia_rgb565 *)(void *)first;
    if (x0 < x1)
        whitted_light_tile(view, r->hits, run, &part, options, &r->first);
}

/* Lights a row: by diffuse.h where possible, and the runs of other pixels by rays. */
static void light_row(struct rasterised *r, const struct tia_view *view, struct tia_tile tile, int y,
                      const struct tia_surface *surface, const struct tia_options *options)
{
    const struct raster_buffers b = raster_buffers(r->raster, r->hits, 0);
    char *row = (char *)surface->pixels + (y - (int)tile.y) * surface->pitch;
    size_t at = hits_index(r->hits, tile.x, (unsigned)y);
    int left = (int)tile.x, open = left;
    num_u threshold[8];

    dither_thresholds(options->dither, y, threshold);
    for (int x = left; x < tile_right(tile); x++, at++) {
        struct diffuse_pixel p = {x, y, b.face[at], b.nearness[at], b.lit[at], shares_at(r, &b, at)};
        tia_rgb565 *out = (tia_rgb565 *)(void *)(row + (x - left) * surface->step), pixel;
        if (!diffuse_pixel(&r->diffuse, &p, threshold[x & 7], &pixel))
            continue;
        *out = surface_order(surface, pixel);
        light_run(r, view, tile, y, open, x, surface, options);
        open = x + 1;
    }
    light_run(r, view, tile, y, open, tile_right(tile), surface, options);
}

static struct rasterised rasterised_of(const struct tia_view *view, const struct tia_hits *hits)
{
    const struct raster_view *raster = raster_of(view);

    return (struct rasterised){
        .first = {find_hit, raster->first_bit, raster->whole, raster->place_count ? passes : NULL},
        .raster = raster,
        .rays = view->prepared,
        .hits = hits};
}

/* Finds the lights that reach each pixel. */
static void find_lights(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile)
{
    const struct raster_view *raster = raster_of(view);
    struct cancel cancel = view_cancel(view);
    struct tia_hits again = {.view = view, .area = hits->area, .object = hits->object, .buffer = hits->buffer};

    if (is_outdated(raster, hits, tile))
        raster_trace_tile(view, &again, tile);
    for (unsigned i = 0; i < raster->sample_count; i++)
        light_parts(view, hits, tile, i, &cancel);
}

void raster_shade_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                       const struct tia_surface *surface, const struct tia_options *options)
{
    struct rasterised r = rasterised_of(view, hits);

    whitted_light_tile(view, hits, tile, surface, options, &r.first);
}

void raster_light_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                       const struct tia_surface *surface, const struct tia_options *options)
{
    const struct raster_view *raster = raster_of(view);
    struct rasterised r = rasterised_of(view, hits);
    const struct tia_debug debug = options_debug(options);
    bool rays = raster->place_count || debug.path_hash || debug.lit || options->colours;

    find_lights(view, hits, tile);
    if (!rays && view->simd && view->simd->enter->shade(view, hits, tile, surface, options))
        return;
    if (rays || !diffuse_init(&r.diffuse, view, raster->shadow, raster->first_bit)) {
        whitted_light_tile(view, hits, tile, surface, options, &r.first);
        return;
    }
    for (int y = (int)tile.y; y < tile_bottom(tile) && !view_stops(view); y++)
        light_row(&r, view, tile, y, surface, options);
}
