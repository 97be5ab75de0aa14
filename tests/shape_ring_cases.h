/* shape_ring_cases.h - tori and rounded boxes, see shape_check.h.
 *
 * Of both the distance of a point from the surface is known in closed form. Where it is below 0 along a line is found
 * by halving between the points where it is least, which are found in other ways than by the code that is tested: on a
 * torus by Cardano's formulas, on a rounded box, which is convex, by trisection. */
#include "shape_check.h"

/* A shape with its distance function; `size` is the radius of a ball around the centre with the shape inside. */
struct closed {
    real (*depth)(const void *shape, struct vec p); /* distance from the surface, positive inside */
    struct vec (*normal)(const void *shape, struct vec p);
    const void *shape;
    struct vec centre;
    real size;
};

/* Returns the t between a and b where the depth changes its sign. */
static real change_between(const struct closed *c, struct vec o, struct vec d, real a, real b)
{
    bool inside = c->depth(c->shape, add(o, a, d)) > 0;

    for (int i = 0; i < 130; i++) {
        real middle = (a + b) / 2;
        if ((c->depth(c->shape, add(o, middle, d)) > 0) == inside)
            a = middle;
        else
            b = middle;
    }
    return (a + b) / 2;
}

/* Adds the changes of sign between points on the line. The depth of each is that of the part of the line inside it or
 * outside of it, the smaller. */
static int changes_between(const struct closed *c, struct vec o, struct vec d, const real at[], int count,
                           struct candidate found[])
{
    int n = 0;

    for (int i = 0; i + 1 < count; i++) {
        real here = c->depth(c->shape, add(o, at[i], d)), there = c->depth(c->shape, add(o, at[i + 1], d));
        if ((here > 0) == (there > 0))
            continue;
        real t = change_between(c, o, d, at[i], at[i + 1]);
        found[n++] = (struct candidate){t, 1e9L, least(size(here), size(there)), 0, c->normal(c->shape, add(o, t, d))};
    }
    return n;
}

/* Returns the t of the line's point nearest to the centre. */
static real nearest_to(const struct closed *c, struct vec o, struct vec d)
{
    return dot(add(c->centre, -1, o), d) / dot(d, d);
}

/* ---- tori ---- */
struct ring {
    struct vec centre, axis, u, v;
    real major, minor;
};

/* Returns the point's components across the axis, and its height. */
static struct vec aside_of_ring(const struct ring *r, struct vec p, real *height)
{
    struct vec v = add(p, -1, r->centre);

    *height = dot(v, r->axis);
    return add(v, -*height, r->axis);
}

static real ring_depth(const void *what, struct vec p)
{
    const struct ring *r = what;
    real z, aside = length(aside_of_ring(r, p, &z)) - r->major;

    return r->minor - root(aside * aside + z * z);
}

static struct vec ring_normal_at(const void *what, struct vec p)
{
    const struct ring *r = what;
    real z;
    struct vec out = unit(aside_of_ring(r, p, &z));

    return unit(add(add(p, -1, r->centre), -r->major, out));
}

static struct vec ring_normal(const struct subject *s, struct vec p, uint32_t element)
{
    (void)element;
    return ring_normal_at(s->what, p);
}

static real closed_distance(real depth, uint32_t element)
{
    return element != 0 ? 1e9L : size(depth);
}

static real ring_distance(const struct subject *s, struct vec p, uint32_t element)
{
    return closed_distance(ring_depth(s->what, p), element);
}

static void ring_coordinates(const struct subject *s, struct vec p, uint32_t element, real uv[2])
{
    const struct ring *r = s->what;
    real z;
    struct vec out = aside_of_ring(r, p, &z);
    long double turn = 2 * acosl(-1);

    (void)element;
    uv[0] = (real)(0.5L - atan2l((long double)-dot(out, r->v), (long double)dot(out, r->u)) / turn);
    uv[1] = (real)(0.5L + atan2l((long double)z, (long double)(length(out) - r->major)) / turn);
}

static real ring_curvature(const struct subject *s, struct vec p, uint32_t element)
{
    const struct ring *r = s->what;

    (void)p;
    (void)element;
    return 1 / least(r->minor, r->major - r->minor);
}

