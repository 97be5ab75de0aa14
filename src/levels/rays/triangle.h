/* triangle.h - triangles and the faces of meshes.
 *
 * With a, b, c from the origin to the corners, D.(a x b) has the sign of the area that the integers find, sheared along
 * the ray, times that of D's main component. It is D.(a x (b - a)): an origin that is off by eo moves a, not the edge,
 * so it changes by |b - a| eo; a direction that is off by ed changes it by ed |a| |b - a|. Edges are no longer than
 * twice the extent, corners no farther than l = |a| + the extent.
 *
 * Roundings: the integers' corners are aside by 2^-46 + 2^-59 z, in coordinates below 2 l, so their areas by 8 l (2^-46
 * + 2^-59 l): l 2^-42, and far less than the doubles' own part of l^2. That is 2 u l^2 for the corners relative to the
 * origin, 5 u l^2 for products and sums: l^2 2^-50. Inside: all three are surely of one sign.
 *
 * t comes from the plane here, from a weighted mean of the corners there: that is off the plane by no more than its
 * corners are (geometry/triangle.c), l 2^-48. */
#ifndef TIA_LEVELS_RAYS_TRIANGLE_H
#define TIA_LEVELS_RAYS_TRIANGLE_H

#include "flat.h"

LANE_OP void meet_face(struct query *q, const struct sure_face *f, uint32_t face)
{
    const struct pack *p = q->p;

    if (!f->any)
        return;
    struct v3 a = v3_sub(v3_set(f->at[0]), p->o), b = v3_sub(v3_set(f->at[1]), p->o),
              c = v3_sub(v3_set(f->at[2]), p->o);
    struct v3 da = v3_cross(p->d, a), db = v3_cross(p->d, b); /* D.(a x b) = b.(D x a) */
    vd wc = v3_dot(b, da), wa = v3_dot(c, db), wb = -v3_dot(c, da), l = v3_sum(a) + vset(f->extent);
    vd far = l + p->eo, e = (p->eo + far * p->ed) * (2 * f->extent) + far * (SURE_2(42) + far * (SURE_FACE * EPS));
    vd least = vmin(vmin(wa, wb), wc), most = vmax(vmax(wa, wb), wc);
    vm outside = mand(vlt(least, -e), vlt(e, most)), inside = mor(vlt(e, least), vlt(most, -e));

    if (!many(mand(mnot(outside), q->active)))
        return;
    struct flat flat = flat_meet(p, v3_set(f->normal), a, l * SURE_2(48), 4 * UNIT + l * SURE_2(50));
    flat_report(q, &flat, inside, outside, flat.e + UNIT, vset((double)face));
}

#endif
