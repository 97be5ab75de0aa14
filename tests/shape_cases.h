/* shape_cases.h - planes, discs, cylinders and cones, see shape_check.h. */
#include "shape_check.h"

static void tangents_of(struct vec n, struct vec *u, struct vec *v)
{
    bool level = !(size(n.x) > 0) && !(size(n.z) > 0);

    *u = level ? (struct vec){1, 0, 0} : unit((struct vec){n.z, 0, -n.x});
    *v = cross(n, *u);
}

static struct tia_dir3 any_normal(void)
{
    struct vec v = any_direction();
    double s = between(0.6, 1.4) * 0x1p30;

    return (struct tia_dir3){(tia_q30)(s * (double)v.x), (tia_q30)(s * (double)v.y), (tia_q30)(s * (double)v.z)};
}

static struct vec normal_of(struct tia_dir3 n)
{
    return unit((struct vec){n.x, n.y, n.z});
}

/* ---- planes and discs: a plane is a disc of radius 0 ---- */
struct flat {
    struct vec point, normal, u, v;
    real radius;
};

static real farthest(struct vec p)
{
    return most(size(p.x), most(size(p.y), size(p.z)));
}

static real flat_margin(const struct flat *f, struct vec p)
{
    return f->radius > 0 ? f->radius - length(add(p, -1, f->point)) : 65536 - farthest(p);
}

static int flat_candidates(const struct subject *s, struct vec o, struct vec d, struct candidate found[])
{
    const struct flat *f = s->what;
    real slope = dot(d, f->normal), t = dot(add(f->point, -1, o), f->normal) / slope;

    if (size(slope) < (real)0x1p-41)
        return 0;
    found[0] = (struct candidate){t, flat_margin(f, add(o, t, d)), 1, 0, f->normal};
    return 1;
}

static real flat_distance(const struct subject *s, struct vec p, uint32_t element)
{
    const struct flat *f = s->what;

    return element != 0 ? 1e9L : most(size(dot(add(p, -1, f->point), f->normal)), -flat_margin(f, p));
}

static struct vec flat_normal(const struct subject *s, struct vec p, uint32_t element)
{
    (void)p;
    (void)element;
    return ((const struct flat *)s->what)->normal;
}

static void flat_coordinates(const struct subject *s, struct vec p, uint32_t element, real uv[2])
{
    const struct flat *f = s->what;
    struct vec v = add(p, -1, f->point);

    (void)element;
    uv[0] = dot(v, f->u);
    uv[1] = dot(v, f->v);
    for (int i = 0; i < 2 && f->radius > 0; i++)
        uv[i] = (1 + uv[i] / f->radius) / 2;
}

static real flat_curvature(const struct subject *s, struct vec p, uint32_t element)
{
    const struct flat *f = s->what;

    (void)p;
    (void)element;
    return f->radius > 0 ? 1 / f->radius : 0;
}

static void check_flat(double radius, double far)
{
    struct tia_disc disc = {any_place(far), any_normal(), (tia_q16)(radius * 65536)};
    struct tia_plane plane = {disc.centre, disc.normal};
    struct flat f = {position(disc.centre), normal_of(disc.normal), {0, 0, 0}, {0, 0, 0}, disc.radius / 65536.0};
    struct subject s = {.what = &f,
                        .candidates = flat_candidates,
                        .distance = flat_distance,
                        .normal = flat_normal,
                        .uv = flat_coordinates,
                        .curvature = flat_curvature};

    tangents_of(f.normal, &f.u, &f.v);
    s.extent = length(f.point) + f.radius;
    if (radius > 0)
        PREPARE(&s.shape, TIA_DISC, disc, disc);
    else
        PREPARE(&s.shape, TIA_PLANE, plane, plane);
    double inside = radius > 0 ? radius : 60000 - far;
    for (int i = 0; i < 6; i++) {
        struct vec across = any_across(f.normal);
        double edge = i < 3 ? between(0, 1) : 1 + (chance() < 0 ? -1 : 1) * exp2(between(-40, -3));
        check_rays_through(&s, add(f.point, inside * edge, across), f.normal, radius > 0 ? radius : 100);
    }
}

/* ---- cylinders and cones ---- */
struct cone {
    struct vec base, axis, u, v;
    real length, base_radius, top_radius, slant; /* slant: length of the side */
    bool capped;
};

static real height_of(const struct cone *c, struct vec p)
{
    return dot(add(p, -1, c->base), c->axis);
}

