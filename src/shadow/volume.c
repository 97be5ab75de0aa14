#include "volume.h"

#include "math/noinline.h"

struct drawing {
    struct tia_raster_target *target;
    const struct tia_flat_scene *flat;
    const tia_flat_light *light;
    struct cancel *cancel;
    struct tia_raster_state state;
    bool near, far; /* caps to draw */
    uint32_t part;  /* the part whose caps are fans, and their apices; TIA_NO_FACE: none yet */
    struct tia_raster_vertex apex[2];
};

/* Returns the number of items of work for a polygon, which may cover the whole target. */
static uint32_t work_of(const struct tia_raster_target *target)
{
    return 1 + (uint32_t)target->area.width * target->area.height / 512;
}

/* Returns the end of a corner's shadow, which is at infinity. */
static NOINLINE struct tia_raster_vertex shadow_of(const struct drawing *d, const struct tia_raster_vertex *v)
{
    const tia_flat_light *l = d->light;

    if (tia_flat_is_direction(d->flat, v))
        return *v;
    if (tia_flat_is_direction(d->flat, l))
        return (struct tia_raster_vertex){-l->x, -l->y, -l->w, -l->h};
    return (struct tia_raster_vertex){v->x - l->x, v->y - l->y, v->w - l->w, v->h - l->h};
}

static NOINLINE int draw(const struct drawing *d, const struct tia_raster_vertex *corners, unsigned count,
                         uint32_t face)
{
    if (cancelled(d->cancel, work_of(d->target)))
        return TIA_STOPPED;
    return tia_raster_draw(d->target, &d->state, corners, count, face);
}

/* Draws the side of a volume at the cap's edge from a to b; in the side, this edge runs from b to a. A vertex at
 * infinity is its own shadow. */
static int draw_side(const struct drawing *d, const struct tia_raster_vertex *a, const struct tia_raster_vertex *b)
{
    struct tia_raster_vertex corners[4] = {*b, *a};
    unsigned count = 2;

    if (!tia_flat_is_direction(d->flat, a))
        corners[count++] = shadow_of(d, a);
    if (!tia_flat_is_direction(d->flat, b) && (count == 2 || !tia_flat_is_direction(d->flat, d->light)))
        corners[count++] = shadow_of(d, b);
    return count < 3 ? TIA_OK : draw(d, corners, count, TIA_NO_FACE);
}

/* True if draw_fans() draws a caster's caps. */
static bool has_fans(const struct drawing *d, const struct tia_volume_caster *c)
{
    return c->closed && d->near && d->far;
}

/* Draws a face's caps. A polygon's plane is that of its first three corners, and only a face's first corner is certain
 * to be a point. So the reverse order begins with that corner, too. Orthographic rays never meet points at infinity. */
static int draw_caps(const struct drawing *d, const struct tia_volume_caster *c, uint32_t face)
{
    struct tia_raster_vertex near[TIA_SIDES], far[TIA_SIDES];
    bool has_near = d->near && tia_flat_may_cover(d->flat, face, &d->target->area);
    unsigned sides = c->sides;

    for (unsigned k = 0; (has_near || d->far) && k < sides; k++) {
        near[k] = *tia_face_corner(d->flat, c->face, c->turned ? (sides - k) % sides : k);
        far[(sides - k) % sides] = shadow_of(d, &near[k]);
    }
    int status = has_near ? draw(d, near, sides, face) : TIA_OK;
    return status || !d->far ? status : draw(d, far, sides, TIA_NO_FACE);
}

/* Draws the part of a closed object's caps at the silhouette's edge from a to b: two triangles, of fans whose apex is
 * the first edge's a, and its shadow.
 *
 * In perspective, near caps are nowhere in front of the visible face, and far caps are at infinity, so both count at
 * all pixels that they cover. Eye and light are outside of the object's box, so each kind of caps fills less than half
 * of all directions. There, any surface with the same border counts the same at each pixel, as often as the border
 * winds around it, and near caps may be at infinity too. The triangles' edges at the apex come in pairs, once in either
 * direction. Sides have the other edges. */
