/* shape_check.h - tests a shape of src/render/geometry, in the arithmetic for which it is compiled, against formulas
 * computed with 113 bits.
 *
 * The formulas give a list of candidates for the hits of a ray on a shape. A candidate has two distances from not being
 * a hit: its margin, the distance from the shape's edge, and its depth, the distance that the ray enters before it
 * leaves again. Of the candidates for which both are larger than the arithmetic's error, the nearest must be found.
 * Every hit that is found must lie on the shape. So only cases within rounding errors are left open. An error e of a
 * surface's position becomes e/|D.N| along the ray. */
#ifndef TESTS_SHAPE_CHECK_H
#define TESTS_SHAPE_CHECK_H

#include <math.h>

#include "check.h"
#include "prepared.h"
#include "random.h"

#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 real;
#else
typedef long double real;
#endif

struct vec {
    real x, y, z;
};

static inline real root(real a)
{
    real r = sqrtl((long double)a);

    return a > 0 ? (r + a / r) / 2 : 0;
}

static inline real size(real a)
{
    return a < 0 ? -a : a;
}

static inline real least(real a, real b)
{
    return a < b ? a : b;
}

static inline real most(real a, real b)
{
    return a > b ? a : b;
}

static inline struct vec add(struct vec a, real s, struct vec b)
{
    return (struct vec){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

static inline real dot(struct vec a, struct vec b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline struct vec cross(struct vec a, struct vec b)
{
    return (struct vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline real length(struct vec a)
{
    return root(dot(a, a));
}

static inline struct vec unit(struct vec a)
{
    return add((struct vec){0, 0, 0}, 1 / length(a), a);
}

/* ---- from and to the arithmetic ---- */
#ifdef TIA_NUM_F64
#define EPSILON 0x1p-50 /* relative to the largest number in a calculation */
static inline real real_x(num_length x)
{
    return x;
}

static inline real real_d(num_unit d)
{
    return d;
}

static inline num_length x_of(double x)
{
    return x;
}
#else
#define EPSILON 0x1p-57
static inline real real_x(num_length x)
{
    return (real)x / (real)0x1p45;
}

static inline real real_d(num_unit d)
{
    return (real)d / (real)0x1p62;
}

static inline num_length x_of(double x)
{
    return (num_length)ldexp(x, 45);
}
#endif

static inline struct vec vec_of(struct num_point p)
{
    return (struct vec){real_x(p.x), real_x(p.y), real_x(p.z)};
}

static inline struct num_point point_of(struct vec v)
{
    return (struct num_point){x_of((double)v.x), x_of((double)v.y), x_of((double)v.z)};
}

static inline struct vec dir_of(struct num_dir d)
{
    return (struct vec){real_d(d.x), real_d(d.y), real_d(d.z)};
}

static inline struct vec position(struct tia_vec3 v)
{
    return (struct vec){v.x / 65536.0, v.y / 65536.0, v.z / 65536.0};
}

/* ---- chance ---- */
static inline double chance(void) /* in -1..1 */
{
    return random_double();
}

static inline double between(double a, double b)
{
    return a + (b - a) * (chance() + 1) / 2;
}

/* Returns a random length between a and b, distributed evenly over the orders of magnitude. */
static inline double any_length(double a, double b)
{
    return a * exp2(between(0, log2(b / a)));
}

static inline struct vec any_direction(void)
{
    struct vec v;

    do
        v = (struct vec){chance(), chance(), chance()};
    while (dot(v, v) > 1 || dot(v, v) < (real)0.01);
    return unit(v);
}

/* Returns a vector at right angles to n. */
static inline struct vec any_across(struct vec n)
{
    return unit(cross(n, any_direction()));
}

static inline struct tia_vec3 any_place(double far)
{
    return (struct tia_vec3){(tia_q16)(far * chance() * 65536), (tia_q16)(far * chance() * 65536),
                             (tia_q16)(far * chance() * 65536)};
}

/* ---- the check ---- */
struct candidate {
    real t, margin, depth;
    uint32_t element;
    struct vec normal;
};

#define CANDIDATES_MAX 16384

struct subject {
    struct shape shape;
    real extent; /* the shape's size plus its distance from the origin: the scale of rounding errors */
    bool is_infinite;
    bool closes;      /* v = 0 and v = 1 are the same */
    const void *what; /* the shape's public struct */
    int (*candidates)(const struct subject *s, struct vec o, struct vec d,
                      struct candidate found[]);                               /* the candidates; some lie behind o */
    real (*distance)(const struct subject *s, struct vec p, uint32_t element); /* distance of p from the element */
    struct vec (*normal)(const struct subject *s, struct vec p, uint32_t element);
    void (*uv)(const struct subject *s, struct vec p, uint32_t element, real uv[2]);
    real (*curvature)(const struct subject *s, struct vec p, uint32_t element); /* 1/radius; also the divisor of uv */
};

static int hits, misses, undecided; /* results of a case's rays */

static inline real wrapped(real a) /* u = 0 and u = 1 are the same around an axis */
{
    a = size(a);
    return a > (real)0.5 && a < (real)1.5 ? size(a - 1) : a;
}

static inline void check_surface(const struct subject *s, struct num_point point, uint32_t element)
{
    struct surface surface;
    struct vec p = vec_of(point), n = s->normal(s, p, element);
    real curvature = s->curvature(s, p, element), error = 16 * (real)EPSILON * (1 + s->extent * curvature), uv[2];
    num_length got[2];

    error += (real)0x1p-44 * curvature;
    s->shape.kind->surface(&s->shape, point, element, &surface);
    struct vec off = add(dir_of(surface.normal), -1, n);
    CHECK_MSG(length(off) <= error, "the normal is off by %Lg, not %Lg, element %u", (long double)length(off),
              (long double)error, (unsigned)element);
    CHECK(length(add(dir_of(surface.smooth), -1, dir_of(surface.normal))) == 0);
    s->shape.kind->uv(&s->shape, point, element, got);
    s->uv(s, p, element, uv);
    error = error * 2 + (real)0x1p-44 + 4 * (real)EPSILON * (size(uv[0]) + size(uv[1]));
    CHECK_MSG(wrapped(real_x(got[0]) - uv[0]) <= error &&
                  (s->closes ? wrapped(real_x(got[1]) - uv[1]) : size(real_x(got[1]) - uv[1])) <= error,
              "uv of element %u: %Lg %Lg, not %Lg %Lg", (unsigned)element, (long double)real_x(got[0]),
              (long double)real_x(got[1]), (long double)uv[0], (long double)uv[1]);
}

/* Returns the nearest candidate that is certainly a hit; its t may be off by *slack. */
static inline const struct candidate *nearest_sure(const struct candidate found[], int count, struct vec d, real error,
                                                   real limit, real *slack)
{
    const struct candidate *sure = NULL;

    for (int i = 0; i < count; i++) {
        real slope = size(dot(d, found[i].normal)), own = slope > 0 ? 2 * error / slope : 1e30L;
        if (found[i].margin <= 16 * error + 2 * own || found[i].depth <= 16 * error || found[i].t < own ||
            found[i].t > limit - own || (sure && sure->t <= found[i].t))
            continue;
        sure = &found[i];
        *slack = own;
    }
    return sure;
}

static inline void check_ray(const struct subject *s, struct vec from, struct vec along, double limit)
{
    static struct candidate found[CANDIDATES_MAX];
    struct ray ray = {point_of(from), {0, 0, 0}};
    struct num_point heading = point_of(along);
    struct intersection c = {0, 77};
    real slack = 0;

    (void)num_normalise(heading, &ray.direction);
    struct vec o = vec_of(ray.origin), d = dir_of(ray.direction);
    real error = (real)0x1p-42 + (real)EPSILON * (s->extent + length(o));
    int count = s->candidates(s, o, d, found);
    bool met = s->shape.kind->intersect(&s->shape, &ray, x_of(limit), &c);
    const struct candidate *sure = nearest_sure(found, count, d, error, limit, &slack);

    CHECK_EQ(s->shape.kind->occluded(&s->shape, &ray, x_of(limit)), met);
    if (met) {
        real t = real_x(c.t), off = s->distance(s, add(o, t, d), c.element);
        CHECK_MSG(off <= error, "a hit at %Lg, element %u, is off by %Lg, not %Lg", (long double)t, (unsigned)c.element,
                  (long double)off, (long double)error);
        CHECK(t >= 0 && t <= limit);
        check_surface(s, num_point_at(ray.origin, ray.direction, c.t), c.element);
        hits++;
        if (!sure) {
            undecided++;
            return;
        }
        CHECK_MSG(t <= sure->t + slack, "a hit at %Lg, not at %Lg", (long double)t, (long double)sure->t);
        CHECK_MSG(t < sure->t - slack || c.element == sure->element, "element %u instead of %u at %Lg",
                  (unsigned)c.element, (unsigned)sure->element, (long double)t);
        undecided += t < sure->t - slack;
    } else {
        misses++;
        CHECK_MSG(!sure, "no hit at %Lg, element %u, margin %Lg of %Lg", (long double)sure->t, (unsigned)sure->element,
                  (long double)sure->margin, (long double)error);
    }
}

/* Checks rays of all kinds that go through the point p of the shape's surface, where its normal is n. */
static inline void check_rays_through(const struct subject *s, struct vec p, struct vec n, double scale)
{
    static const double distances[] = {0, 0.1, 1, 10, 1000};

    for (int i = 0; i < 5; i++) {
        double far = i == 0 ? any_length(scale * 1e-6, scale) : fmin(scale * distances[i], 30000);
        check_ray(s, add(p, -far, any_direction()), any_direction(), 131072);
        struct vec d = any_direction();
        check_ray(s, add(p, -far, d), d, 131072);
        d = unit(add(any_across(n), exp2(between(-24, 0)) * (chance() < 0 ? -1 : 1), n));
        check_ray(s, add(p, -far, d), d, 131072);
        check_ray(s, add(p, -far, d), d, far * between(0, 2));
        d = any_across(n); /* just above and just below the surface */
        check_ray(s, add(add(p, -far, d), (chance() < 0 ? -1 : 1) * scale * exp2(between(-36, -10)), n), d, 131072);
    }
    struct vec d = any_direction();
    check_ray(s, add(p, -30000, d), d, 131072);
}

#endif