static real aside_of(const struct cone *c, struct vec p)
{
    struct vec v = add(p, -1, c->base);

    return length(add(v, -dot(v, c->axis), c->axis));
}

static real radius_at(const struct cone *c, real height)
{
    return c->base_radius + (c->top_radius - c->base_radius) * height / c->length;
}

/* Returns the distance of p from the side, positive inside the shape. */
static real depth_of(const struct cone *c, struct vec p)
{
    return (radius_at(c, height_of(c, p)) - aside_of(c, p)) * c->length / c->slant;
}

static struct vec cone_normal(const struct subject *s, struct vec p, uint32_t element)
{
    const struct cone *c = s->what;
    struct vec v = add(p, -1, c->base), out = add(v, -dot(v, c->axis), c->axis);

    if (element != 0)
        return add((struct vec){0, 0, 0}, element == 1 ? -1 : 1, c->axis);
    if (length(out) > 0)
        out = unit(out);
    return unit(add(out, (c->base_radius - c->top_radius) / c->length, c->axis));
}

static int cap_candidate(const struct subject *s, uint32_t element, struct vec o, struct vec d, struct candidate *found)
{
    const struct cone *c = s->what;
    real radius = element == 1 ? c->base_radius : c->top_radius, rise = dot(d, c->axis);
    real t = ((element == 1 ? 0 : c->length) - height_of(c, o)) / rise;

    if (!c->capped || radius <= 0 || size(rise) < (real)0x1p-41)
        return 0;
    *found = (struct candidate){t, depth_of(c, add(o, t, d)), 1, element, cone_normal(s, o, element)};
    return 1;
}

/* Finds the hits on the side by the quadratic |v|^2 - z^2 = (r + k z)^2, relative to the ray's point nearest to the
 * base. */
static int side_candidates(const struct subject *s, struct vec o, struct vec d, struct candidate found[])
{
    const struct cone *c = s->what;
    real shift = dot(add(c->base, -1, o), d) / dot(d, d), k = (c->top_radius - c->base_radius) / c->length;
    struct vec v = add(add(o, shift, d), -1, c->base);
    real z = dot(v, c->axis), dz = dot(d, c->axis), r = c->base_radius + k * z, dr = k * dz;
    real qa = dot(d, d) - dz * dz - dr * dr, qb = dot(v, d) - z * dz - r * dr, qc = dot(v, v) - z * z - r * r;
    real under = qb * qb - qa * qc, q = -(qb + (qb < 0 ? -1 : 1) * root(under));
    real t[2] = {qc / q, q / qa}, depth;
    int count = 0;

    if (under < 0 || q == 0 || qa == 0)
        return 0;
    depth = qa > 0 ? depth_of(c, add(add(o, shift, d), (t[0] + t[1]) / 2, d)) : 1e9L;
    for (int i = 0; i < 2; i++) {
        struct vec p = add(add(o, shift, d), t[i], d);
        real height = height_of(c, p), margin = least(height, c->length - height);
        found[count++] = (struct candidate){shift + t[i], margin, depth, 0, cone_normal(s, p, 0)};
    }
    return count;
}

static int cone_candidates(const struct subject *s, struct vec o, struct vec d, struct candidate found[])
{
    int count = side_candidates(s, o, d, found);

    count += cap_candidate(s, 1, o, d, &found[count]);
    return count + cap_candidate(s, 2, o, d, &found[count]);
}

static real cone_distance(const struct subject *s, struct vec p, uint32_t element)
{
    const struct cone *c = s->what;
    real height = height_of(c, p), beyond = most(-height, height - c->length);

    if (element > (c->capped ? 2 : 0) || (element == 1 && c->base_radius <= 0) || (element == 2 && c->top_radius <= 0))
        return 1e9L; /* an apex has no cap */
    if (element == 0)
        return most(size(depth_of(c, p)), beyond);
    return most(size(element == 1 ? height : height - c->length), -depth_of(c, p));
}

static void cone_coordinates(const struct subject *s, struct vec p, uint32_t element, real uv[2])
{
    const struct cone *c = s->what;
    struct vec v = add(p, -1, c->base), right = c->u, up = c->v;

    if (element == 0) {
        long double y = (long double)-dot(v, up), x = (long double)dot(v, right);
        uv[0] = (real)(0.5L - atan2l(y, x) / (2 * acosl(-1)));
        uv[1] = dot(v, c->axis) / c->length;
        return;
    }
    if (element == 1)
        tangents_of((struct vec){-c->axis.x, -c->axis.y, -c->axis.z}, &right, &up);
    real radius = element == 1 ? c->base_radius : c->top_radius;
    uv[0] = (1 + dot(v, right) / radius) / 2;
    uv[1] = (1 + dot(v, up) / radius) / 2;
}

