/* raster_trace.c - finds the visible surface of each pixel: flat faces by the rasteriser, curved objects by rays. */
#include "raster_view.h"

#include "curved_hits.h"
#include "render/whitted/ray_tree.h"

/* Replaces the face at a pixel by the curved object that the pixel's ray meets, if the object is nearer. */
static void look_for_curved(const struct ray_view *rays, const struct tia_flat_scene *flat,
                            const struct raster_buffers *b, size_t at, int x, int y, unsigned sample)
{
    struct ray ray;
    struct hit hit;

    const struct light_pixel pixel = ray_pixel_at(x, y);

    ray_camera_ray(&rays->camera, &pixel, (int)sample, &ray);
    raster_find_face(rays, flat, b->face[at], x, y, &ray, &hit);
    curved_intersect(rays, &ray, &hit);
    if (hit.object == TIA_NO_OBJECT || tia_flat_takes(rays->scene, hit.object))
        return;
    b->object[at] = hit.object;
    b->face[at] = TIA_NO_FACE;
    b->nearness[at] = 0;
}

static void trace_sample(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                         unsigned sample)
{
    const struct raster_view *raster = raster_of(view);
    const struct tia_flat_scene *flat = &raster->shadow[sample].flat;
    struct raster_buffers b = raster_buffers(raster, hits, sample);
    struct path path = {.view = view->prepared};
    struct cancel cancel = view_cancel(view);
    uint32_t last = TIA_NO_FACE, seen = TIA_NO_OBJECT;
    struct tia_shadow_tile open;

    raster_open_tile(view, hits, tile, sample, &b, &open);
    tia_raster_clear_depth(&open.target);
    tia_raster_clear_count(&open.target, 0);
    (void)tia_shadow_faces(&open.target, flat, &cancel);
    curved_mark(raster->places, raster->place_count, hits, tile, b.count);
    for (int y = (int)tile.y; y < tile_bottom(tile); y++)
        for (int x = (int)tile.x; x < tile_right(tile); x++) {
            size_t at = hits_index(hits, (unsigned)x, (unsigned)y);
            if (b.face[at] != last) {
                last = b.face[at];
                seen = last == TIA_NO_FACE ? TIA_NO_OBJECT : tia_flat_object_of(flat, last)->object;
            }
            b.object[at] = seen;
            if (b.count[at] && !path_stops(&path))
                look_for_curved(path.view, flat, &b, at, x, y, sample);
        }
}

void raster_trace_tile(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile)
{
    const struct raster_view *raster = raster_of(view);
    struct raster_buffers b = raster_buffers(raster, hits, 0);

    for (unsigned i = 0; i < raster->sample_count; i++)
        trace_sample(view, hits, tile, i);
    uint32_t range = view_stops(view) ? RASTER_NO_RANGE : raster->range;
    for (unsigned y = tile.y; y < (unsigned)tile_bottom(tile); y++)
        for (unsigned x = tile.x; x < (unsigned)tile_right(tile); x++) {
            size_t at = hits_index(hits, x, y);
            hits->object[at] = b.object[at];
            b.object[at] = range << RASTER_OBJECT_BITS | (b.object[at] & RASTER_OBJECT);
        }
}