/* Gives the real roots of t^3 + p t + q in ascending order; returns their number. */
static int cubic_roots(long double p, long double q, real t[3])
{
    long double under = q * q / 4 + p * p * p / 27;

    if (under >= 0) {
        long double a = -q / 2 + (q > 0 ? -1 : 1) * sqrtl(under), b = cbrtl(a);
        t[0] = (real)(fabsl(b) > 0 ? b - p / 3 / b : 0);
        return 1;
    }
    long double r = 2 * sqrtl(-p / 3), c = 3 * q / p / r;
    long double angle = acosl(c > 1 ? 1 : c < -1 ? -1 : c) / 3, third = 2 * acosl(-1) / 3;
    for (int i = 0; i < 3; i++)
        t[2 - i] = (real)(r * cosl(angle - third * i));
    if (t[1] > t[2] || t[0] > t[1]) { /* the cosines of a, a - 120 and a - 240 degrees, a in 0..60 */
        real middle = t[0];
        t[0] = t[1];
        t[1] = middle;
    }
    return 3;
}

static int ring_candidates(const struct subject *s, struct vec o, struct vec d, struct candidate found[])
{
    const struct ring *r = s->what;
    const struct closed c = {ring_depth, ring_normal_at, r, r->centre, (r->major + r->minor) * 2};
    real start = nearest_to(&c, o, d), h, at[5] = {start - c.size}, speed = length(d);
    struct vec from = add(o, start, d), p = add(from, -1, r->centre);

    (void)aside_of_ring(r, from, &h);
    real e = dot(d, r->axis) / speed, bulk = dot(p, p) + r->major * r->major - r->minor * r->minor;
    real square = r->major * r->major;
    int count = cubic_roots((long double)(bulk - 2 * square * (1 - e * e)), (long double)(2 * square * h * e), &at[1]);
    for (int i = 1; i <= count; i++)
        at[i] = start + at[i] / speed;
    at[count + 1] = start + c.size;
    return changes_between(&c, o, d, at, count + 2, found);
}

static void prepare_ring(struct subject *s, struct ring *r, const struct tia_torus *torus)
{
    *r = (struct ring){.centre = position(torus->centre), .axis = normal_of(torus->axis)};
    r->major = torus->major / 65536.0;
    r->minor = torus->minor / 65536.0;
    tangents_of(r->axis, &r->u, &r->v);
    *s = (struct subject){.what = r,
                          .closes = true,
                          .candidates = ring_candidates,
                          .distance = ring_distance,
                          .normal = ring_normal,
                          .uv = ring_coordinates,
                          .curvature = ring_curvature};
    s->extent = length(r->centre) + r->major + r->minor;
    PREPARE(&s->shape, TIA_TORUS, torus, *torus);
}

/* Returns the point of the surface at an angle around the tube, in the direction `out` from the axis. */
static struct vec point_of_ring(const struct ring *r, struct vec out, double angle)
{
    struct vec p = add(r->centre, r->major + r->minor * (real)cos(angle), out);

    return add(p, r->minor * (real)sin(angle), r->axis);
}

/* Checks rays in planes and lines of symmetry, which meet the torus four times or touch it along a circle. */
static void check_even_rays(const struct subject *s, const struct ring *r)
{
    struct vec out = any_across(r->axis), side = cross(r->axis, out);
    real radii[] = {r->major + r->minor, r->major, r->major - r->minor, 0};

    for (int i = 0; i < 4; i++)
        for (int k = -1; k < 2; k++) {
            struct vec p = add(add(r->centre, radii[i] * (1 + k * (real)exp2(between(-50, -3))), out),
                               k * r->minor * (real)between(0.9, 1), r->axis);
            real far = r->major * (real)any_length(0.5, 30) + r->minor;
            far = far < 30000 ? far : 30000;
            check_ray(s, add(p, -far, side), side, 131072);
            check_ray(s, add(p, -far, out), out, 131072);
            check_ray(s, add(p, -far, r->axis), r->axis, 131072);
        }
}

static void check_ring(double far, double major, double minor)
{
    struct tia_torus torus = {any_place(far), any_normal(), (tia_q16)(major * 65536), (tia_q16)(minor * 65536)};
    struct subject s;
    struct ring r;

    prepare_ring(&s, &r, &torus);
    for (int i = 0; i < 12; i++) {
        struct vec p = point_of_ring(&r, any_across(r.axis), i < 4 ? i * acos(0) : 3.2 * chance());
        check_rays_through(&s, p, ring_normal_at(&r, p), i & 1 ? minor : major);
    }
    check_even_rays(&s, &r);
}

