/* raster.c - scenes of flat faces: what each pixel sees is rasterised, and a technique for shadows tells which lights
 * reach it; colours come about as the ray renderer makes them. Behind the struct ray_view that the latter prepares
 * stands a struct raster_view. */
#include "math/align.h"
#include "render/whitted/whitted.h"
#include "shadow/technique.h"

struct raster_view {
    struct tia_shadow_view shadow;
    uint8_t *first_bit; /* for each light, which of the samples its first one is */
};

/* ---- preparing ---- */

static bool draws(const struct tia_scene *scene)
{
    return scene->shadows != TIA_SHADOWS_TRACED;
}

static uint64_t own_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    return ALIGN(sizeof(struct raster_view)) + ALIGN((uint64_t)light_capacity) +
           ALIGN(tia_shadow_technique(scene->shadows)->own_size(scene));
}

static size_t prepared_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    uint64_t rays = ray_prepared_size(scene, light_capacity), flat = tia_flat_size(scene);
    uint64_t size = ALIGN(rays) + own_size(scene, light_capacity) + flat;

    return rays < SIZE_MAX / 2 && flat < SIZE_MAX / 2 && size < SIZE_MAX / 2 ? (size_t)size : SIZE_MAX;
}

static struct raster_view *raster_of(const struct tia_view *view)
{
    char *own = (char *)view->prepared + ALIGN(ray_prepared_size(view->scene, view->light_capacity));

    return (struct raster_view *)(void *)own;
}

static int prepare(struct tia_view *view)
{
    struct raster_view *raster = raster_of(view);
    char *own = (char *)raster;
    struct asker asker = view_asker(view);
    int status = ray_prepare(view);

    raster->first_bit = (uint8_t *)own + ALIGN(sizeof *raster);
    raster->shadow.own = raster->first_bit + ALIGN((uint64_t)view->light_capacity);
    raster->shadow.sample_count = 0;
    if (!status)
        status = tia_flat_init(&raster->shadow.flat, own + own_size(view->scene, view->light_capacity),
                               tia_flat_size(view->scene), view->scene, (unsigned)view->width, (unsigned)view->height,
                               &asker);
    if (status)
        return status;
    raster->shadow.scene = view->scene;
    return tia_shadow_technique(view->scene->shadows)->prepare(&raster->shadow, &asker);
}

static bool is_whole(const struct tia_scene *scene)
{
    const struct tia_shadow_technique *technique = tia_shadow_technique(scene->shadows);

    return technique->is_whole && technique->is_whole(scene);
}

static void add_samples(struct tia_shadow_view *shadow, const struct tia_light *light)
{
    unsigned count = tia_shadow_samples(shadow->scene, light);

    for (unsigned i = 0; i < count; i++) {
        tia_flat_light *at = &shadow->samples[shadow->sample_count];
        shadow->lights[shadow->sample_count++] = light;
        if (is_whole(shadow->scene))
            tia_flat_light_centre(&shadow->flat, light, at);
        else
            tia_flat_light_at(&shadow->flat, light, i, at);
    }
}

static int set_lights(struct tia_view *view)
{
    struct raster_view *raster = raster_of(view);
    struct tia_shadow_view *shadow = &raster->shadow;
    struct asker asker = view_asker(view);
    int status = ray_set_lights(view);

    shadow->sample_count = 0;
    if (status)
        return status;
    for (uint32_t n = 0; n < view->light_count; n++) {
        raster->first_bit[n] = (uint8_t)shadow->sample_count;
        add_samples(shadow, &view->lights[n]);
    }
    return tia_shadow_technique(view->scene->shadows)->set_lights(shadow, &asker);
}

/* ---- the buffers of each pixel ---- */

#define PIXEL_BYTES (2 * sizeof(uint64_t) + 2 * sizeof(uint32_t))

/* Beside these. */
static uint64_t more_bytes(const struct tia_scene *scene)
{
    const struct tia_shadow_technique *technique = tia_shadow_technique(scene->shadows);

    return technique->shares ? technique->shares(scene) * sizeof(tia_share) : technique->scratch;
}

static uint64_t buffer_size(const struct tia_scene *scene, uint32_t pixels)
{
    return ALIGN((PIXEL_BYTES + more_bytes(scene)) * pixels);
}

static size_t buffers_index(const struct tia_shadow_tile *b, int x, int y)
{
    return ((size_t)y - b->target.area.y) * (size_t)b->target.pitch + ((size_t)x - b->target.area.x);
}

