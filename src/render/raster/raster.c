/* raster.c - what each pixel sees of flat faces is rasterised, of curved objects found by rays, and a technique for
 * shadows tells which lights reach flat faces past each other; colours come about as the ray renderer makes them.
 * Behind the struct ray_view that the latter prepares stands a struct raster_view. */
#include "curved.h"
#include "math/align.h"
#include "render/whitted/whitted.h"
#include "shadow/curved.h"
#include "shadow/technique.h"

struct raster_view {
    uint8_t *first_bit; /* for each light, which of the samples its first one is */
    struct tia_curved_place *places;
    uint32_t place_count;
    unsigned sample_count;           /* of a pixel */
    struct tia_shadow_view shadow[]; /* one for each; they share all but lattice and planes */
};

/* ---- preparing ---- */

static bool draws(const struct tia_scene *scene)
{
    return scene->shadows != TIA_SHADOWS_TRACED;
}

static uint64_t view_size(const struct tia_scene *scene)
{
    return ALIGN(sizeof(struct raster_view) + tia_flat_samples(scene) * sizeof(struct tia_shadow_view));
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

static struct raster_view *raster_of(const struct tia_view *view)
{
    char *own = (char *)view->prepared + ALIGN(ray_prepared_size(view->scene, view->light_capacity));

    return (struct raster_view *)(void *)own;
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
        add_samples(shadow, &view->lights[n]);
    }
    status = tia_shadow_technique(view->scene->shadows)->set_lights(shadow, &asker);
    for (unsigned i = 1; i < raster->sample_count; i++) {
        shadow[i] = shadow[0];
        tia_flat_sample(&shadow[i].flat, &shadow[0].flat, view->scene, i);
    }
    return status;
}

/* ---- the buffers of each sample of each pixel ---- */

#define PIXEL_BYTES (2 * sizeof(uint64_t) + 3 * sizeof(uint32_t))

/* Beside these. */
static uint64_t more_bytes(const struct tia_scene *scene)
{
    const struct tia_shadow_technique *technique = tia_shadow_technique(scene->shadows);

    return technique->shares ? technique->shares(scene) * sizeof(tia_share) : technique->scratch;
}

static uint64_t sample_size(const struct tia_scene *scene, uint64_t pixels)
{
    return ALIGN((PIXEL_BYTES + more_bytes(scene)) * pixels);
}

static uint64_t buffer_size(const struct tia_scene *scene, uint32_t pixels)
{
    return tia_flat_samples(scene) * sample_size(scene, pixels);
}

/* Those of a sample, of all pixels of the hits. */
struct buffers {
    uint64_t *nearness, *lit;
    uint32_t *object; /* what is seen, or TIA_NO_OBJECT */
    uint32_t *face;   /* of what is seen, TIA_NO_FACE if that is not flat */
    uint32_t *count;
    char *more;
    size_t more_bytes; /* of a pixel */
};

static struct buffers buffers_of(const struct tia_scene *scene, const struct tia_hits *hits, unsigned sample)
{
    size_t pixels = (size_t)hits->area.width * hits->area.height;
    struct buffers b = {.more_bytes = (size_t)more_bytes(scene)};

    b.nearness = (void *)((char *)hits->buffer + ALIGN((PIXEL_BYTES + b.more_bytes) * pixels) * sample);
    b.lit = b.nearness + pixels;
    b.object = (uint32_t *)(b.lit + pixels);
    b.face = b.object + pixels;
    b.count = b.face + pixels;
    b.more = (char *)(b.count + pixels);
    return b;
}

/* Those of a tile. */
static void open_tile(const struct tia_shadow_view *shadow, const struct tia_hits *hits, struct tia_tile tile,
                      const struct buffers *b, struct tia_shadow_tile *open)
{
    size_t first = hits_index(hits, tile.x, tile.y);
    struct tia_raster_target all = {.lattice = &shadow->flat.lattice,
                                    .area = hits->area,
                                    .pitch = hits->area.width,
                                    .planes = shadow->flat.planes,
                                    .planes_known = true,
                                    .face_count = shadow->flat.face_count,
                                    .face = b->face,
                                    .count = b->count,
                                    .nearness = b->nearness};

    open->lit = b->lit + first;
    open->more = b->more + b->more_bytes * first;
    (void)tia_raster_part(&open->target, &all, tile);
}

/* ---- what is seen ---- */

/* Where the ray of a pixel meets a face. */
static void find_face(const struct ray_view *rays, const struct tia_flat_scene *flat, uint32_t face, int x, int y,
                      const struct ray *ray, struct hit *hit)
{
    *hit = (struct hit){NUM_LENGTH_MAX, TIA_NO_OBJECT, 0, TIA_NO_OBJECT};
    if (face == TIA_NO_FACE)
        return;
    num_length depth = num_length_of_q45(tia_raster_distance(&flat->planes[face], &flat->lattice, x, y));
    num_length t = num_div(depth, num_dir_dot(num_dir_negated(rays->camera.n), ray->direction));
    if (t >= NUM_LENGTH_FAR)
        return;
    hit->t = t;
    hit->object = tia_flat_object_of(flat, face)->object;
    hit->element = tia_flat_element_of(flat, face);
}

static uint32_t higher(uint32_t a, uint32_t b)
{
    return a > b ? a : b;
}

