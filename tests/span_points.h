/* span_points.h - the points that the pixels of a coherence run show, in long double, with the integers' rounded K. */
#ifndef TESTS_SPAN_POINTS_H
#define TESTS_SPAN_POINTS_H

#include <math.h>

#include "render/span/coherence/coherence_run.h"

typedef long double real;

static real power(int bits)
{
    return ldexpl(1, bits);
}

/* Returns the bound of a binary logarithm in 256ths. */
static real bound_of(int log)
{
    return exp2l(log / 256.0L);
}

struct vector {
    real x, y, z;
};

static struct vector vector_of(struct num_vec a)
{
    return (struct vector){(real)a.x * 0x1p-16L, (real)a.y * 0x1p-16L, (real)a.z * 0x1p-16L};
}

static real dot(struct vector a, struct vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static struct vector along(struct vector a, real t, struct vector b)
{
    return (struct vector){a.x + t * b.x, a.y + t * b.y, a.z + t * b.z};
}

static real distance(struct vector a, struct vector b)
{
    struct vector c = along(a, -1, b);
    return sqrtl(dot(c, c));
}

static struct vector direction(const struct coherence_run *run, int x)
{
    const struct primary_rays *p = run->primary;
    real unit = power(-p->exponent);

    return (struct vector){(real)num_pixel_coordinate(2 * x + 1 - p->width, p->exponent) * unit,
                           (real)primary_y(p, run->y) * unit, -(real)p->depth * unit};
}

static const struct vector origin;

/* Returns the point of the run's sphere that a pixel shows, for an eye outside the sphere; *t is its multiple of the
 * direction. */
static struct vector point(const struct coherence_run *run, int x, real *t)
{
    struct vector v = direction(run, x);
    real b = dot(vector_of(run->sphere->centre), v), c = (real)run->sphere->c * 0x1p-32L;

    *t = c / (b + sqrtl(b * b - c * dot(v, v)));
    return along(origin, *t, v);
}

#endif
