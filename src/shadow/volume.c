#include "volume.h"

#include "math/wide.h"

#define KNOWN_SIDES 256

static const struct tia_raster_vertex *corner(const struct tia_flat_scene *flat, const struct tia_flat_face *face,
                                              unsigned k)
{
    return &flat->points[face->corner[k]];
}

/* ---- sides of planes ---- */

static int sign(wide a)
{
    return wide_is_negative(a) ? -1 : wide_bits(a) != 0;
}

/* Returns the sign of (a x b).c. Components are below 2^41 in magnitude, so the product is below 2^126. */
static int orientation(const int64_t a[3], const int64_t b[3], const int64_t c[3])
{
    wide sum = wide_product(0, 0);

    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        wide n = wide_difference(wide_product(a[j], b[k]), wide_product(a[k], b[j]));
        sum = wide_sum(sum, wide_times(n, c[i]));
    }
    return sign(sum);
}

/* Gives the vector from a face's first corner, which is a point, to v; if v is a direction, gives v. */
static void relative(const struct tia_flat_scene *flat, const struct tia_flat_face *face,
                     const struct tia_raster_vertex *v, int64_t out[3])
{
    int64_t first[3];

    tia_flat_affine(flat, v, out);
    if (tia_flat_is_direction(flat, v))
        return;
    tia_flat_affine(flat, corner(flat, face, 0), first);
    for (int i = 0; i < 3; i++)
        out[i] -= first[i];
}

/* the axes x, y, w are left-handed, x, y, h right-handed */
int tia_flat_side(const struct tia_flat_scene *flat, const struct tia_flat_face *face, const tia_flat_light *light)
{
    int64_t a[3], b[3], c[3];

    relative(flat, face, corner(flat, face, 1), a);
    relative(flat, face, corner(flat, face, 2), b);
    relative(flat, face, light, c);
    int turn = orientation(a, b, c);
    return flat->eye.projection == TIA_ORTHOGRAPHIC ? turn : -turn;
}

/* The eye. In all projections, only its fourth coordinate is not 0. */
static const struct tia_raster_vertex eye = {0, 0, 0, 1};

int tia_flat_side_of_eye(const struct tia_flat_scene *flat, const struct tia_flat_face *face)
{
    return tia_flat_side(flat, face, &eye);
}

bool tia_flat_is_turned(const struct tia_flat_scene *flat, uint32_t face, const tia_flat_light *light)
{
    int side = tia_flat_side(flat, &flat->faces[face], light);

    return side && side == tia_flat_side_of_eye(flat, &flat->faces[face]);
}

/* ---- casters ---- */

/* In perspective, all visible points are on the eye's side of the plane, or in it. In orthographic views rays start at
 * the window, which the plane may cross. */
bool tia_flat_hides_nothing(const struct tia_flat_scene *flat, const struct tia_flat_object *object,
                            const tia_flat_light *light)
{
    const struct tia_flat_face *face = &flat->faces[object->first_face];

    return object->kind == TIA_PLANE && flat->eye.projection != TIA_ORTHOGRAPHIC &&
           tia_flat_side(flat, face, light) * tia_flat_side_of_eye(flat, face) > 0;
}

/* A face that casts a shadow. Seen from the light, its corners run counterclockwise. */
struct caster {
    const struct tia_flat_face *face;
    unsigned sides;
    bool turned;          /* the caster's corners run in the reverse order of the face's */
    bool side[TIA_SIDES]; /* side k, from corner k to the next, is part of the silhouette */
};

static bool is_between(const int64_t low[3], const int64_t at[3], const int64_t high[3])
{
    return low[0] <= at[0] && at[0] <= high[0] && low[1] <= at[1] && at[1] <= high[1] && low[2] <= at[2] &&
           at[2] <= high[2];
}

/* True if the eye is outside the object's box; in orthographic views, where the eye is at infinity, if the box is in
 * front of the window. */
static bool is_seen_whole(const struct tia_flat_scene *flat, const struct tia_flat_object *object)
{
    static const int64_t here[3] = {0, 0, 0};

    return flat->eye.projection == TIA_ORTHOGRAPHIC ? object->high[2] <= 0
                                                    : !is_between(object->low, here, object->high);
}

bool tia_flat_has_silhouette(const struct tia_flat_scene *flat, const struct tia_flat_object *object,
                             const tia_flat_light *light)
{
    int64_t at[3];

    tia_flat_affine(flat, light, at);
    return object->closed && is_seen_whole(flat, object) &&
           (tia_flat_is_direction(flat, light) || !is_between(object->low, at, object->high));
}

/* Sides of the light that were computed last: neighbours of a face ask for them again. */
struct known_sides {
    uint32_t face[KNOWN_SIDES];
    int8_t side[KNOWN_SIDES];
};

