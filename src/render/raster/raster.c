/* raster.c - what each pixel sees of flat faces is rasterised, of curved objects found by rays. */
#include "view.h"

#include "curved.h"
#include "render/whitted/path.h"

/* ---- preparing ---- */

static bool draws(const struct tia_scene *scene)
{
    return scene->shadows != TIA_SHADOWS_TRACED;
}

static uint64_t view_size(const struct tia_scene *scene)
{
    return ALIGN(offsetof(struct raster_view, shadow) + tia_flat_samples(scene) * sizeof(struct tia_shadow_view));
}

static uint64_t own_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    return view_size(scene) + ALIGN((uint64_t)light_capacity) +
           ALIGN((uint64_t)tia_curved_count(scene) * sizeof(struct tia_curved_place)) +
           ALIGN(tia_shadow_technique(scene->shadows)->own_size(scene));
}

static size_t prepared_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    uint64_t rays = ray_prepared_size(scene, light_capacity), flat = tia_flat_size(scene);
    uint64_t size = ALIGN(rays) + own_size(scene, light_capacity) + flat;

    return rays < SIZE_MAX / 2 && flat < SIZE_MAX / 2 && size < SIZE_MAX / 2 ? (size_t)size : SIZE_MAX;
}

/* What the technique wants of each sample of a pixel: shares of lights, or bytes to work with. */
static unsigned shares_of(const struct tia_scene *scene)
{
    const struct tia_shadow_technique *technique = tia_shadow_technique(scene->shadows);

    return technique->shares ? technique->shares(scene) : 0;
}

static bool is_whole(const struct tia_scene *scene)
{
    const struct tia_shadow_technique *technique = tia_shadow_technique(scene->shadows);

    return technique->is_whole && technique->is_whole(scene);
}

static unsigned more_bytes(const struct tia_scene *scene)
{
    const struct tia_shadow_technique *technique = tia_shadow_technique(scene->shadows);

    return technique->shares ? shares_of(scene) * (unsigned)sizeof(tia_share) : technique->scratch;
}

static int prepare(struct tia_view *view)
{
    const struct tia_scene *scene = view->scene;
    struct raster_view *raster = raster_of(view);
    char *own = (char *)raster;
    unsigned width = (unsigned)view->width, height = (unsigned)view->height;
    struct asker asker = view_asker(view);
    int status = ray_prepare(view);

    raster->sample_count = tia_flat_samples(scene);
    raster->place_count = tia_curved_count(scene);
    raster->shares = shares_of(scene);
    raster->more_bytes = more_bytes(scene);
    raster->whole = is_whole(scene);
    raster->first_bit = (uint8_t *)own + view_size(scene);
    raster->places = (void *)(raster->first_bit + ALIGN((uint64_t)view->light_capacity));
    raster->shadow->own = (char *)raster->places + ALIGN((size_t)raster->place_count * sizeof *raster->places);
    raster->shadow->sample_count = 0;
    if (!status)
        status = tia_flat_init(&raster->shadow->flat, own + own_size(scene, view->light_capacity), tia_flat_size(scene),
                               scene, width, height, &asker);
    if (status)
        return status;
    tia_curved_find(raster->places, scene, &raster->shadow->flat.eye, width, height);
    raster->shadow->scene = scene;
    return tia_shadow_technique(scene->shadows)->prepare(raster->shadow, &asker);
}

static void add_samples(const struct raster_view *raster, struct tia_shadow_view *shadow, const struct tia_light *light)
{
    unsigned count = tia_shadow_samples(shadow->scene, light);

    for (unsigned i = 0; i < count; i++) {
        tia_flat_light *at = &shadow->samples[shadow->sample_count];
        shadow->lights[shadow->sample_count++] = light;
        if (raster->whole)
            tia_flat_light_centre(&shadow->flat, light, at);
        else
            tia_flat_light_at(&shadow->flat, light, i, at);
    }
}

static bool has_room(const struct tia_view *view, const struct tia_light *lights, uint32_t count)
{
    const struct tia_shadow_technique *technique = tia_shadow_technique(view->scene->shadows);

    return !technique->has_room || technique->has_room(view->scene, lights, count);
}

static int set_lights(struct tia_view *view)
{
    struct raster_view *raster = raster_of(view);
    struct tia_shadow_view *shadow = raster->shadow;
    struct asker asker = view_asker(view);
    int status = ray_set_lights(view);

    shadow->sample_count = 0;
    if (status)
        return status;
    for (uint32_t n = 0; n < view->light_count; n++) {
        raster->first_bit[n] = (uint8_t)shadow->sample_count;
        add_samples(raster, shadow, &view->lights[n]);
    }
    status = tia_shadow_technique(view->scene->shadows)->set_lights(shadow, &asker);
    for (unsigned i = 1; i < raster->sample_count; i++) {
        shadow[i] = shadow[0];
        tia_flat_sample(&shadow[i].flat, &shadow[0].flat, view->scene, i);
    }
    return status;
}

static uint64_t buffer_size(const struct tia_scene *scene, uint32_t pixels)
{
    return tia_flat_samples(scene) * raster_sample_size(more_bytes(scene), pixels);
}

/* ---- what is seen ---- */

/* A curved object takes the place of the face that a pixel sees, if it is nearer. */
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
    struct asker asker = view_asker(view);
    uint32_t last = TIA_NO_FACE, seen = TIA_NO_OBJECT;
    struct tia_shadow_tile open;

    raster_open_tile(view, hits, tile, sample, &b, &open);
    tia_clear_depth(&open.target);
    tia_clear_count(&open.target, 0);
    (void)tia_shadow_faces(&open.target, flat, &asker);
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

static void trace_tile(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile)
{
    struct raster_buffers b = raster_buffers(raster_of(view), hits, 0);

    for (unsigned i = 0; i < raster_of(view)->sample_count; i++)
        trace_sample(view, hits, tile, i);
    for (unsigned y = tile.y; y < (unsigned)tile_bottom(tile); y++)
        for (unsigned x = tile.x; x < (unsigned)tile_right(tile); x++)
            hits->object[hits_index(hits, x, y)] = b.object[hits_index(hits, x, y)];
}

const struct renderer raster_renderer = {
    .draws = draws,
    .prepared_size = prepared_size,
    .prepare = prepare,
    .set_lights = set_lights,
    .buffer_size = buffer_size,
    .trace = trace_tile,
    .light = raster_light_tile,
    .part = LEVEL_PARTS,
    .has_room = has_room,
};
