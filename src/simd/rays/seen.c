/* seen.c - pixels behind the rasteriser: the faces that it has found, and the lights that a shadow technique lets
 * arrive, go to the SIMD kernels; undecided pixels go to the fixed-point path. */
#include "bounds.h"
#include "raster/halves.h"
#include "render/hybrid/raster_view.h"
#include "simd/simd.h"
#include "sure_tile.h"

_Static_assert(SURE_SHARE_BITS == TIA_SHARE_BITS, "shares");

/* The faces of a view, in its memory behind the scene. */
struct faces {
    unsigned range; /* of the vertices, see struct raster_view */
    struct sure_seen_face face[];
};

struct seen_drawing {
    struct sure_drawing drawing; /* must be first */
    const struct tia_view *view;
    const struct tia_hits *hits;
    struct sure_seen seen;
};

static uint64_t faces_size(const struct tia_scene *scene)
{
    return offsetof(struct faces, face) +
           tia_flat_face_count(scene) * tia_flat_samples(scene) * sizeof(struct sure_seen_face);
}

static struct faces *faces_of(const struct tia_view *view)
{
    char *behind = (char *)tia_sure_scene(view) + SIMD_ALIGN(tia_sure_size(view->scene, view->light_capacity));

    return (struct faces *)(void *)behind;
}

static size_t size(const struct tia_scene *scene, uint32_t light_capacity)
{
    uint64_t rays = tia_sure_size(scene, light_capacity), all = SIMD_ALIGN(rays) + 64 + faces_size(scene);

    return rays > SIZE_MAX / 4 || all > SIZE_MAX / 2 ? SIZE_MAX : (size_t)all;
}

static size_t room(const struct tia_simd *simd)
{
    return simd_room(sizeof(struct seen_drawing), simd->sure->block_memory);
}

/* Returns a number of 128 bits as a double, within 2 u of itself: both halves have its sign. */
double tia_sure_double(const uint64_t halves[2])
{
    wide a = halves_get(halves), size = wide_size(a);
    double d = (double)wide_high(size) * 0x1p64 + (double)wide_low(size);

    return wide_sign(a) < 0 ? -d : d;
}

/* See tia_plane_distance(). */
void tia_sure_set_plane(struct sure_seen_face *to, const struct tia_raster_plane *plane,
                        const struct tia_raster_grid *grid)
{
    bool flat = grid->projection == TIA_ORTHOGRAPHIC;
    double det = tia_sure_double(plane->det), scale = (flat ? -1.0 : (double)(INT64_C(1) << grid->fraction)) / grid->w;
    const uint64_t *const row[3] = {plane->x, plane->y, plane->c};

    if (det <= 0)
        to->object = TIA_NO_OBJECT;
    for (int i = 0; i < 3; i++)
        to->inverse[i] = det > 0 ? tia_sure_double(row[i]) / det * scale : 0;
}

/* True if the kernels shade such a face without rays and lane by lane: see plain_tmpl.h. */
static bool is_plain(const struct sure_scene *s, const struct tia_flat_object *object, const struct sure_material *m)
{
    const struct sure_object *o = &s->object[object->object];
    uint32_t spawns = 1u << SURE_MIRROR / 3 | 1u << SURE_REFRACTION / 3;

    return !object->divided && m->known && !(m->groups & spawns) &&
           (!m->texture || (m->texture->kind == TIA_CHECKER && o->kind == SURE_PLANE && !o->placed));
}

static void set_face(struct sure_seen_face *to, const struct sure_scene *s, const struct tia_flat_scene *flat,
                     const struct tia_flat_object *object, uint32_t face)
{
    const struct ray_view *rays = s->view;
    struct surface surface;

    to->element = tia_flat_element_of(flat, face);
    to->object = object->divided ? TIA_NO_OBJECT : object->object;
    to->material = ray_material(rays, object->object, to->element);
    tia_sure_set_plane(to, &flat->planes[face], &flat->grid);
    to->plain = to->object != TIA_NO_OBJECT && is_plain(s, object, &s->materials[to->material]) &&
                !raster_is_smooth(rays->scene, object, to->element);
    if (!to->plain)
        return;
    const struct hit hit = {.object = object->object, .element = to->element, .light = TIA_NO_OBJECT};
    ray_surface(rays, &hit, rays->camera.eye, &surface);
    sure_dir(to->normal, surface.normal);
}

static void set_faces(struct sure_seen_face *to, const struct sure_scene *s, const struct tia_flat_scene *flat)
{
    for (uint32_t i = 0; i < flat->object_count; i++) {
        const struct tia_flat_object *object = &flat->objects[i];
        for (uint32_t face = object->first_face; face < object->first_face + object->face_count; face++)
            set_face(&to[face], s, flat, object, face);
    }
}

