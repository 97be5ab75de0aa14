/* facets.c - the points and faces of a divided shape.
 *
 * Point 0 of a sphere is the lowest, point 1 the highest; then come its rings, upwards. The points of all other shapes
 * are the centres of their ends, then the corners of each end that is not a point. Seen from outside with the axis
 * upwards, the next corner of a ring is to the right. */
#include "facets.h"

#include "eye.h"
#include "math/rotation.h"
#include "math/wide.h"

/* ---- in the shape's own axes ---- */

/* Returns a length with its fine digits, Q31.32. */
static int64_t finely(tia_q16 a, int16_t digits)
{
    return a * INT64_C(65536) + digits;
}

static void place(struct tia_vec3 p, const struct tia_fine_place *fine, int64_t out[3])
{
    out[0] = finely(p.x, fine ? fine->x : 0);
    out[1] = finely(p.y, fine ? fine->y : 0);
    out[2] = finely(p.z, fine ? fine->z : 0);
}

static void set_ends(struct tia_facet_shape *f, struct tia_vec3 base, struct tia_vec3 top, const tia_q16 radius[2],
                     const struct tia_fine_ends *fine)
{
    int64_t along[3], axis[3];

    place(base, fine ? &fine->base : NULL, f->centre[0]);
    place(top, fine ? &fine->top : NULL, f->centre[1]);
    for (int i = 0; i < 2; i++) {
        int16_t digits = !fine ? 0 : i && f->kind == TIA_CONE ? fine->top_radius : fine->base_radius;
        f->radius[i] = radius[i] ? finely(radius[i], digits) : 0;
    }
    for (int k = 0; k < 3; k++)
        along[k] = f->centre[1][k] - f->centre[0][k];
    (void)wide_normalise(along, axis);
    tia_eye_across(axis, f->across);
}

static void set_disc(struct tia_facet_shape *f, const struct tia_disc *disc)
{
    const int64_t given[3] = {disc->normal.x, disc->normal.y, disc->normal.z};
    int64_t normal[3];

    place(disc->centre, NULL, f->centre[0]);
    f->radius[0] = finely(disc->radius, 0);
    (void)wide_normalise(given, normal);
    tia_eye_across(normal, f->across);
}

static void set_shape(struct tia_facet_shape *f, const struct tia_shape *s, const struct tia_fine_ends *fine)
{
    tia_q16 radius[2];

    switch (s->kind) {
    case TIA_SPHERE:
        place(s->sphere.centre, NULL, f->centre[0]);
        f->radius[0] = finely(s->sphere.radius, 0);
        break;
    case TIA_DISC:
        set_disc(f, &s->disc);
        break;
    case TIA_CYLINDER:
        f->capped = s->cylinder.capped;
        radius[0] = radius[1] = s->cylinder.radius;
        set_ends(f, s->cylinder.base, s->cylinder.top, radius, fine);
        break;
    default:
        f->capped = s->cone.capped;
        radius[0] = s->cone.base_radius;
        radius[1] = s->cone.top_radius;
        set_ends(f, s->cone.base, s->cone.top, radius, fine);
    }
}

void tia_facet_shape_init(struct tia_facet_shape *f, const struct tia_scene *scene, uint32_t object)
{
    const struct tia_fine *fine = scene->fine;
    struct tia_facets facets;

    (void)tia_facets_of(scene, object, &facets);
    *f = (struct tia_facet_shape){.around = facets.around};
    if (object < scene->sphere_count) {
        const struct tia_sphere *s = &scene->spheres[object];
        f->kind = TIA_SPHERE;
        place(s->centre, fine ? &fine->spheres[object].centre : NULL, f->centre[0]);
        f->radius[0] = finely(s->radius, fine ? fine->spheres[object].radius : 0);
        return;
    }
    const struct tia_shape *s = &scene->shapes[object - scene->sphere_count];
    f->kind = s->kind;
    set_shape(f, s, fine && !s->transform ? &fine->shapes[object - scene->sphere_count] : NULL);
}

/* ---- points ---- */

/* Returns n/around of a full turn, in degrees. */
static tia_q16 turn(uint32_t n, uint32_t around)
{
    return (tia_q16)(((uint64_t)n * (uint32_t)TIA_Q16(360) + around / 2) / around);
}

