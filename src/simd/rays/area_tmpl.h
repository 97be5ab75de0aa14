/* area_tmpl.h - an area light as a whole: what holds for all of its samples, and numbers that are linear along its
 * axes.
 *
 * Parameters: the doubles of isa/isa.h. Defines: set_area(), set_area_seen(), is_plain_area(), turned_away(),
 * area_lambert_error(), area_above_error(), affine_of(), affine_at(), affine_reach(), square_of(), square_at(),
 * inverse_root(), struct area, struct affine, struct square.
 *
 * A sample S = L + x A + y B is at W + x A + y B from P, W = L - P. So its height over any plane through P is linear in
 * x and y, and the square of its distance is quadratic. A cosine takes a few operations and an inverse root in place of
 * a vector and its unit vector. With |x A + y B| <= |W|/2 these numbers are as exact as vectors, see AREA_COSINE; a
 * light that is nearer is left to sample_tmpl.h. */
#ifndef TIA_SIMD_RAYS_AREA_TMPL_H
#define TIA_SIMD_RAYS_AREA_TMPL_H

#include "sample_tmpl.h"

/* The number `at` + x `x` + y `y` of a sample. */
struct affine {
    vd at, x, y;
};

/* |V + x A + y B|^2 of a sample. */
struct square {
    vd at, x, y, xx, xy, yy;
};

/* A light as the points P see it, and as the origins O of their shadow rays do. */
struct area {
    const struct sure_light *light;
    struct v3 axes[2], way, out; /* A, B, L - P, L - O */
    struct square seen, shadow;  /* squares of distances from P and from O */
    vd reach;                    /* largest |x A + y B| */
    vd eplace;                   /* error of the samples' places relative to the light */
    vd eto, eout;                /* errors of the samples' directions from P and from O */
    vd apart;                    /* largest distance of fixed-point shadow rays from the segments to the samples */
    vm fine;                     /* other lanes are too close to the light or too uncertain */
    double most;                 /* largest |x| and |y|; of a disc, largest |(x, y)| */
    bool disc;
};

/* True if the light can be taken as a whole: an area whose light neither fades nor has a cone. */
LANE_OP bool is_plain_area(const struct sure_light *l)
{
    return tia_light_has(l->from->kind, TIA_LIGHT_AREA) && !tia_light_has(l->from->kind, TIA_LIGHT_CONE) &&
           !l->from->fades && l->place;
}

LANE_OP struct affine affine_of(const struct v3 axes[2], struct v3 way, struct v3 n)
{
    return (struct affine){v3_dot(n, way), v3_dot(n, axes[0]), v3_dot(n, axes[1])};
}

LANE_OP vd affine_at(const struct affine *f, vd x, vd y)
{
    return f->at + x * f->x + y * f->y;
}

/* Returns the largest |x `x` + y `y`| of the light's samples. */
LANE_OP vd affine_reach(const struct area *a, const struct affine *f)
{
    if (a->disc)
        return vset(a->most) * vsqrt(f->x * f->x + f->y * f->y);
    return vset(a->most) * (vabs(f->x) + vabs(f->y));
}

LANE_OP struct square square_of(const struct v3 axes[2], struct v3 way)
{
    return (struct square){v3_dot(way, way),         2 * v3_dot(way, axes[0]),     2 * v3_dot(way, axes[1]),
                           v3_dot(axes[0], axes[0]), 2 * v3_dot(axes[0], axes[1]), v3_dot(axes[1], axes[1])};
}

LANE_OP vd square_at(const struct square *f, vd x, vd y)
{
    return f->at + x * (f->x + x * f->xx + y * f->xy) + y * (f->y + y * f->yy);
}

LANE_OP vd inverse_root(vd x)
{
#ifdef VRSQRT
    return VRSQRT(x);
#else
    return 1 / vsqrt(x);
#endif
}

