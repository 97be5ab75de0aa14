/* raster_view.c - the buffers of each sample of each pixel, and the hit of a pixel's ray on a face. */
#include "raster_view.h"

#include "raster/distance.h"
#include "raster/target.h"

#define PIXEL_BYTES (2 * sizeof(uint64_t) + 3 * sizeof(uint32_t))

uint64_t raster_sample_size(unsigned more_bytes, uint64_t pixels)
{
    return ALIGN((PIXEL_BYTES + more_bytes) * pixels);
}

struct raster_buffers raster_buffers(const struct raster_view *raster, const struct tia_hits *hits, unsigned sample)
{
    size_t pixels = (size_t)hits->area.width * hits->area.height;
    struct raster_buffers b;

    b.nearness = (void *)((char *)hits->buffer + (size_t)raster_sample_size(raster->more_bytes, pixels) * sample);
    b.lit = b.nearness + pixels;
    b.object = (uint32_t *)(b.lit + pixels);
    b.face = b.object + pixels;
    b.count = b.face + pixels;
    b.more = (char *)(b.count + pixels);
    return b;
}

void raster_open_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile, unsigned sample,
                      const struct raster_buffers *b, struct tia_shadow_tile *open)
{
    const struct raster_view *raster = raster_of(view);
    const struct tia_shadow_view *shadow = &raster->shadow[sample];
    size_t first = hits_index(hits, tile.x, tile.y);
    struct tia_raster_target all = {.grid = &shadow->flat.grid,
                                    .area = hits->area,
                                    .face = b->face,
                                    .nearness = b->nearness,
                                    .count = b->count,
                                    .planes = shadow->flat.planes,
                                    .face_count = shadow->flat.face_count,
                                    .pitch = hits->area.width,
                                    .planes_known = true,
                                    .runs = view->raster_runs};

    open->lit = b->lit + first;
    open->more = b->more + raster->more_bytes * first;
    (void)tia_raster_part(&open->target, &all, tile);
}

void raster_find_face(const struct ray_view *rays, const struct tia_flat_scene *flat, uint32_t face, int x, int y,
                      const struct ray *ray, struct hit *hit)
{
    *hit = (struct hit){NUM_LENGTH_MAX, TIA_NO_OBJECT, 0, TIA_NO_OBJECT};
    if (face == TIA_NO_FACE)
        return;
    num_length depth = num_length_of_q45(tia_plane_distance(&flat->planes[face], &flat->grid, x, y));
    num_length t = num_div(depth, num_dir_dot(num_dir_negated(rays->camera.n), ray->direction));
    if (t >= NUM_LENGTH_FAR)
        return;
    hit->t = t;
    hit->object = tia_flat_object_of(flat, face)->object;
    hit->element = tia_flat_element_of(flat, face);
}
