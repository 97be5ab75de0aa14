/* hybrid.c - prepares a view whose flat faces are rasterised. */
#include "raster_view.h"

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

/* Returns the number of shares of lights that the technique stores for each sample of a pixel. */
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

/* Returns the number of bytes that the technique stores for each sample of a pixel: shares of lights, or scratch
 * memory. */
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
    struct cancel cancel = view_cancel(view);
    int status = ray_prepare(view);

    raster->sample_count = tia_flat_samples(scene);
    raster->place_count = tia_curved_count(scene);
    raster->shares = shares_of(scene);
    raster->more_bytes = more_bytes(scene);
    raster->whole = is_whole(scene);
    raster->first_bit = (uint8_t *)own + view_size(scene);
    raster->places = (void *)(raster->first_bit + ALIGN((uint64_t)view->light_capacity));
    raster->shadow->own = (char *)raster->places + ALIGN((size_t)raster->place_count * sizeof *raster->places);
    raster->shadow->own_size = tia_shadow_technique(scene->shadows)->own_size(scene);
    raster->shadow->sample_count = 0;
    if (!status)
        status = tia_flat_init(&raster->shadow->flat, own + own_size(scene, view->light_capacity), tia_flat_size(scene),
                               scene, width, height, &cancel);
    if (status)
        return status;
    tia_curved_find(raster->places, scene, &raster->shadow->flat.eye, width, height);
    raster->shadow->scene = scene;
    raster->range = tia_flat_range(&raster->shadow->flat);
    return tia_shadow_technique(scene->shadows)->prepare(raster->shadow, &cancel);
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

static int refuses(const struct tia_view *view, const struct tia_light *lights, uint32_t count)
{
    const struct tia_shadow_technique *technique = tia_shadow_technique(view->scene->shadows);
    const struct tia_reach reach = tia_flat_reach(&raster_of(view)->shadow->flat);

    if (tia_reach_too_far(&reach, lights, count) < count)
        return TIA_ERR_RANGE;
    return !technique->has_room || technique->has_room(view->scene, lights, count) ? TIA_OK : TIA_ERR_MEMORY;
}

/* If the lights need another range of coordinates, places the vertices and prepares the technique again. */
static int make_vertices(struct tia_view *view, struct cancel *cancel)
{
    struct raster_view *raster = raster_of(view);
    struct tia_flat_scene *flat = &raster->shadow->flat;
    const struct tia_reach reach = tia_flat_reach(flat);
    unsigned range = tia_reach_with_lights(&reach, view->scene, view->lights, view->light_count);

    if (range == raster->range)
        return TIA_OK;
    int status = tia_flat_place(flat, view->scene, range, cancel);
    if (!status)
        status = tia_shadow_technique(view->scene->shadows)->prepare(raster->shadow, cancel);
    raster->range = status ? RASTER_NO_RANGE : range;
    return status;
}

static int set_lights(struct tia_view *view)
{
    struct raster_view *raster = raster_of(view);
    struct tia_shadow_view *shadow = raster->shadow;
    struct cancel cancel = view_cancel(view);
    int status = ray_set_lights(view);

    shadow->sample_count = 0;
    if (!status)
        status = make_vertices(view, &cancel);
    if (status)
        return status;
    shadow->runs = view->raster_runs;
    for (uint32_t n = 0; n < view->light_count; n++) {
        raster->first_bit[n] = (uint8_t)shadow->sample_count;
        add_samples(raster, shadow, &view->lights[n]);
    }
    status = tia_shadow_technique(view->scene->shadows)->set_lights(shadow, &cancel);
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

const struct renderer raster_renderer = {
    .draws = draws,
    .prepared_size = prepared_size,
    .prepare = prepare,
    .set_lights = set_lights,
    .buffer_size = buffer_size,
    .trace = raster_trace_tile,
    .light = raster_light_tile,
    .part = SIMD_SEEN,
    .refuses = refuses,
};
