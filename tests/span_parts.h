/* span_parts.h - b, sqrt(D) and S of a pixel in 113 bits, with K0, the integers' rounded K, in the place of K. For
 * test_span_error.c, which includes span_shade.c. */
#ifndef TESTS_SPAN_PARTS_H
#define TESTS_SPAN_PARTS_H

#if TRUTH_KNOWN

/* Returns 2^e. */
static quad power(int e)
{
    quad x = 1;

    for (int i = 0; i < (e < 0 ? -e : e); i++)
        x *= 2;
    return e < 0 ? 1 / x : x;
}

/* Returns the bound of a binary logarithm in 256ths. */
static real bound_of(int log)
{
    return (real)exp2l(log / 256.0L);
}

/* Returns K0. */
static quad rounded_depth(const struct span_shading *s)
{
    return s->spans->primary.depth * power(-s->spans->primary.exponent);
}

/* The values between which the parts of t's error lie: with K0 errors are roundings, the rest comes from K - K0. */
struct parts {
    quad unit;            /* 1 in last bits of the integers' b */
    quad sum, rounded;    /* S with K, and with K0 */
    quad b, root, square; /* b, sqrt(D) and v.v with K0 */
    real across, z;       /* r and L.z in last bits of b */
};

static struct parts parts_of(const struct span_shading *s, const struct span_sphere *sphere, const struct truth *o)
{
    const struct primary_rays *primary = &s->spans->primary;
    const quad v[3] = {o->v[0], o->v[1], -rounded_depth(s)}, c = sphere->c * power(-32);
    quad b = (sphere->centre.x * v[0] + sphere->centre.y * v[1] + sphere->centre.z * v[2]) * (quad)0x1p-16;
    struct parts p = {.unit = power(primary->exponent + sphere->b_shift - 16), .b = b, .square = quad_dot(v, v)};

    p.root = quad_root(b * b - c * p.square);
    p.rounded = b + p.root;
    p.sum = o->b + quad_root(o->d);
    p.across = ldexpl((real)sphere->radius, sphere->b_shift - 32);
    p.z = ldexpl((real)num_abs(sphere->centre.z), sphere->b_shift - 32);
    return p;
}

/* Returns the depth at pixel i of a span. */
static struct span_depth depth_at(const struct span_shading *s, int i)
{
    struct shaded_span one = *s->span;
    struct span_shading alone = {.span = &one, .spans = s->spans};
    struct span_depth ends[2];

    one.x += i;
    one.t += i;
    one.count = 1;
    find_ends(&alone, ends);
    return ends[0];
}

static num_wide ahead(num_wide start, num_wide step, int i)
{
    return start + (num_wide)i * step;
}

static num_wide v_square_at(const struct light_line *line, int i)
{
    struct row_square v = line->square;

    for (int k = 0; k < i; k++) {
        v.start += v.step;
        v.step += v.twice;
    }
    return v.start;
}

static quad length_of(struct num_vec a)
{
    quad v[3] = {a.x * (quad)0x1p-16, a.y * (quad)0x1p-16, a.z * (quad)0x1p-16};

    return quad_root(quad_dot(v, v));
}

#endif

/* Returns b at column x. */
static inline num_wide along(const struct span_view *spans, const struct span_sphere *sphere, int x, int y)
{
    const struct primary_rays *primary = &spans->primary;

    return sphere->centre.x * num_pixel_coordinate(2 * x + 1 - primary->width, primary->exponent) +
           sphere->centre.y * primary_y(primary, y) - sphere->centre.z * primary->depth;
}

#endif
