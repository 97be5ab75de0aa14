/* triangle.h - triangles and the faces of meshes.
 *
 * With a, b, c from the origin to the corners, D.(a x b) has the sign of the area that the integers find, sheared along
 * the ray, times that of D's main component. Their corners are aside by 2^-46 + 2^-59 z, so their areas by l 2^-42 with
 * l = |a| + the face's extent, a bound on each corner's distance; those here by (l + eo) 2 eo + (l + eo)^2 (ed +
 * 2^-49). Inside: all three are surely of one sign.
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
    vd far = l + p->eo, e = far * (2 * p->eo + SURE_2(42)) + far * far * (p->ed + SURE_2(49));
    vd least = vmin(vmin(wa, wb), wc), most = vmax(vmax(wa, wb), wc);
    vm outside = mand(vlt(least, -e), vlt(e, most)), inside = mor(vlt(e, least), vlt(most, -e));

    if (!many(mand(mnot(outside), q->active)))
        return;
    struct flat flat = flat_meet(p, v3_set(f->normal), a, l * SURE_2(48), 4 * UNIT + l * SURE_2(50));
    flat_report(q, &flat, inside, outside, flat.e + UNIT, vset((double)face));
}

#endif
