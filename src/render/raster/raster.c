/* raster.c - scenes of flat faces: what each pixel sees is rasterised, and each light's shadows are shadow volumes in
 * its stencil buffer; colours come about as the ray renderer makes them. Behind the struct ray_view that the latter
 * prepares stands a struct raster_view. */
#include "math/align.h"
#include "raster/target.h"
#include "render/whitted/whitted.h"
#include "shadow/volume.h"

struct raster_view {
    struct tia_flat_scene flat;
    int status; /* of preparing the faces */
    unsigned sample_count;
    tia_flat_light samples[TIA_SHADOW_SAMPLES];
    uint8_t *first_bit; /* for each light, which sample its first one is */
};

/* ---- preparing ---- */

static bool draws(const struct tia_scene *scene)
{
    return scene->shadows != TIA_SHADOWS_TRACED;
}

static uint64_t own_size(uint32_t light_capacity)
{
    return ALIGN(sizeof(struct raster_view)) + ALIGN((uint64_t)light_capacity);
}

static size_t prepared_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    uint64_t rays = ray_prepared_size(scene, light_capacity), flat = tia_flat_size(scene);
    uint64_t size = ALIGN(rays) + own_size(light_capacity) + flat;

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
    int status = ray_prepare(view);

    raster->first_bit = (uint8_t *)own + ALIGN(sizeof *raster);
    raster->sample_count = 0;
    if (status)
        return status;
    return tia_flat_init(&raster->flat, own + own_size(view->light_capacity), tia_flat_size(view->scene), view->scene,
                         (unsigned)view->width, (unsigned)view->height);
}

static int set_lights(struct tia_view *view)
{
    struct raster_view *raster = raster_of(view);
    int status = ray_set_lights(view);

    raster->sample_count = 0;
    if (status)
        return status;
    for (uint32_t n = 0; n < view->light_count; n++) {
        raster->first_bit[n] = (uint8_t)raster->sample_count;
        for (unsigned i = 0; i < tia_flat_light_samples(&view->lights[n]); i++)
            tia_flat_light_at(&raster->flat, &view->lights[n], i, &raster->samples[raster->sample_count++]);
    }
    return TIA_OK;
}

/* ---- the buffers of each pixel ---- */

struct buffers {
    struct tia_raster_target target;
    uint64_t *lit; /* a bit for each sample */
};

#define PIXEL_BYTES (2 * sizeof(uint64_t) + sizeof(uint32_t) + sizeof(uint8_t))

static uint64_t buffer_size(const struct tia_scene *scene, uint32_t pixels)
{
    (void)scene;
    return ALIGN(PIXEL_BYTES * pixels);
}

/* Those of a tile. */
static void find_buffers(const struct raster_view *raster, const struct tia_hits *hits, struct tia_tile tile,
                         struct buffers *b)
{
    size_t pixels = (size_t)hits->area.width * hits->area.height;
    struct tia_raster_target all = {.lattice = &raster->flat.lattice,
                                    .area = hits->area,
                                    .pitch = hits->area.width,
                                    .planes = raster->flat.planes,
                                    .planes_known = true,
                                    .face_count = raster->flat.face_count,
                                    .nearness = hits->buffer};

    b->lit = all.nearness + pixels;
    all.face = (uint32_t *)(b->lit + pixels);
    all.stencil = (uint8_t *)(all.face + pixels);
    b->lit += hits_index(hits, tile.x, tile.y);
    (void)tia_raster_part(&b->target, &all, tile);
}

static void trace_tile(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile)
{
    const struct raster_view *raster = raster_of(view);
    struct buffers b;

    find_buffers(raster, hits, tile, &b);
    tia_clear_depth(&b.target);
    (void)tia_shadow_faces(&b.target, &raster->flat);
    for (int y = (int)tile.y; y < tile_bottom(tile); y++)
        for (int x = (int)tile.x; x < tile_right(tile); x++) {
            uint32_t face = b.target.face[target_index(&b.target, x, y)];
            hits->object[hits_index(hits, (unsigned)x, (unsigned)y)] =
                face == TIA_NO_FACE ? TIA_NO_OBJECT : tia_flat_object_of(&raster->flat, face)->object;
        }
}

/* ---- light ---- */

/* Counts volumes in the stencil buffer; returns what it has where light arrives. */
static uint8_t count_volumes(const struct raster_view *raster, struct buffers *b, const tia_flat_light *light,
                             enum tia_shadows technique)
{
    uint32_t eye, far;
    bool knows_eye = tia_shadow_count_eye(&raster->flat, light, &eye);
    bool knows_far = tia_shadow_count_far(&raster->flat, light, &far);
    bool pass = technique == TIA_SHADOWS_ZPASS ? knows_eye || !knows_far : !knows_far && knows_eye;

    tia_clear_stencil(&b->target, 0, 255);
    if (pass)
        (void)tia_shadow_zpass(&b->target, &raster->flat, light);
    else
        (void)tia_shadow_zfail(&b->target, &raster->flat, light);
    return (uint8_t)(0 - (pass ? eye : far));
}

/* A face is dark where it is turned away from the light, and where volumes hold it. */
static void keep_lit(const struct raster_view *raster, struct buffers *b, unsigned sample, uint8_t none)
{
    const struct tia_tile *area = &b->target.area;
    const tia_flat_light *light = &raster->samples[sample];
    uint32_t last = TIA_NO_FACE;
    bool turned = false;

    for (unsigned y = 0; y < area->height; y++)
        for (unsigned x = 0; x < area->width; x++) {
            size_t at = (size_t)y * (size_t)b->target.pitch + x;
            uint32_t face = b->target.face[at];
            if (face == TIA_NO_FACE || b->target.stencil[at] != none)
                continue;
            if (face != last)
                turned = tia_flat_is_turned(&raster->flat, face, light);
            last = face;
            b->lit[at] |= (uint64_t)turned << sample;
        }
}

struct rasterised {
    struct first_hits hits;
    const struct raster_view *raster;
    const struct ray_camera *camera;
    const struct buffers *buffers;
};

static void find_hit(const struct first_hits *hits, int x, int y, const struct ray *ray, struct hit *hit, uint64_t *lit)
{
    const struct rasterised *r = (const struct rasterised *)(const void *)hits;
    const struct tia_flat_scene *flat = &r->raster->flat;
    size_t at = target_index(&r->buffers->target, x, y);
    uint32_t face = r->buffers->target.face[at];

    *hit = (struct hit){NUM_LENGTH_MAX, TIA_NO_OBJECT, 0, TIA_NO_OBJECT};
    *lit = r->buffers->lit[at];
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
    const struct ray_view *rays = view->prepared;
    struct buffers b;
    struct rasterised r = {{find_hit, raster->first_bit}, raster, &rays->camera, &b};

    find_buffers(raster, hits, tile, &b);
    for (unsigned y = 0; y < tile.height; y++)
        for (unsigned x = 0; x < tile.width; x++)
            b.lit[(size_t)y * b.target.pitch + x] = 0;
    for (unsigned i = 0; i < raster->sample_count && !view_stops(view); i++)
        keep_lit(raster, &b, i, count_volumes(raster, &b, &raster->samples[i], view->scene->shadows));
    whitted_light_tile(view, hits, tile, surface, options, &r.hits);
}

const struct renderer raster_renderer = {draws,       prepared_size, prepare,   set_lights,
                                         buffer_size, trace_tile,    light_tile};