/* Return the bounds of the errors of a sample's cosine to the normal and to the geometric normal. */
LANE_OP vd area_lambert_error(const struct area *a, const struct shade *h)
{
    return BOUND_OF(LAMBERT, h->en + a->eto + BOUND(COSINE)) + BOUND(AREA_COSINE);
}

LANE_OP vd area_above_error(const struct area *a, const struct shade *h)
{
    return BOUND_OF(ABOVE, h->eg + a->eto + BOUND(COSINE)) + BOUND(AREA_COSINE);
}

/* Returns the lanes whose surface is certainly turned away from all samples. */
LANE_OP vm turned_away(const struct area *a, const struct shade *h)
{
    struct affine above = affine_of(a->axes, a->way, h->geometric);

    return mand(a->fine,
                vlt(above.at + affine_reach(a, &above), -area_above_error(a, h) * (vsqrt(a->seen.at) + a->reach)));
}

/* Returns the bound of the errors of directions to the samples, given the square of the distance of the light's centre
 * and the bound of the vectors' errors. Clears `fine` in the lanes that are too close or too uncertain. */
LANE_OP vd area_direction_error(struct area *a, vd square, vd e)
{
    vd near = vsqrt(square);
    vm fine = mand(vlt(a->reach * BOUND(AREA_NEAR), near), vlt(vset(BOUND(AREA_LEAST)), near));
    vd relative = e / vsel(fine, near - a->reach, vset(1));

    a->fine = mand(a->fine, mand(fine, vlt(relative, vset(1.0 / 16))));
    return relative * BOUND(UNIT_CHORD) + BOUND(UNIT_ROUNDING);
}

/* Sets what the points P see of the light: all but `out`, `shadow`, `eout` and `apart`. Errors are as in sample_of(),
 * for the largest coordinates. */
static __attribute__((noinline)) void set_area_seen(const struct sure_light *l, const struct aim *aim,
                                                    const struct shade *h, struct area *a)
{
    a->light = l;
    a->disc = !tia_light_has(l->from->kind, TIA_LIGHT_SIDES);
    a->most = a->disc ? l->radius : 1;
    a->axes[0] = aim->axes[0];
    a->axes[1] = aim->axes[1];
    a->way = v3_sub(v3_set(l->at), h->point);
    a->seen = square_of(a->axes, a->way);
    a->reach = vset(l->radius);
    if (!a->disc)
        a->reach = vsqrt(a->seen.xx) + vsqrt(a->seen.yy);
    a->eplace = BOUND_OF(SAMPLE_AREA, 2 * a->most * (aim->e + BOUND(SAMPLE_PLACE))) + BOUND(SAMPLE_UNITS) +
                (v3_sum(a->axes[0]) + v3_sum(a->axes[1])) * BOUND(SAMPLE_SIDES);
    a->fine = mnot(mnone());
    a->eto = area_direction_error(
        a, a->seen.at,
        BOUND_OF(SAMPLE_WAY, h->ep + (v3_sum(a->way) + v3_sum(h->point)) * BOUND(POINT_ROUNDING)) + a->eplace);
}

/* The error of a shadow ray's vector is as in aim_shadow(), for the largest coordinates. */
static __attribute__((noinline)) void set_area(const struct sure_light *l, const struct aim *aim, const struct shade *h,
                                               struct area *a)
{
    set_area_seen(l, aim, h, a);
    a->out = v3_sub(v3_set(l->at), h->outside);
    a->shadow = square_of(a->axes, a->out);
    vd out = v3_sum(a->out), size = v3_sum(a->axes[0]) + v3_sum(a->axes[1]);
    vd es = BOUND_OF(SHADOW_WAY, h->eoutside + (out + v3_sum(h->outside)) * BOUND(POINT_ROUNDING)) + a->eplace;
    a->eout = area_direction_error(a, a->shadow.at, es);
    a->apart = BOUND_OF(SHAFT_APART, h->eoutside + es) + (out + size) * BOUND(SHAFT_ROUNDING) + BOUND(SHAFT_UNITS);
}

#endif