/* Those of a tile. */
static void find_buffers(const struct raster_view *raster, const struct tia_hits *hits, struct tia_tile tile,
                         struct tia_shadow_tile *b)
{
    size_t pixels = (size_t)hits->area.width * hits->area.height;
    struct tia_raster_target all = {.lattice = &raster->shadow.flat.lattice,
                                    .area = hits->area,
                                    .pitch = hits->area.width,
                                    .planes = raster->shadow.flat.planes,
                                    .planes_known = true,
                                    .face_count = raster->shadow.flat.face_count,
                                    .nearness = hits->buffer};

    size_t more = (size_t)more_bytes(raster->shadow.scene), first = hits_index(hits, tile.x, tile.y);
    b->lit = all.nearness + pixels;
    all.face = (uint32_t *)(b->lit + pixels);
    all.count = all.face + pixels;
    b->more = (char *)(all.count + pixels) + more * first;
    b->lit += first;
    (void)tia_raster_part(&b->target, &all, tile);
}

static void trace_tile(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile)
{
    const struct raster_view *raster = raster_of(view);
    struct tia_shadow_tile b;
    struct asker asker = view_asker(view);

    find_buffers(raster, hits, tile, &b);
    tia_clear_depth(&b.target);
    (void)tia_shadow_faces(&b.target, &raster->shadow.flat, &asker);
    for (int y = (int)tile.y; y < tile_bottom(tile); y++)
        for (int x = (int)tile.x; x < tile_right(tile); x++) {
            uint32_t face = b.target.face[buffers_index(&b, x, y)];
            hits->object[hits_index(hits, (unsigned)x, (unsigned)y)] =
                face == TIA_NO_FACE ? TIA_NO_OBJECT : tia_flat_object_of(&raster->shadow.flat, face)->object;
        }
}

/* ---- light ---- */

struct rasterised {
    struct first_hits hits;
    const struct raster_view *raster;
    const struct ray_camera *camera;
    const struct tia_shadow_tile *buffers;
    size_t shares; /* of a pixel, or 0 */
};

static void find_hit(const struct first_hits *hits, int x, int y, const struct ray *ray, struct hit *hit,
                     struct arrivals *lit)
{
    const struct rasterised *r = (const struct rasterised *)(const void *)hits;
    const struct tia_flat_scene *flat = &r->raster->shadow.flat;
    size_t at = buffers_index(r->buffers, x, y);
    uint32_t face = r->buffers->target.face[at];

    *hit = (struct hit){NUM_LENGTH_MAX, TIA_NO_OBJECT, 0, TIA_NO_OBJECT};
    lit->bits = r->buffers->lit[at];
    lit->shares = r->shares ? (const tia_share *)r->buffers->more + r->shares * at : NULL;
    if (face == TIA_NO_FACE)
        return;
    num_length depth = num_length_of_q45(tia_raster_distance(&flat->planes[face], &flat->lattice, x, y));
    num_length t = num_div(depth, num_dir_dot(num_dir_negated(r->camera->n), ray->direction));
    if (t >= NUM_LENGTH_FAR)
        return;
    hit->t = t;
    hit->object = tia_flat_object_of(flat, face)->object;
    hit->element = tia_flat_element_of(flat, face);
}

static void light_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                       const struct tia_surface *surface, const struct tia_options *options)
{
    const struct raster_view *raster = raster_of(view);
    const struct tia_shadow_technique *technique = tia_shadow_technique(view->scene->shadows);
    const struct ray_view *rays = view->prepared;
    struct tia_shadow_tile b;
    struct rasterised r = {{find_hit, raster->first_bit, is_whole(view->scene)}, raster, &rays->camera, &b, 0};

    find_buffers(raster, hits, tile, &b);
    r.shares = technique->shares ? technique->shares(view->scene) : 0;
    for (unsigned y = 0; y < tile.height; y++)
        for (unsigned x = 0; x < tile.width; x++)
            b.lit[(size_t)y * b.target.pitch + x] = 0;
    struct asker asker = view_asker(view);
    for (unsigned i = 0; i < raster->shadow.sample_count && !asker_stops(&asker, ASKER_PATIENCE); i++)
        technique->light(&raster->shadow, &b, i, &asker);
    whitted_light_tile(view, hits, tile, surface, options, &r.hits);
}

const struct renderer raster_renderer = {draws,       prepared_size, prepare,    set_lights,
                                         buffer_size, trace_tile,    light_tile, false};