static void open(struct tia_view *view)
{
    tia_sure_prepare(view);
    faces_of(view)->range = RASTER_NO_RANGE;
}

static void prepare(struct tia_view *view)
{
    const struct raster_view *raster = raster_of(view);
    struct faces *faces = faces_of(view);

    tia_sure_set_lights(view);
    for (unsigned i = 0; i < raster->sample_count && faces->range != raster->range; i++)
        set_faces(faces->face + (size_t)i * raster->shadow->flat.face_count, tia_sure_scene(view),
                  &raster->shadow[i].flat);
    faces->range = raster->range;
}

/* Repeats the last slot behind the block, for packets that extend beyond it. */
static void set_end(struct sure_seen *seen, int end)
{
    for (int i = end; i < end + SURE_ENDS - SURE_SLOTS; i++) {
        seen->face[i] = seen->face[end - 1];
        seen->lit[i] = seen->lit[end - 1];
        seen->shares[i] = seen->shares[end - 1];
    }
}

static void set_seen(struct seen_drawing *d)
{
    const struct raster_view *raster = raster_of(d->view);
    const struct sure_block *b = &d->drawing.block;
    const struct sure_seen_face *faces = faces_of(d->view)->face;
    size_t face_count = raster->shadow->flat.face_count;

    for (int i = 0; i < b->samples; i++) {
        const struct raster_buffers from = raster_buffers(raster, d->hits, (unsigned)i);
        const tia_share *shares = (const tia_share *)(const void *)from.more;
        const struct sure_seen_face *own = faces + (size_t)i * face_count;
        for (int y = 0, slot = i; y < b->height; y++) {
            size_t at = hits_index(d->hits, (unsigned)b->x, (unsigned)(b->y + y));
            for (int x = 0; x < b->width; x++, at++, slot += b->samples) {
                d->seen.face[slot] = from.face[at] == TIA_NO_FACE ? NULL : own + from.face[at];
                d->seen.lit[slot] = from.lit[at];
                d->seen.shares[slot] = raster->shares ? shares + raster->shares * at : NULL;
            }
        }
    }
    set_end(&d->seen, b->width * b->height * b->samples);
}

static void trace(struct sure_drawing *drawing, void *kernels_room)
{
    struct seen_drawing *d = (struct seen_drawing *)(void *)drawing;
    struct sure_block *b = &drawing->block;

    set_seen(d);
    drawing->kernels->shade(b, kernels_room);
    for (int i = 0; i < b->width * b->height * b->samples; i++)
        if (b->unsure[i])
            b->error[i] = SURE_SLOTS; /* leaves the mean of any number of samples open */
}

static tia_rgb565 exact_pixel(struct sure_drawing *drawing, int x, int y, num_u threshold)
{
    const struct seen_drawing *d = (const struct seen_drawing *)(void *)drawing;
    const struct tia_tile pixel = {(uint16_t)x, (uint16_t)y, 1, 1};
    tia_rgb565 out = 0;

    (void)threshold;
    if (!cancelled(&drawing->block.cancel, CANCEL_INTERVAL))
        raster_shade_tile(d->view, d->hits, pixel, &(struct tia_surface){.pixels = &out},
                          &(struct tia_options){.dither = drawing->dither});
    return out;
}

static bool shade(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                  const struct tia_surface *surface, const struct tia_options *options, void *memory)
{
    const struct sure_scene *s = tia_sure_scene(view);
    const struct raster_view *raster = raster_of(view);
    struct seen_drawing *d = memory;

    if (s->occluded || s->fixed_only || faces_of(view)->range != raster->range)
        return false;
    d->view = view;
    d->hits = hits;
    d->seen.first_bit = raster->first_bit;
    d->seen.whole = raster->whole;
    d->seen.shared = raster->shares > 0;
    d->drawing.trace = trace;
    d->drawing.exact_pixel = exact_pixel;
    d->drawing.block.seen = &d->seen;
    tia_sure_draw(&d->drawing, view, tile, surface, options, simd_kernels_room(d, sizeof *d));
    return true;
}

/* True if the SIMD kernels shade the view; mirrored rays need the boxes of a hierarchy. */
static bool draws(const struct tia_view *view)
{
    const struct ray_view *rays = view->prepared;

    return !rays->filtered && view->scene->bvh && !view->scene->field && !raster_of(view)->place_count;
}

const struct simd_renderer tia_simd_seen = {size, draws, open, prepare, room, NULL, NULL, shade};
