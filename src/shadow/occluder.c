#include "occluder.h"

#include "raster/forms_wide.h"
#include "raster/halves.h"
#include "shadow_ranges.h"

#define NOTHING (-(1 << 14)) /* exponent of 0, below that of any other number */

/* Returns the mantissa m of a = m 2^exponent, |m| in 2^61..2^62, rounded towards 0. */
static int64_t mantissa(wide a, int *exponent)
{
    wide size = wide_size(a);
    int bits = wide_bits(size);

    *exponent = bits ? bits - 62 : NOTHING;
    int64_t m = bits > 62 ? wide_down(size, (unsigned)(bits - 62)) : (int64_t)(wide_low(size) << (62 - bits));
    return wide_is_negative(a) ? -m : m;
}

/* ---- visible points ---- */

static struct wide_form form_of_plane(const struct tia_raster_plane *plane)
{
    return (struct wide_form){halves_get(plane->x), halves_get(plane->y), halves_get(plane->c)};
}

void tia_seen_face_init(struct tia_seen_face *of, const struct tia_flat_scene *flat, uint32_t face)
{
    of->plane = &flat->planes[face];
    of->face = face;
    wide det = halves_get(of->plane->det);
    of->bits = wide_bits(det);
    of->reciprocal = of->bits ? wide_reciprocal((uint64_t)wide_high(wide_up(det, (unsigned)(128 - of->bits)))) : 0;
}

/* s is the product of a mantissa below 2^62 and a reciprocal of 2^62..2^63. */
void tia_seen_init(struct tia_seen *seen, const struct tia_seen_face *of, int x, int y)
{
    struct wide_form form = form_of_plane(of->plane);
    int exponent;
    int64_t m = mantissa(wide_form_at(&form, x, y), &exponent);

    *seen = (struct tia_seen){.of = of, .x = x, .y = y};
    seen->nearness = wide_down(wide_product(m, of->reciprocal), 63);
    seen->exponent = m ? exponent - of->bits + 1 : NOTHING;
}

/* ---- planes ---- */

struct plane {
    wide n[3], d;
};

static void direction_of(const struct tia_raster_vertex *v, int64_t q[3])
{
    q[0] = v->x;
    q[1] = v->y;
    q[2] = v->w;
}

static struct plane plane_through(const struct tia_raster_vertex *const v[3])
{
    wide zero = wide_product(0, 0);
    struct plane plane = {{zero, zero, zero}, zero};
    int64_t q[3][3];

    for (int i = 0; i < 3; i++)
        direction_of(v[i], q[i]);
    for (int i = 0; i < 3; i++) {
        wide normal[3];
        wide_cross(q[(i + 1) % 3], q[(i + 2) % 3], normal);
        if (i == 0)
            plane.d = wide_determinant(normal, q[0]);
        if (v[i]->h)
            wide_add_scaled(plane.n, normal, v[i]->h);
    }
    return plane;
}

/* Returns the face's own plane for k = 0, else the plane through the light and the edge from corner k - 1 to the
 * next. */
static struct plane plane_of(const struct tia_occluder *o, unsigned k)
{
    const struct tia_flat_face *face = &o->flat->faces[o->face];
    const struct tia_raster_vertex *points = o->flat->points;
    const struct tia_raster_vertex *own[3] = {&points[face->corner[0]], &points[face->corner[1]],
                                              &points[face->corner[2]]};
    const struct tia_raster_vertex *edge[3] = {o->light};

    if (k == 0)
        return plane_through(own);
    edge[1] = &points[face->corner[k - 1]];
    edge[2] = &points[face->corner[k < o->sides ? k : 0]];
    return plane_through(edge);
}

static int larger(int a, int b)
{
    return a > b ? a : b;
}

static int64_t cut(wide a, int unit)
{
    return unit ? wide_down(a, (unsigned)unit) : (int64_t)wide_low(a);
}