/* Returns tia_flat_side() of face f. */
static int known_side(struct known_sides *known, const struct tia_flat_scene *flat, const tia_flat_light *light,
                      uint32_t f)
{
    uint32_t at = f % KNOWN_SIDES;

    if (known->face[at] != f) {
        known->face[at] = f;
        known->side[at] = (int8_t)tia_flat_side(flat, &flat->faces[f], light);
    }
    return known->side[at];
}

/* Sets *c and returns true if face f casts a shadow. Faces of closed objects cast one only when turned to the light. */
static bool casts(const struct tia_flat_scene *flat, const tia_flat_light *light, uint32_t f, bool closed,
                  struct known_sides *known, struct caster *c)
{
    c->face = &flat->faces[f];
    int side = known_side(known, flat, light, f);

    if (side == 0 || (closed && side < 0))
        return false;
    c->sides = tia_face_sides(c->face);
    c->turned = side < 0;
    for (unsigned k = 0; k < c->sides; k++) {
        uint32_t other = flat->across[TIA_SIDES * f + k];
        c->side[k] = !closed || known_side(known, flat, light, other / TIA_SIDES) <= 0;
    }
    return true;
}

typedef int caster_function(void *ctx, const struct caster *caster, uint32_t face);

/* Calls the function for each face that casts a shadow; `work` is the number of items of work for a face, see cancel.h.
 * Returns TIA_OK, TIA_STOPPED or the function's error. */
static int for_each_caster(const struct tia_flat_scene *flat, const tia_flat_light *light, caster_function *call,
                           void *ctx, struct cancel *cancel, uint32_t work)
{
    struct known_sides known;
    int status = TIA_OK;

    for (int i = 0; i < KNOWN_SIDES; i++)
        known.face[i] = TIA_NO_FACE;
    for (uint32_t i = 0; i < flat->object_count; i++) {
        const struct tia_flat_object *object = &flat->objects[i];
        bool closed = tia_flat_has_silhouette(flat, object, light);
        if (tia_flat_hides_nothing(flat, object, light))
            continue;
        for (uint32_t n = 0; !status && n < object->face_count; n++) {
            struct caster c;
            if (cancelled(cancel, work))
                return TIA_STOPPED;
            if (casts(flat, light, object->first_face + n, closed, &known, &c))
                status = call(ctx, &c, object->first_face + n);
        }
    }
    return status;
}

/* ---- drawing ---- */

struct drawing {
    struct tia_raster_target *target;
    const struct tia_flat_scene *flat;
    const tia_flat_light *light;
    struct tia_raster_state state;
    bool near, far; /* caps to draw */
};

/* Returns the end of a corner's shadow, which is at infinity. */
static struct tia_raster_vertex shadow_of(const struct drawing *d, const struct tia_raster_vertex *v)
{
    const tia_flat_light *l = d->light;

    if (tia_flat_is_direction(d->flat, v))
        return *v;
    if (tia_flat_is_direction(d->flat, l))
        return (struct tia_raster_vertex){-l->x, -l->y, -l->w, -l->h};
    return (struct tia_raster_vertex){v->x - l->x, v->y - l->y, v->w - l->w, v->h - l->h};
}

static int draw(const struct drawing *d, const struct tia_raster_vertex *corners, unsigned count, uint32_t face)
{
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

/* Draws the caps. A polygon's plane is that of its first three corners, and only a face's first corner is certain to be
 * a point. So the reverse order begins with that corner, too. Orthographic rays never meet points at infinity. */
static int draw_caps(const struct drawing *d, const struct caster *c, uint32_t face)
{
    struct tia_raster_vertex near[TIA_SIDES], far[TIA_SIDES];
    unsigned sides = c->sides;

    for (unsigned k = 0; k < sides; k++) {
        near[k] = *corner(d->flat, c->face, c->turned ? (sides - k) % sides : k);
        far[(sides - k) % sides] = shadow_of(d, &near[k]);
    }
    int status = d->near ? draw(d, near, sides, face) : TIA_OK;
    return status || !d->far ? status : draw(d, far, sides, TIA_NO_FACE);
}

static int draw_volume(void *ctx, const struct caster *c, uint32_t face)
{
    const struct drawing *d = ctx;
    int status = draw_caps(d, c, face);

    for (unsigned k = 0; !status && k < c->sides; k++) {
        const struct tia_raster_vertex *a = corner(d->flat, c->face, k);
        const struct tia_raster_vertex *b = corner(d->flat, c->face, k + 1 < c->sides ? k + 1 : 0);
        if (c->side[k])
            status = c->turned ? draw_side(d, b, a) : draw_side(d, a, b);
    }
    return status;
}

#define KEEPS                                                                                                          \
    {                                                                                                                  \
        .test = TIA_COMPARE_ALWAYS, .mask = 255, .write = 255                                                          \
    }

/* Returns the number of items of work for a polygon, which may cover the whole target. */
static uint32_t work_of(const struct tia_raster_target *target)
{
    return 1 + (uint32_t)target->area.width * target->area.height / 512;
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
        unsigned sides = tia_flat_corners(flat, f, corners);
        if (cancelled(cancel, work_of(target)))
            return TIA_STOPPED;
        status = tia_raster_draw(target, &state, corners, sides, f);
    }
    return status;
}

