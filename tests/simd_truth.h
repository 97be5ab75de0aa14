/* simd_truth.h - the values of docs/definition.md at a pixel in 113 bits, by the page's own formulas and in its units.
 * No code is shared with src/simd or src/exact. */
#ifndef TESTS_SIMD_TRUTH_H
#define TESTS_SIMD_TRUTH_H

#include <float.h>
#include <math.h>

#include "render/renderer.h"

#if LDBL_MANT_DIG >= 113
#define TRUTH_KNOWN 1
typedef long double quad;
#elif defined __SIZEOF_FLOAT128__
#define TRUTH_KNOWN 1
__extension__ typedef __float128 quad;
#else
#define TRUTH_KNOWN 0 /* 64 bits: tests of doubles see their own roundings */
typedef long double quad;
#endif

static inline quad quad_root(quad a)
{
    quad x = (quad)sqrtl((long double)a);

    for (int i = 0; a > 0 && i < 2; i++)
        x = (x + a / x) / 2;
    return a > 0 ? x : 0;
}

static inline quad quad_size(quad a)
{
    return a < 0 ? -a : a;
}

static inline quad quad_dot(const quad a[3], const quad b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Returns H cot(pi F/360), F in degrees, Q16.16. */
static inline quad truth_depth(unsigned height, tia_q16 fov)
{
    const quad pi = (quad)0x1.921fb54442d18p1 + (quad)0x1.1a62633145c07p-53 + (quad)-0x1.f1976b7ed8fbcp-109;
    quad x = pi * fov / 360 / 65536, sine = 0, cosine = 0, term = 1;

    for (int i = 1; i < 60; i++) {
        if (i & 1)
            cosine += i & 2 ? -term : term;
        else
            sine += i & 2 ? term : -term;
        term *= x / i;
    }
    return height * cosine / sine;
}

/* A ray and the point where it meets a ball. */
struct truth {
    quad v[3], t, p[3], n[3], start[3]; /* P, N, P + 2^-13 N */
    quad b, d;
};

static inline void truth_place(const struct tia_scene *scene, struct tia_vec3 at, quad r[3])
{
    const struct tia_vec3 *eye = &scene->camera.eye;

    r[0] = ((quad)at.x - eye->x) / 65536;
    r[1] = ((quad)at.y - eye->y) / 65536;
    r[2] = ((quad)at.z - eye->z) / 65536;
}

/* Gives the point of a ball at pixel (x, y); `depth` is truth_depth(). For a ball that the ray misses D counts as 0. */
static inline void truth_meet(const struct tia_scene *scene, const int size[2], quad depth, int x, int y,
                              struct tia_vec3 at, tia_q16 radius, struct truth *o)
{
    quad l[3], r = (quad)radius / 65536;

    truth_place(scene, at, l);
    o->v[0] = 2 * x + 1 - size[0];
    o->v[1] = size[1] - 2 * y - 1;
    o->v[2] = -depth;
    quad c = quad_dot(l, l) - r * r, square = quad_dot(o->v, o->v);
    o->b = quad_dot(l, o->v);
    o->d = o->b * o->b - c * square;
    quad root = quad_root(o->d > 0 ? o->d : 0);
    /* (b - root)/v.v and (b + root)/v.v without cancellation */
    o->t = c >= 0 ? c / (o->b + root) : o->b < 0 ? -c / (root - o->b) : (o->b + root) / square;
    for (int i = 0; i < 3; i++) {
        o->p[i] = o->t * o->v[i];
        o->n[i] = (c >= 0 ? o->p[i] - l[i] : l[i] - o->p[i]) / r;
        o->start[i] = o->p[i] + o->n[i] / 8192;
    }
}

/* The ray from the point to a light: w, w.w, and N.w/|w|. */
struct truth_way {
    quad w[3], square, cosine;
};

static inline void truth_look(const struct truth *o, const quad q[3], struct truth_way *way)
{
    for (int i = 0; i < 3; i++)
        way->w[i] = q[i] - o->p[i];
    way->square = quad_dot(way->w, way->w);
    way->cosine = quad_dot(o->n, way->w) / quad_root(way->square);
}

/* A caster's values: A.w, h = A.A - R^2 and |A|. */
struct truth_caster {
    quad a, h, reach;
};

static inline void truth_approach(const struct truth *o, const struct truth_way *way, const quad c[3], quad r,
                                  struct truth_caster *caster)
{
    quad a[3];

    for (int i = 0; i < 3; i++)
        a[i] = c[i] - o->start[i];
    caster->a = quad_dot(a, way->w);
    caster->h = quad_dot(a, a) - r * r;
    caster->reach = quad_root(quad_dot(a, a));
}

#endif
