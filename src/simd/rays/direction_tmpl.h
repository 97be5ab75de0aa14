/* direction_tmpl.h - random directions in doubles, by the formulas of samples/direction.c. Each coordinate is within
 * 2^-50 of the fixed-point one, which is within 2^-59 of the exact value.
 *
 * Parameters: the doubles of isa/isa.h. Defines: turn_place(), disc_place(), cosine_direction(), around(). */
#ifndef TIA_SIMD_RAYS_DIRECTION_TMPL_H
#define TIA_SIMD_RAYS_DIRECTION_TMPL_H

#include "random_tmpl.h"
#include "samples/direction.h"

/* Gives the sine and cosine of x eighths of a turn, |x| <= 1, by power series of the angle a up to a^17 and a^16. The
 * remainders are below a^19/19! < 1e-19 and a^18/18! < 2.1e-18. Roundings are below 2^-51; most of this comes from the
 * angle and the last sums. */
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

/* Gives the cosine and sine of (u + 1/2)/2^32 turns, by the difference from the nearest quarter turn q, 0..4; 4 is the
 * same as 0. */
LANE_OP void turn_place(vu u, vd *x, vd *y)
{
    const double shift = 6755399441055744.0; /* 1.5 2^52: adding it rounds a number to an integer */
    vd quarters = 4 * vu_unit(u), q = (quarters + shift) - shift, s, c;

    sine_cosine(2 * (quarters - q), &s, &c);
    vm past_half = vlt(vset(1.5), q), before_half = vlt(q, vset(1.5)), some = vlt(vset(0.5), q);
    vm odd = mor(mand(some, before_half), mand(vlt(vset(2.5), q), vlt(q, vset(3.5))));
    vd along = vsel(odd, s, c), across = vsel(odd, c, s);
    *x = vsel(mand(some, vlt(q, vset(2.5))), -along, along);
    *y = vsel(mand(past_half, vlt(q, vset(3.5))), -across, across);
}

/* Gives a point of the unit disc by the concentric map, and returns its signed radius. The numbers a and b are exact,
 * and so is the comparison of their sizes. Rounding other/radius turns the point by at most pi/4 2^-53. */
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

/* Returns a direction around z with a density proportional to its cosine. The root is accurate, as 1 - r and 1 + r are
 * exact. */
LANE_OP struct v3 cosine_direction(vu u0, vu u1)
{
    struct v3 d;
    vd r = disc_place(u0, u1, &d.x, &d.y);

    d.z = vsqrt((1 - r) * (1 + r));
    return d;
}

/* Rotates a direction from around z to around n, as in trace/around.c. n has the error e and `local` the error elocal;
 * *ed receives that of the result. For z >= 0 the tangents and n are the rotation about an axis across z that takes z
 * to n, so at an angle a from z. If n moves at a speed of 1, this frame turns with 1 across n and, at most, tan(a/2) <=
 * 1 around n: by sqrt 2 together. Both n are unit vectors in one half of the sphere, where the shorter arc between them
 * stays. It is at most e asin(e/2)/(e/2) <= 1.05 e long for e <= 1, so any direction turns by at most 1.485 e. For z <
 * 0 the frame is that of (x, y, -z), mirrored. Roundings are below 2^-50 in each coordinate. The tangents jump where z
 * changes its sign, so that lanes with |z| <= e are undecided, except `exact` lanes, in which z has the sign of the
 * fixed-point one. */
LANE_OP struct v3 around(struct v3 n, vd e, vm exact, struct v3 local, vd elocal, vd *ed, vm *unsure)
{
    vm down = vlt(n.z, vset(0)), upright = mnot(down);
    vd k = 1 / (1 + vabs(n.z)), xx = n.x * n.x * k, yy = n.y * n.y * k, xy = n.x * n.y * k;
    struct v3 t = {1 - xx, -xy, vsel(upright, -n.x, n.x)};
    struct v3 b = {vsel(upright, -xy, xy), vsel(upright, 1 - yy, yy - 1), -n.y};
    struct v3 sum = v3_add(v3_scale(n, local.z), v3_add(v3_scale(t, local.x), v3_scale(b, local.y)));

    *unsure = mand(mnot(exact), vle(vabs(n.z), e));
    return v3_unit(sum, BOUND_OF(AROUND, BOUND(AROUND_TURN) * e + elocal) + vset(BOUND(AROUND_ROUNDING)), ed);
}

#endif