/* Counts behind the point, where the ray leaves volumes through back faces and enters others through front faces. In
 * orthographic views no ray reaches the far caps, which are at infinity. */
int tia_shadow_zfail(struct tia_raster_target *target, const struct tia_flat_scene *flat, const tia_flat_light *light,
                     struct cancel *cancel)
{
    bool flat_view = flat->eye.projection == TIA_ORTHOGRAPHIC;
    struct drawing d = {target, flat,      light, {.depth = TIA_COMPARE_LESS, .front = KEEPS, .back = KEEPS},
                        true,   !flat_view};

    d.state.front.zfail = TIA_STENCIL_DECR_WRAP;
    d.state.back.zfail = TIA_STENCIL_INCR_WRAP;
    return for_each_caster(flat, light, draw_volume, &d, cancel, 4 * work_of(target));
}

/* Counts in front of the point, with opposite signs. Far caps are never in front of the point. A near cap is in front
 * of a visible face only behind the window of an orthographic view. */
int tia_shadow_zpass(struct tia_raster_target *target, const struct tia_flat_scene *flat, const tia_flat_light *light,
                     struct cancel *cancel)
{
    bool flat_view = flat->eye.projection == TIA_ORTHOGRAPHIC;
    struct drawing d = {target,    flat, light, {.depth = TIA_COMPARE_LESS, .front = KEEPS, .back = KEEPS},
                        flat_view, false};

    d.state.front.zpass = TIA_STENCIL_INCR_WRAP;
    d.state.back.zpass = TIA_STENCIL_DECR_WRAP;
    return for_each_caster(flat, light, draw_volume, &d, cancel, 4 * work_of(target));
}

/* ---- volumes at a ray's ends ---- */

struct end_count {
    const struct tia_flat_scene *flat;
    const tia_flat_light *light;
    int end; /* end of the rays: -1 is the eye; 1 is the opposite point, where all rays of an orthographic view end */
    uint32_t count;
    bool unsure;
};

/* Returns the side of an edge on which the line from the eye to the light passes: the sign of det(a, b, light, eye). If
 * all four are at infinity, the determinant is 0, and the edge belongs to a half plane. Then any result is correct that
 * is the same for both half planes. */
static int passes(const struct end_count *e, const struct tia_raster_vertex *a, const struct tia_raster_vertex *b)
{
    const int64_t p[3] = {a->x, a->y, a->w}, q[3] = {b->x, b->y, b->w};
    const int64_t l[3] = {e->light->x, e->light->y, e->light->w};

    return p[2] || q[2] || l[2] || e->flat->eye.projection != TIA_ORTHOGRAPHIC ? orientation(p, q, l) : 1;
}

/* Counts a volume if it contains the end: then the segment from the end to the light crosses the cap, that is, passes
 * all edges on the same side. If the segment meets edges and passes the others on the same side, or if the end is in
 * the cap's plane, the end is on the volume's surface. */
static int count_end(void *ctx, const struct caster *c, uint32_t face)
{
    struct end_count *e = ctx;
    int side = e->end * tia_flat_side_of_eye(e->flat, c->face) * (c->turned ? -1 : 1);
    bool left = false, right = false, met = side == 0;

    (void)face;
    for (unsigned k = 0; k < c->sides; k++) {
        int pass = passes(e, corner(e->flat, c->face, k), corner(e->flat, c->face, k + 1 < c->sides ? k + 1 : 0));
        left = left || pass > 0;
        right = right || pass < 0;
        met = met || pass == 0;
    }
    if ((left && right) || side < 0)
        return TIA_OK;
    e->unsure = e->unsure || met;
    e->count++;
    return TIA_OK;
}

bool tia_shadow_count_eye(const struct tia_flat_scene *flat, const tia_flat_light *light, uint32_t *count,
                          struct cancel *cancel)
{
    struct end_count e = {.flat = flat, .light = light, .end = -1};

    (void)for_each_caster(flat, light, count_end, &e, cancel, 1);
    *count = e.count;
    return !e.unsure;
}

bool tia_shadow_count_far(const struct tia_flat_scene *flat, const tia_flat_light *light, uint32_t *count,
                          struct cancel *cancel)
{
    struct end_count e = {.flat = flat, .light = light, .end = 1};

    if (flat->eye.projection == TIA_ORTHOGRAPHIC)
        (void)for_each_caster(flat, light, count_end, &e, cancel, 1);
    *count = e.count;
    return !e.unsure;
}
