/* vector_tmpl.h - 3D vectors whose components have one number per lane.
 *
 * Parameters: the doubles of isa/isa.h. Defines: struct v3 and its operations v3_*(), v3_unit(), root_error(),
 * vgather(), vfloor(), vload(), vstore(), vpacked(), lane_of(), lane_at(), vspread(), v3_spread(), any(), mnone(),
 * as_integers(), as_doubles(), whole_words(), most3(), EACH_LANE(), INFINITE. */
#ifndef TIA_SIMD_RAYS_VECTOR_TMPL_H
#define TIA_SIMD_RAYS_VECTOR_TMPL_H

#include "bounds.h"

#define INFINITE 1e30

struct v3 {
    vd x, y, z;
};

LANE_OP vi as_integers(vd a)
{
    vi i;

    __builtin_memcpy(&i, &a, sizeof i);
    return i;
}

LANE_OP vd as_doubles(vi i)
{
    vd a;

    __builtin_memcpy(&a, &i, sizeof a);
    return a;
}

/* Returns integers in 0..2^32 - 1, given as doubles: adding 1.5 2^52 moves them to the lowest bits. */
LANE_OP vi whole_words(vd a)
{
    return as_integers(a + vset(6755399441055744.0)) & INT64_C(0xffffffff);
}

/* Returns the floor of x, |x| < 2^51: adding 1.5 2^52 rounds x to nearest, and 1 is subtracted if the result is above
 * x. */
LANE_OP vd vfloor(vd x)
{
    vd nearest = (x + vset(6755399441055744.0)) - vset(6755399441055744.0);

    return nearest - vsel(vlt(x, nearest), vset(1), vset(0));
}

LANE_OP vd vload(const double *p)
{
    vd v;

    __builtin_memcpy(&v, p, sizeof v);
    return v;
}

LANE_OP void vstore(double *p, vd v)
{
    __builtin_memcpy(p, &v, sizeof v);
}

/* Returns lane k of a vector in memory. */
LANE_OP double lane_at(const vd *v, int k)
{
    double x;

    __builtin_memcpy(&x, (const char *)v + (size_t)k * sizeof x, sizeof x);
    return x;
}

LANE_OP vd vspread(const vd *v, int k)
{
    return vset(lane_at(v, k));
}

LANE_OP double lane_of(vd v, int k)
{
    double lanes[LANES];

    vstore(lanes, v);
    return lanes[k];
}

/* Returns the chosen lanes, moved together to the first ones; the others are unspecified. */
LANE_OP vd vpacked(vd v, unsigned lanes)
{
#ifdef VPACK
    return VPACK(v, lanes);
#else
    double from[LANES], to[LANES] = {0};
    int n = 0;

    if (LANES == 1 || lanes == (1u << LANES) - 1)
        return v;
    vstore(from, v);
    for (; lanes; lanes &= lanes - 1)
        to[n++] = from[__builtin_ctz(lanes)];
    return vload(to);
#endif
}

LANE_OP bool any(vm m)
{
    return mbits(m) != 0;
}

LANE_OP vm mnone(void)
{
    return mof(0);
}

LANE_OP struct v3 v3_spread(const struct v3 *v, int k)
{
    return (struct v3){vspread(&v->x, k), vspread(&v->y, k), vspread(&v->z, k)};
}

LANE_OP struct v3 v3_set(const double p[3])
{
    return (struct v3){vset(p[0]), vset(p[1]), vset(p[2])};
}

LANE_OP vd v3_dot(struct v3 a, struct v3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

LANE_OP struct v3 v3_add(struct v3 a, struct v3 b)
{
    return (struct v3){a.x + b.x, a.y + b.y, a.z + b.z};
}

LANE_OP struct v3 v3_sub(struct v3 a, struct v3 b)
{
    return (struct v3){a.x - b.x, a.y - b.y, a.z - b.z};
}

LANE_OP struct v3 v3_neg(struct v3 a)
{
    return (struct v3){-a.x, -a.y, -a.z};
}

LANE_OP struct v3 v3_scale(struct v3 a, vd s)
{
    return (struct v3){a.x * s, a.y * s, a.z * s};
}

LANE_OP struct v3 v3_along(struct v3 o, struct v3 d, vd t)
{
    return v3_add(o, v3_scale(d, t));
}

LANE_OP struct v3 v3_cross(struct v3 a, struct v3 b)
{
    return (struct v3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/* Returns |x| + |y| + |z|, which is at least the length; roundings are measured as parts of it. */
LANE_OP vd v3_sum(struct v3 a)
{
    return vabs(a.x) + vabs(a.y) + vabs(a.z);
}

LANE_OP struct v3 v3_sel(vm m, struct v3 a, struct v3 b)
{
    return (struct v3){vsel(m, a.x, b.x), vsel(m, a.y, b.y), vsel(m, a.z, b.z)};
}

LANE_OP vd most3(const vd c[3])
{
    return vmax(vmax(c[0], c[1]), c[2]);
}

/* Returns v/|v|. The fixed-point v is within e, and *ed receives the bound on the distance between this v/|v| and the
 * fixed-point one. The sine of the angle between them is at most x = e/|v|, so their distance, the chord of the angle,
 * is at most
 *
 *     x sqrt(2/(1 + sqrt(1 - x^2))) <= (1 + 2^-10) x   for x < 1/16.
 *
 * The roundings of both add 2^-50: 5 u here, and 2^-58 by num_normalise. For larger x, *ed is 4, which leaves the lane
 * undecided, as unit vectors are no farther apart than 2. */
LANE_OP struct v3 v3_unit(struct v3 v, vd e, vd *ed)
{
    vd inverse = 1 / vmax(vsqrt(v3_dot(v, v)), vset(1e-30)), relative = e * inverse;

    *ed = vsel(vlt(relative, vset(1.0 / 16)), relative * BOUND(UNIT_CHORD) + vset(BOUND(UNIT_ROUNDING)), vset(4));
    return v3_scale(v, inverse);
}

/* Returns the largest |sqrt a - sqrt a'| where a > 0 has this root and |a - a'| <= e. For y = e/a <= 1 it is root (1 -
 * sqrt(1 - y)) = root y/(1 + sqrt(1 - y)), whose second factor is convex in y, 1/2 at 0 and 1 at 1, so at most (1 +
 * y)/2. For y > 1 it is the root itself, or e/(2 root), and less than that. */
LANE_OP vd root_error(vd e, vd root)
{
    vd inverse = 1 / root, half = 0.5 * (e * inverse);

    return half + half * (e * inverse * inverse);
}

/* Initialises a vector with of(0), of(1), ..., one for each lane. The numbers go through registers: a load of a vector
 * whose elements have just been stored one by one would wait for all these stores. */
#if LANES == 1
#define EACH_LANE(of) of(0)
#elif LANES == 2
#define EACH_LANE(of) of(0), of(1)
#elif LANES == 4
#define EACH_LANE(of) of(0), of(1), of(2), of(3)
#else
#define EACH_LANE(of) of(0), of(1), of(2), of(3), of(4), of(5), of(6), of(7)
#endif

/* Returns p[k][i] in lane k. */
LANE_OP vd vgather(const double *const p[LANES], int i)
{
#define GATHERED(k) p[k][i]
    return (vd){EACH_LANE(GATHERED)};
#undef GATHERED
}

LANE_OP struct v3 v3_gather(const double *const p[LANES], int i)
{
    return (struct v3){vgather(p, i), vgather(p, i + 1), vgather(p, i + 2)};
}

#endif