/* Gives the direction from a sphere's centre to point i: the poles are along y, and the corners of a ring run from z
 * towards x. */
static void sphere_direction(uint32_t i, uint32_t around, int64_t d[3])
{
    uint32_t ring = (i - 2) / around + 1;
    int64_t sine, cosine, aside[2];

    tia_sincos(turn((i - 2) % around, around), &aside[1], &aside[0]);
    tia_sincos(turn(ring, around) - TIA_Q16(90), &sine, &cosine);
    d[0] = wide_round(wide_product(aside[1], cosine), 62);
    d[1] = sine;
    d[2] = wide_round(wide_product(aside[0], cosine), 62);
}

void tia_facet_point(const struct tia_facet_shape *f, uint32_t i, int64_t point[3])
{
    const uint32_t centres = f->kind == TIA_DISC ? 1 : 2;
    int64_t d[3] = {0, 0, 0};
    unsigned end = 0;

    if (f->kind == TIA_SPHERE && i < 2)
        d[1] = i ? INT64_C(1) << 62 : -(INT64_C(1) << 62);
    else if (f->kind == TIA_SPHERE)
        sphere_direction(i, f->around, d);
    else if (i < centres)
        end = (unsigned)i;
    else {
        end = (unsigned)((i - centres) / f->around) + (f->radius[0] == 0);
        tia_eye_around(f->across[0], f->across[1], turn((i - centres) % f->around, f->around), d);
    }
    for (int k = 0; k < 3; k++)
        point[k] = f->centre[end][k] + wide_round(wide_product(f->radius[end], d[k]), 62);
}

/* ---- faces ---- */

static struct tia_flat_face triangle(uint32_t a, uint32_t b, uint32_t c)
{
    return (struct tia_flat_face){{a, b, c, TIA_NO_CORNER}};
}

/* Returns a triangle of the quadrilateral between corners k and k + 1 of two rings: the lower one or, if `half`, the
 * upper one. */
static struct tia_flat_face between(uint32_t low, uint32_t high, uint32_t k, uint32_t around, bool half)
{
    uint32_t next = (k + 1) % around;

    return half ? triangle(low + k, high + next, high + k) : triangle(low + k, low + next, high + next);
}

/* Returns the triangle of a point and corners k and k + 1 of a ring above it or below it. */
static struct tia_flat_face fan(uint32_t point, uint32_t ring, uint32_t k, uint32_t around, bool above)
{
    uint32_t next = (k + 1) % around;

    return above ? triangle(point, ring + next, ring + k) : triangle(point, ring + k, ring + next);
}

static struct tia_flat_face sphere_face(uint32_t i, uint32_t n)
{
    uint32_t rest = i - 2 * n;

    if (i < n)
        return fan(0, 2, i, n, true);
    if (i < 2 * n)
        return fan(1, 2 + n * (n / 2 - 2), i - n, n, false);
    uint32_t low = 2 + rest / (2 * n) * n;
    return between(low, low + n, rest / 2 % n, n, rest % 2);
}

struct tia_flat_face tia_facet_face(const struct tia_facet_shape *f, uint32_t i)
{
    bool base = f->radius[0] != 0, top = f->radius[1] != 0;
    uint32_t n = f->around, high = base ? 2 + n : 2, parts[2];

    tia_facet_parts(f, parts);
    if (f->kind == TIA_SPHERE)
        return sphere_face(i, n);
    if (f->kind == TIA_DISC)
        return fan(0, 1, i, n, false);
    if (i >= parts[0] + parts[1])
        return fan(1, high, i - parts[0] - parts[1], n, false);
    if (i >= parts[0])
        return fan(0, 2, i - parts[0], n, true);
    if (base && top)
        return between(2, high, i / 2, n, i % 2);
    return base ? fan(1, 2, i, n, false) : fan(0, high, i, n, true);
}

void tia_facet_parts(const struct tia_facet_shape *f, uint32_t parts[2])
{
    bool base = f->radius[0] != 0, top = f->radius[1] != 0;

    parts[0] = f->kind == TIA_SPHERE ? UINT32_MAX : base && top ? 2 * f->around : f->around;
    parts[1] = base && f->capped ? f->around : 0;
}