static int draw_fans(struct drawing *d, const struct tia_volume_caster *c, const struct tia_raster_vertex *a,
                     const struct tia_raster_vertex *b)
{
    const struct tia_raster_vertex near[3] = {d->apex[0], {a->x, a->y, a->w, 0}, {b->x, b->y, b->w, 0}};
    const struct tia_raster_vertex far[3] = {d->apex[1], shadow_of(d, b), shadow_of(d, a)};

    if (d->part != c->part) {
        d->part = c->part;
        d->apex[0] = near[1];
        d->apex[1] = far[2];
        return TIA_OK;
    }
    int status = draw(d, near, 3, TIA_NO_FACE);
    return status || tia_flat_is_direction(d->flat, d->light) ? status : draw(d, far, 3, TIA_NO_FACE);
}

static int draw_volume(void *ctx, const struct tia_volume_caster *c, uint32_t face)
{
    struct drawing *d = ctx;
    int status = has_fans(d, c) ? TIA_OK : draw_caps(d, c, face);

    for (unsigned k = 0; !status && c->silhouette >> k; k++) {
        const struct tia_raster_vertex *from = tia_face_corner(d->flat, c->face, k);
        const struct tia_raster_vertex *to = tia_face_corner(d->flat, c->face, k + 1 < c->sides ? k + 1 : 0);
        const struct tia_raster_vertex *a = c->turned ? to : from, *b = c->turned ? from : to;
        bool is_side = c->silhouette >> k & 1;
        status = is_side ? draw_side(d, a, b) : TIA_OK;
        if (is_side && !status && has_fans(d, c))
            status = draw_fans(d, c, a, b);
    }
    return status;
}

#define KEEPS                                                                                                          \
    {                                                                                                                  \
        .test = TIA_COMPARE_ALWAYS, .mask = 255, .write = 255                                                          \
    }

int tia_shadow_faces(struct tia_raster_target *target, const struct tia_flat_scene *flat, struct cancel *cancel)
{
    static const struct tia_raster_state state = {.depth = TIA_COMPARE_LESS,
                                                  .depth_write = true,
                                                  .ties_by_face = true,
                                                  .ahead = true,
                                                  .front = KEEPS,
                                                  .back = KEEPS};
    int status = TIA_OK;

    for (uint32_t f = 0; !status && f < flat->face_count; f++) {
        struct tia_raster_vertex corners[TIA_SIDES];
        bool covers = tia_flat_may_cover(flat, f, &target->area);
        if (cancelled(cancel, covers ? work_of(target) : 1))
            return TIA_STOPPED;
        if (!covers)
            continue;
        unsigned sides = tia_flat_corners(flat, f, corners);
        status = tia_raster_draw(target, &state, corners, sides, f);
    }
    return status;
}

/* Counts the surfaces of volumes behind the point, where the ray leaves volumes through back faces and enters others
 * through front faces; or those in front of it, with opposite signs. In orthographic views no ray reaches the far caps,
 * which are at infinity; they are never in front of a point. A near cap is in front of a visible face only behind the
 * window of an orthographic view. */
static int draw_volumes(struct tia_raster_target *target, const struct tia_flat_scene *flat,
                        struct tia_shadow_light light, bool behind, struct cancel *cancel)
{
    bool flat_view = flat->eye.projection == TIA_ORTHOGRAPHIC;
    struct drawing d = {.target = target,
                        .flat = flat,
                        .light = light.at,
                        .cancel = cancel,
                        .state = {.depth = TIA_COMPARE_LESS, .front = KEEPS, .back = KEEPS},
                        .near = behind || flat_view,
                        .far = behind && !flat_view,
                        .part = TIA_NO_FACE};

    *(behind ? &d.state.front.zfail : &d.state.back.zpass) = TIA_STENCIL_DECR_WRAP;
    *(behind ? &d.state.back.zfail : &d.state.front.zpass) = TIA_STENCIL_INCR_WRAP;
    return tia_volume_casters(flat, light, !flat_view, draw_volume, &d, cancel);
}

int tia_shadow_zfail(struct tia_raster_target *target, const struct tia_flat_scene *flat, struct tia_shadow_light light,
                     struct cancel *cancel)
{
    return draw_volumes(target, flat, light, true, cancel);
}

int tia_shadow_zpass(struct tia_raster_target *target, const struct tia_flat_scene *flat, struct tia_shadow_light light,
                     struct cancel *cancel)
{
    return draw_volumes(target, flat, light, false, cancel);
}