static uint32_t lower(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

/* Sets the count where a curved object may be seen. */
static void mark(const struct raster_view *raster, const struct tia_hits *hits, struct tia_tile tile, uint32_t *count)
{
    for (uint32_t i = 0; i < raster->place_count; i++) {
        const struct tia_curved_place *place = &raster->places[i];
        uint32_t right = lower(place->x1, (uint32_t)tile_right(tile));
        uint32_t bottom = lower(place->y1, (uint32_t)tile_bottom(tile));

        for (uint32_t y = higher(place->y0, tile.y); y < bottom; y++)
            for (uint32_t x = higher(place->x0, tile.x); x < right; x++)
                count[hits_index(hits, (unsigned)x, (unsigned)y)] = 1;
    }
}

/* A curved object takes the place of the face that a pixel sees, if it is nearer. */
static void look_for_curved(const struct ray_view *rays, const struct tia_flat_scene *flat, const struct buffers *b,
                            size_t at, int x, int y, unsigned sample)
{
    struct ray ray;
    struct hit hit;

    ray_camera_ray(&rays->camera, x, y, (int)sample, &ray);
    find_face(rays, flat, b->face[at], x, y, &ray, &hit);
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
    struct buffers b = buffers_of(view->scene, hits, sample);
    struct path path = {.view = view->prepared};
    struct asker asker = view_asker(view);
    struct tia_shadow_tile open;

    open_tile(&raster->shadow[sample], hits, tile, &b, &open);
    tia_clear_depth(&open.target);
    tia_clear_count(&open.target, 0);
    (void)tia_shadow_faces(&open.target, flat, &asker);
    mark(raster, hits, tile, b.count);
    for (int y = (int)tile.y; y < tile_bottom(tile); y++)
        for (int x = (int)tile.x; x < tile_right(tile); x++) {
            size_t at = hits_index(hits, (unsigned)x, (unsigned)y);
            b.object[at] = b.face[at] == TIA_NO_FACE ? TIA_NO_OBJECT : tia_flat_object_of(flat, b.face[at])->object;
            if (b.count[at] && !path_stops(&path))
                look_for_curved(path.view, flat, &b, at, x, y, sample);
        }
}

static void trace_tile(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile)
{
    struct buffers b = buffers_of(view->scene, hits, 0);

    for (unsigned i = 0; i < raster_of(view)->sample_count; i++)
        trace_sample(view, hits, tile, i);
    for (unsigned y = tile.y; y < (unsigned)tile_bottom(tile); y++)
        for (unsigned x = tile.x; x < (unsigned)tile_right(tile); x++)
            hits->object[hits_index(hits, x, y)] = b.object[hits_index(hits, x, y)];
}

/* ---- light ---- */

struct rasterised {
    struct first_hits first;
    const struct raster_view *raster;
    const struct ray_view *rays;
    const struct tia_hits *hits;
    size_t shares; /* of a sample of a pixel, or 0 */
};

/* Faces that stand for a curved surface only tell what is seen and lit; the colour is that of the surface behind or
 * before them. A ray can miss it where the shape is open. */
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
    const struct buffers b = buffers_of(r->raster->shadow->scene, r->hits, (unsigned)sample);
    size_t at = hits_index(r->hits, (unsigned)x, (unsigned)y);

    if (b.object[at] != TIA_NO_OBJECT && b.face[at] == TIA_NO_FACE) {
        ray_intersect_object(r->rays, ray, b.object[at], hit);
        return false;
    }
    lit->bits = b.lit[at];
    lit->shares = r->shares ? (const tia_share *)(const void *)b.more + r->shares * at : NULL;
    find_face(r->rays, &r->raster->shadow[sample].flat, b.face[at], x, y, ray, hit);
    show_surface(r, b.face[at], ray, hit);
    return true;
}

/* What is curved may stand in the way of light that passes all faces. */
static bool passes(const struct first_hits *first, const struct ray *shadow, num_length distance, uint32_t *blocker)
{
    const struct rasterised *r = (const struct rasterised *)(const void *)first;

    return curved_passes(r->rays, shadow, distance, blocker);
}

static void light_sample(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                         unsigned sample, struct asker *asker)
{
    const struct tia_shadow_technique *technique = tia_shadow_technique(view->scene->shadows);
    const struct tia_shadow_view *shadow = &raster_of(view)->shadow[sample];
    struct buffers b = buffers_of(view->scene, hits, sample);
    struct tia_shadow_tile open;

    open_tile(shadow, hits, tile, &b, &open);
    for (unsigned y = 0; y < tile.height; y++)
        for (unsigned x = 0; x < tile.width; x++)
            open.lit[(size_t)y * (size_t)open.target.pitch + x] = 0;
    for (unsigned i = 0; i < shadow->sample_count && !asker_stops(asker, ASKER_PATIENCE); i++)
        technique->light(shadow, &open, i, asker);
}

static void light_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                       const struct tia_surface *surface, const struct tia_options *options)
{
    const struct raster_view *raster = raster_of(view);
    const struct tia_shadow_technique *technique = tia_shadow_technique(view->scene->shadows);
    struct asker asker = view_asker(view);
    struct rasterised r = {
        .first = {find_hit, raster->first_bit, is_whole(view->scene), raster->place_count ? passes : NULL},
        .raster = raster,
        .rays = view->prepared,
        .hits = hits,
        .shares = technique->shares ? technique->shares(view->scene) : 0};

    for (unsigned i = 0; i < raster->sample_count; i++)
        light_sample(view, hits, tile, i, &asker);
    whitted_light_tile(view, hits, tile, surface, options, &r.first);
}

const struct renderer raster_renderer = {draws,      prepared_size, prepare, set_lights, buffer_size,
                                         trace_tile, light_tile,    false,   false,      has_room};