/* ---- rounded boxes ---- */
struct cushion {
    struct box box; /* without rounding */
    real radius;
};

/* Returns the point relative to the nearest of the inner box. */
static struct vec cushion_excess(const struct cushion *c, struct vec p)
{
    real out[3];

    for (int i = 0; i < 3; i++) {
        real low = c->box.min[i] + c->radius, high = c->box.max[i] - c->radius, x = part(p, i);
        out[i] = x < low ? x - low : x > high ? x - high : 0;
    }
    return (struct vec){out[0], out[1], out[2]};
}

static real cushion_depth(const void *what, struct vec p)
{
    const struct cushion *c = what;

    return c->radius - length(cushion_excess(c, p));
}

static struct vec cushion_normal_at(const void *what, struct vec p)
{
    return unit(cushion_excess(what, p));
}

static struct vec cushion_normal(const struct subject *s, struct vec p, uint32_t element)
{
    (void)element;
    return cushion_normal_at(s->what, p);
}

static real cushion_distance(const struct subject *s, struct vec p, uint32_t element)
{
    return closed_distance(cushion_depth(s->what, p), element);
}

static void cushion_coordinates(const struct subject *s, struct vec p, uint32_t element, real uv[2])
{
    const struct cushion *c = s->what;
    struct vec out = cushion_excess(c, p);
    int axis = 0;

    (void)element;
    for (int i = 1; i < 3; i++)
        axis = size(part(out, i)) > size(part(out, axis)) ? i : axis;
    face_coordinates(&c->box, p, 2 * (uint32_t)axis + (part(out, axis) > 0), uv);
}

static real cushion_curvature(const struct subject *s, struct vec p, uint32_t element)
{
    (void)p;
    (void)element;
    return 1 / ((const struct cushion *)s->what)->radius;
}

static int cushion_candidates(const struct subject *s, struct vec o, struct vec d, struct candidate found[])
{
    const struct cushion *b = s->what;
    struct vec low = {b->box.min[0], b->box.min[1], b->box.min[2]},
               high = {b->box.max[0], b->box.max[1], b->box.max[2]};
    struct closed c = {cushion_depth, cushion_normal_at, b, add(low, 1, high), length(add(high, -1, low))};
    struct vec middle = add((struct vec){0, 0, 0}, 0.5L, c.centre);

    c.centre = middle;
    real start = nearest_to(&c, o, d), near = start - c.size, far = start + c.size;
    for (int i = 0; i < 200; i++) {
        real a = near + (far - near) / 3, e = far - (far - near) / 3;
        if (cushion_depth(b, add(o, a, d)) < cushion_depth(b, add(o, e, d)))
            near = a;
        else
            far = e;
    }
    const real at[3] = {start - c.size, (near + far) / 2, start + c.size};
    return changes_between(&c, o, d, at, 3, found);
}

static void check_cushion(double far, double smallest, double largest, double share)
{
    struct tia_vec3 min = any_place(far), max = min;
    struct cushion c;
    struct subject s = {.what = &c,
                        .candidates = cushion_candidates,
                        .distance = cushion_distance,
                        .normal = cushion_normal,
                        .uv = cushion_coordinates,
                        .curvature = cushion_curvature};
    tia_q16 edge[3], radius;

    for (int i = 0; i < 3; i++)
        edge[i] = (tia_q16)(any_length(smallest, largest) * 65536);
    max = (struct tia_vec3){min.x + edge[0], min.y + edge[1], min.z + edge[2]};
    radius = edge[0] < edge[1] ? edge[0] : edge[1];
    radius = (tia_q16)((radius < edge[2] ? radius : edge[2]) * share / 2);
    radius = radius < TIA_RADIUS_MIN ? TIA_RADIUS_MIN : radius;
    for (int i = 0; i < 3; i++) {
        c.box.min[i] = part(position(min), i);
        c.box.max[i] = part(position(max), i);
    }
    c.radius = radius / 65536.0;
    s.extent = length(position(min)) + length(position(max));
    PREPARE(&s.shape, TIA_ROUNDED, rounded, {min, max, radius});
    for (uint32_t i = 0; i < 18; i++) {
        struct vec p = any_of_face(&c.box, i % 6, i > 8), out = cushion_excess(&c, p);
        p = length(out) > 0 ? add(add(p, -1, out), c.radius, unit(out)) : p;
        check_rays_through(&s, p, unit(out), i & 1 ? (double)c.radius : smallest);
    }
}