static real cone_curvature(const struct subject *s, struct vec p, uint32_t element)
{
    const struct cone *c = s->what;
    real aside = aside_of(c, p);

    if (element == 0)
        return most(1 / (aside > (real)1e-30 ? aside : (real)1e-30), 1 / c->length);
    return 1 / (element == 1 ? c->base_radius : c->top_radius);
}

static void prepare_cone(struct subject *s, struct cone *c, const struct tia_cone *cone)
{
    const struct tia_cylinder cylinder = {cone->base, cone->top, cone->base_radius, cone->capped};
    struct vec along = add(position(cone->top), -1, position(cone->base));

    *c = (struct cone){.base = position(cone->base), .axis = unit(along), .length = length(along)};
    tangents_of(c->axis, &c->u, &c->v);
    c->base_radius = cone->base_radius / 65536.0;
    c->top_radius = cone->top_radius / 65536.0;
    real step = c->base_radius - c->top_radius;
    c->slant = root(c->length * c->length + step * step);
    c->capped = cone->capped;
    *s = (struct subject){.what = c,
                          .candidates = cone_candidates,
                          .distance = cone_distance,
                          .normal = cone_normal,
                          .uv = cone_coordinates,
                          .curvature = cone_curvature};
    s->extent = length(c->base) + c->length + most(c->base_radius, c->top_radius);
    if (cone->base_radius == cone->top_radius)
        PREPARE(&s->shape, TIA_CYLINDER, cylinder, cylinder);
    else
        PREPARE(&s->shape, TIA_CONE, cone, *cone);
}

static void check_cone(struct tia_cone cone)
{
    struct subject s;
    struct cone c;

    prepare_cone(&s, &c, &cone);
    double scale = (double)least(c.length, most(c.base_radius, c.top_radius));
    for (int i = 0; i < 8; i++) { /* points on the side and on the ends; also slightly inside and outside of the edges
                                     between them */
        struct vec out = any_across(c.axis);
        double edge = i < 3 ? between(0, 1) : (i & 1) + chance() * exp2(between(-40, -3));
        struct vec p = add(c.base, c.length * edge, c.axis);
        check_rays_through(&s, add(p, most(radius_at(&c, c.length * edge), 0), out), cone_normal(&s, add(p, 1, out), 0),
                           scale);
        uint32_t end = 1 + (i & 1);
        real radius = end == 1 ? c.base_radius : c.top_radius;
        edge = i < 3 ? between(0, 1) : 1 + chance() * exp2(between(-40, -3));
        p = add(c.base, end == 1 ? 0 : c.length, c.axis);
        check_rays_through(&s, add(p, radius * edge, out), cone_normal(&s, p, end), scale);
        check_ray(&s, add(add(p, radius * edge, out), chance() * 3 * c.length, c.axis), c.axis, 131072);
    }
}

/* Checks rays to the apex, where there would be a cap of radius 0. */
static void check_apex(struct tia_cone cone)
{
    struct subject s;
    struct cone c;

    cone.capped = true;
    prepare_cone(&s, &c, &cone);
    struct vec apex = add(c.base, c.top_radius > 0 ? 0 : c.length, c.axis);
    for (int i = 0; i < 200; i++) {
        struct vec d = any_direction();
        check_ray(&s, add(apex, -any_length(0x1p-10, 10000), d), d, 131072);
    }
}

/* Returns a cone with a random base, and an axis of length `longest` in a random direction. */
static struct tia_cone any_cone(double far, double longest, double base_radius, double top_radius)
{
    struct tia_vec3 base = any_place(far);
    struct vec d = any_direction(), top = add(position(base), longest, d);
    tia_q16 radii[2] = {(tia_q16)(base_radius * 65536), (tia_q16)(top_radius * 65536)};

    return (struct tia_cone){base,
                             {(tia_q16)(top.x * 65536), (tia_q16)(top.y * 65536), (tia_q16)(top.z * 65536)},
                             radii[0],
                             radii[1],
                             chance() < 0};
}
