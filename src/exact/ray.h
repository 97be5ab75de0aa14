/* ray.h - rays of the definition, computed with balls. Only pixel.c includes this file; it has the other formulas.
 *
 * Instead of t, P, N and w = Q - P their products with positive numbers are computed, which are polynomials in scene
 * numbers and one root. Only the cosine of a light has a division. With v = (X, Y, -K) and V = v.v:
 *
 *     b = L.v, c = L.L - r^2, D = b^2 - c V
 *     T = V t = b - sqrt(D) from outside, b + sqrt(D) from inside
 *     V P = T v,   n = r V N = V P - V L from outside, V L - V P from inside
 *     m = V w = V Q - V P,   M = m.m = V^2 w.w,   N.w/|w| = n.m/(r V sqrt(M))
 *
 * and for a ball C, R that may block the light, with A = C - P - 2^-13 N,
 *
 *     g = r V A = r V C - (r V P + 2^-13 n)
 *     a = g.m = r V^2 A.w,   h = g.g - (r V R)^2 = r^2 V^2 (A.A - R^2)
 *     (A.w)^2 >= w.w (A.A - R^2)  if and only if  a^2 >= M h;   w.w > A.w  if and only if  r M > a. */
#ifndef TIA_EXACT_RAY_H
#define TIA_EXACT_RAY_H

#include <stddef.h>

#include "picture.h"

#define LENGTH (-16)  /* exponent of the last bit of a length */
#define CHANNEL (-30) /* that of a channel */

/* A pixel in one precision. The members from `point` on are of the visible sphere. */
struct pixel {
    const struct exact_picture *picture;
    int n;                  /* words of the balls */
    bool open, tie;         /* a comparison is undecided; one has equal sides */
    bool inside;            /* the eye is in the body of the last call of meet() */
    bool traces;            /* path_hash is needed, in which black lights count as well */
    uint32_t path_hash;     /* see tia/debug.h */
    int x, y;               /* X, Y */
    union {                 /* few bytes, as this is on the stack of boards */
        struct ball v[3];   /* v, until `point` is set */
        struct ball sum[3]; /* S, from then on */
    };
    struct ball square;   /* V */
    struct ball point[3]; /* V P */
    struct ball scale;    /* r V */
    struct ball start[3]; /* r V P + 2^-13 n */
};

/* A sphere of the scene or a light. Lengths are in units of 2^-16, and the centre is relative to the eye. */
struct body {
    int64_t centre[3], radius;
};

/* ---- comparisons ---- */

/* Returns the sign of a. An open sign leaves the pixel open; with the most words it is 0, and a tie. */
static int sign_of(struct pixel *p, const struct ball *a)
{
    int sign = tia_ball_sign(p->n, a);

    p->open = p->open || (sign == BALL_OPEN && p->n < TIA_BALL_WORDS);
    if (sign == BALL_OPEN)
        sign = BALL_ZERO;
    p->tie = p->tie || sign == BALL_ZERO;
    return sign;
}

/* Returns the sign of a - b. */
static int compare(struct pixel *p, const struct ball *a, const struct ball *b)
{
    struct ball d;

    tia_ball_sub(p->n, &d, a, b);
    return sign_of(p, &d);
}

/* ---- vectors ---- */

typedef void operation(int words, struct ball *r, const struct ball *a, const struct ball *b);

/* Sets r[i] to a[i] b[i] for each i, `apply` standing for the product; with `step` 0, to a[i] b[0]. */
static void each(operation *apply, const struct pixel *p, struct ball r[3], const struct ball a[3],
                 const struct ball *b, int step)
{
    for (int i = 0; i < 3; i++, b += step)
        apply(p->n, &r[i], &a[i], b);
}

static void set_each(const struct pixel *p, struct ball r[3], const int64_t a[3], int e)
{
    for (int i = 0; i < 3; i++)
        tia_ball_set(p->n, &r[i], a[i], e);
}

static void dot(const struct pixel *p, struct ball *r, const struct ball a[3], const struct ball b[3])
{
    struct ball product[3];

    each(tia_ball_mul, p, product, a, b, 1);
    tia_ball_add(p->n, r, &product[0], &product[1]);
    tia_ball_add(p->n, r, r, &product[2]);
}

/* Sets r to `scale` times the lengths in a. */
static void scaled(const struct pixel *p, struct ball r[3], const int64_t a[3], const struct ball *scale)
{
    set_each(p, r, a, LENGTH);
    each(tia_ball_mul, p, r, r, scale, 0);
}

/* Sets r to a length times `factor`. */
static void multiply_length(const struct pixel *p, struct ball *r, int64_t length, const struct ball *factor)
{
    struct ball l;

    tia_ball_set(p->n, &l, length, LENGTH);
    tia_ball_mul(p->n, r, &l, factor);
}

