/* direction_tmpl.h - random directions in doubles, see samples/direction.c: within 2^-50 of the fixed-point ones, which
 * are within 2^-59 of the same formulas.
 *
 * Parameters: the doubles of isa/isa.h. Defines: turn_place(), disc_place(), cosine_direction(), around(). */
#ifndef TIA_SIMD_RAYS_DIRECTION_TMPL_H
#define TIA_SIMD_RAYS_DIRECTION_TMPL_H

#include "random_tmpl.h"
#include "samples/direction.h"

/* Gives sine and cosine of x eighths of a turn, |x| <= 1, by series of the angle a to a^17 and a^16. The remaining
 * terms are below a^19/19! < 1e-19 and a^18/18! < 2e-18; roundings are below 2^-51, most of it the angle's and the last
 * sums'. */
LANE_OP void sine_cosine(vd x, vd *s, vd *c)
{
    vd a = x * 0.78539816339744831, q = a * a, u = vset(1.0 / 355687428096000.0), v = vset(1.0 / 20922789888000.0);

    u = u * q - 1.0 / 1307674368000.0;
    u = u * q + 1.0 / 6227020800.0;
    u = u * q - 1.0 / 39916800;
    u = u * q + 1.0 / 362880;
    u = u * q - 1.0 / 5040;
    u = u * q + 1.0 / 120;
    u = u * q - 1.0 / 6;
    *s = a + a * (q * u);
    v = v * q - 1.0 / 87178291200.0;
    v = v * q + 1.0 / 479001600;
    v = v * q - 1.0 / 3628800;
    v = v * q + 1.0 / 40320;
    v = v * q - 1.0 / 720;
    v = v * q + 1.0 / 24;
    v = v * q - 0.5;
    *c = 1 + v * q;
}

/* Gives cosine and sine of (u + 1/2)/2^32 turns, from the nearest quarter turn q, 0..4; 4 stands for 0. */
LANE_OP void turn_place(vu u, vd *x, vd *y)
{
    const double shift = 6755399441055744.0; /* 1.5 2^52: rounds numbers added to it */
    vd quarters = 4 * vu_unit(u), q = (quarters + shift) - shift, s, c;

    sine_cosine(2 * (quarters - q), &s, &c);
    vm past_half = vlt(vset(1.5), q), before_half = vlt(q, vset(1.5)), some = vlt(vset(0.5), q);
    vm odd = mor(mand(some, before_half), mand(vlt(vset(2.5), q), vlt(q, vset(3.5))));
    vd along = vsel(odd, s, c), across = vsel(odd, c, s);
    *x = vsel(mand(some, vlt(q, vset(2.5))), -along, along);
    *y = vsel(mand(past_half, vlt(q, vset(3.5))), -across, across);
}

/* Gives a place on the disc by the concentric map. Both a and b are exact, and so is their order; the share is rounded,
 * which turns the place by a quarter of pi 2^-53. */
LANE_OP vd disc_place(vu u0, vu u1, vd *x, vd *y)
{
    vd a = 2 * vu_unit(u0) - 1, b = 2 * vu_unit(u1) - 1, s, c;
    vm longer = vlt(vabs(b), vabs(a));
    vd radius = vsel(longer, a, b), other = vsel(longer, b, a);

    sine_cosine(other / radius, &s, &c);
    *x = radius * vsel(longer, c, s);
    *y = radius * vsel(longer, s, c);
    return radius;
}

/* Gives a direction with the density of a cosine. The cosine's root loses nothing: 1 - r and 1 + r are exact. */
LANE_OP struct v3 cosine_direction(vu u0, vu u1)
{
    struct v3 d;
    vd r = disc_place(u0, u1, &d.x, &d.y);

    d.z = vsqrt((1 - r) * (1 + r));
    return d;
}

/* Turns a direction around z to another axis, as trace/around.c; the axis is within e, the result within *ed. With k =
 * 1/(1 + |z|) and x^2 + y^2 <= 1 - z^2, (x^2 + y^2) k <= 1: x^2 k changes by (2 |x| k + x^2 k^2) e <= 3 e, x y k by 2
 * e, so either tangent by sqrt(9 + 4 + 1) e, and the sum by sqrt(14 + 14 + 1) e < 6 e. Roundings are below 2^-50 a
 * coordinate. The tangents jump where z changes its sign; in `exact` lanes z has the sign of the fixed-point one all
 * the same. */
LANE_OP struct v3 around(struct v3 n, vd e, vm exact, struct v3 local, vd elocal, vd *ed, vm *unsure)
{
    vm down = vlt(n.z, vset(0)), upright = mnot(down);
    vd k = 1 / (1 + vabs(n.z)), xx = n.x * n.x * k, yy = n.y * n.y * k, xy = n.x * n.y * k;
    struct v3 t = {1 - xx, -xy, vsel(upright, -n.x, n.x)};
    struct v3 b = {vsel(upright, -xy, xy), vsel(upright, 1 - yy, yy - 1), -n.y};
    struct v3 sum = v3_add(v3_scale(n, local.z), v3_add(v3_scale(t, local.x), v3_scale(b, local.y)));

    *unsure = mand(mnot(exact), vle(vabs(n.z), e));
    return v3_unit(sum, BOUND_OF(AROUND, 6 * e + elocal) + vset(BOUND(AROUND_ROUNDING)), ed);
}

#endif