/* Prepares a plane for the filter. Columns and rows are below 2^13, so each of the three terms is below 2^60. */
static void prepare(struct tia_occluder_plane *p, const struct plane *plane, const struct tia_raster_grid *grid)
{
    struct wide_form form = wide_form_of(plane->n, grid);
    int bits =
        larger(larger(wide_bits(wide_size(form.x)), wide_bits(wide_size(form.y))) + 13, wide_bits(wide_size(form.c)));
    int unit = larger(bits - 60, 0), m_unit;

    p->x = cut(form.x, unit);
    p->y = cut(form.y, unit);
    p->c = cut(form.c, unit);
    p->m = mantissa(plane->d, &m_unit);
    p->unit = (int16_t)unit;
    p->m_unit = (int16_t)m_unit;
    p->unsure = OCCLUDER_UNSURE + (unit ? OCCLUDER_CUT : 0);
}

/* ---- sides ---- */

/* Returns the sign of M.D - m s, or 0 when the filter cannot decide. */
static int sure_side(const struct tia_occluder_plane *p, const struct tia_seen *seen)
{
    int64_t a = p->c + p->x * seen->x + p->y * seen->y, b = wide_down(wide_product(p->m, seen->nearness), 62);
    int finer = p->m_unit + seen->exponent + 62 - p->unit;

    if (finer >= 0)
        a >>= finer < 63 ? finer : 63;
    else
        b >>= finer > -63 ? -finer : 63;
    return a - b > p->unsure ? 1 : a - b < -p->unsure ? -1 : 0;
}

/* Returns the exact sign of M.D - m s, with ties broken as in occluder.h; 0: the two planes are equal. */
static int exact_side(const struct tia_occluder *o, unsigned k, const struct tia_seen *seen)
{
    struct plane plane = plane_of(o, k);
    struct wide_form a = wide_form_of(plane.n, &o->flat->grid), b = form_of_plane(seen->of->plane);
    wide det = halves_get(seen->of->plane->det);
    int side =
        wide_order_of_products(wide_form_at(&a, seen->x, seen->y), det, plane.d, wide_form_at(&b, seen->x, seen->y));

    if (!side)
        side = wide_order_of_products(a.x, det, plane.d, b.x);
    if (!side)
        side = wide_order_of_products(a.y, det, plane.d, b.y);
    return side;
}

static int side_of(const struct tia_occluder *o, unsigned k, const struct tia_seen *seen)
{
    int side = sure_side(&o->plane[k], seen);

    return side ? side : exact_side(o, k, seen);
}

/* Returns the side of the face's plane on which the light is: 1, -1, or 0 in the plane. */
static int side_of_light(const struct plane *own, const tia_flat_light *light)
{
    int64_t q[3];

    direction_of(light, q);
    return wide_sign(wide_difference(wide_determinant(own->n, q), wide_times(own->d, light->h)));
}

bool tia_occluder_init(struct tia_occluder *o, const struct tia_flat_scene *flat, const tia_flat_light *light,
                       uint32_t face)
{
    o->flat = flat;
    o->light = light;
    o->face = face;
    o->flush = TIA_NO_FACE;
    o->sides = tia_face_sides(&flat->faces[face]);
    struct plane plane = plane_of(o, 0);
    o->side = -side_of_light(&plane, light);
    if (!o->side)
        return false;
    prepare(&o->plane[0], &plane, &flat->grid);
    o->ready = 1;
    return true;
}

void tia_occluder_ready(struct tia_occluder *o, unsigned k)
{
    if (k < o->ready)
        return;
    struct plane plane = plane_of(o, k);
    prepare(&o->plane[k], &plane, &o->flat->grid);
    o->ready = k + 1;
}

bool tia_occluder_hides(struct tia_occluder *o, const struct tia_seen *seen)
{
    if (!o->side || seen->of->face == o->face || seen->of->face == o->flush)
        return false;
    int side = side_of(o, 0, seen);
    if (!side)
        o->flush = seen->of->face;
    if (side != o->side)
        return false;
    for (unsigned k = 1; k <= o->sides; k++) {
        tia_occluder_ready(o, k);
        if (side_of(o, k, seen) != o->side)
            return false;
    }
    return true;
}