/* Sets r to a stored point less the stored eye. */
static void relative(const struct exact_picture *picture, struct tia_vec3 at, int64_t r[3])
{
    const struct tia_vec3 *eye = &picture->scene->camera.eye;

    r[0] = (int64_t)at.x - eye->x;
    r[1] = (int64_t)at.y - eye->y;
    r[2] = (int64_t)at.z - eye->z;
}

/* Sets c to d.d - radius^2 and returns its sign, which 128 bits decide if not 64. */
static int reach(struct pixel *p, const int64_t d[3], int64_t radius, struct ball *c)
{
    struct ball v[3];

    set_each(p, v, d, LENGTH);
    dot(p, c, v, v);
    tia_ball_set(p->n, v, radius, LENGTH);
    tia_ball_mul(p->n, v, v, v);
    tia_ball_sub(p->n, c, c, v);
    return sign_of(p, c);
}

/* Returns the sign of d.d - radius^2. It is positive if a component alone is longer than the radius, as is most often.
 */
static int side_of(struct pixel *p, const int64_t d[3], int64_t radius)
{
    struct ball c;

    for (int i = 0; i < 3; i++)
        if (d[i] > radius || d[i] < -radius)
            return BALL_ABOVE;
    return reach(p, d, radius, &c);
}

/* ---- rays ---- */

/* Begins a pixel: sets v and V. In the middle of a picture of odd sizes v is (0, 0, -K); (0, 0, -1) gives the same
 * pixel, and is rational. */
static void look(struct pixel *p, const struct exact_picture *picture, int x, int y)
{
    const struct exact_depth *depth = &picture->depth;
    struct ball *k = &p->v[2];
    int64_t v[3] = {2 * x + 1 - picture->width, picture->height - 2 * y - 1, 1};

    p->picture = picture;
    p->open = p->tie = false;
    p->path_hash = 0;
    p->x = (int)v[0];
    p->y = (int)v[1];
    set_each(p, p->v, v, 0);
    if ((p->x || p->y) && p->n == 2) {
        k->m[0] = depth->m[0];
        k->m[1] = depth->m[1];
        k->e = depth->e;
        k->radius = depth->radius;
    } else if (p->x || p->y) {
        tia_ball_depth(p->n, k, (uint32_t)picture->height, picture->scene->camera.fov);
    }
    k->sign = -1;
    dot(p, &p->square, p->v, p->v);
}

static struct body body_of(const struct exact_picture *picture, uint32_t object)
{
    uint32_t count = picture->scene->sphere_count;
    const struct tia_light *light = &picture->lights[object - count];
    const struct tia_sphere *sphere = &picture->scene->spheres[object];
    struct body b;

    relative(picture, object < count ? sphere->centre : light->centre, b.centre);
    b.radius = object < count ? sphere->radius : light->radius;
    return b;
}

/* True if the ray meets the body; gives T, unless t is NULL. With the eye on the body c is 0, and so is T. */
static bool meet(struct pixel *p, const struct body *body, struct ball *t)
{
    int n = p->n;
    struct ball l[3], b, c, d;

    int side = reach(p, body->centre, body->radius, &c);
    p->inside = side == BALL_BELOW;
    set_each(p, l, body->centre, LENGTH);
    dot(p, &b, l, p->v);
    if (!p->inside && sign_of(p, &b) == BALL_BELOW)
        return false;
    if (side == BALL_ZERO && !p->open) {
        if (t)
            tia_ball_set(n, t, 0, 0);
        return true;
    }
    tia_ball_mul(n, &c, &c, &p->square);
    tia_ball_mul(n, &d, &b, &b);
    tia_ball_sub(n, &d, &d, &c);
    int sign = p->inside ? BALL_ABOVE : sign_of(p, &d);
    if (sign == BALL_ZERO)
        tia_ball_set(n, &d, 0, 0);
    if (sign == BALL_BELOW || !t)
        return sign != BALL_BELOW;
    tia_ball_sqrt(n, &d, &d);
    (p->inside ? tia_ball_add : tia_ball_sub)(n, t, &b, &d);
    return true;
}

/* True if two balls have the same b and c, and so the same distance. L.v is Lx X + Ly Y - Lz K; the part without K and
 * the factor of K are compared in integers. */
static bool are_equally_far(struct pixel *p, const struct body *a, const struct body *b)
{
    struct ball c, d;

    if ((a->centre[0] - b->centre[0]) * p->x + (a->centre[1] - b->centre[1]) * p->y || a->centre[2] != b->centre[2])
        return false;
    reach(p, a->centre, a->radius, &c);
    reach(p, b->centre, b->radius, &d);
    return compare(p, &c, &d) == BALL_ZERO;
}

#endif
