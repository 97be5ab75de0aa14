/* triangle_tmpl.h - triangles and the faces of meshes.
 *
 * Parameters: the doubles of isa/isa.h. Defines: meet_face(), meet_plane_of(), face_sides(), line_of(), struct sides.
 *
 * Let a and b lead from the origin to two corners. D.(a x b) has the sign of the fixed-point area, whose corners are
 * projected along the ray, times that of D's main component. It equals D.(a x (b - a)). An origin that is off by eo
 * moves a, not the edge, and changes the area by |b - a| eo. A direction that is off by ed changes the area by ed |a|
 * |b - a|. Edges are no longer than twice the face's extent. Corners are no farther than `far`: the origin's |x| + |y|
 * + |z| from a centre, plus R, the largest distance of a corner from it.
 *
 * With A, B and O relative to that centre, the area equals D.(A x B) + (O x D).(B - A). A x B and B - A depend on the
 * face only, O x D on the ray only. The sizes of the first product's terms add up to R^2 at most, those of the second's
 * to |O| 2 R, together far^2. A term of the first is rounded by the product and the difference of A x B, the product
 * with D, and five sums. A term of the second is rounded by the difference of O and the centre, and then as often: nine
 * times in all.
 *
 * The fixed-point corners are displaced by 2^-46 + 2^-59 z, in coordinates below 2 far, so their areas are off by 8 far
 * (2^-46 + 2^-58 far). TRIANGLE_CORNERS, 2^-42 far, covers the first part; the second is much less than the roundings
 * of doubles, and TRIANGLE_AREA covers it. A line is inside a face where all three areas certainly have one sign.
 *
 * Here t comes from the plane, in fixed point from a weighted mean of the corners. That mean is no farther off the
 * plane than its corners are (geometry/triangle.c), l 2^-48. */
#ifndef TIA_SIMD_RAYS_TRIANGLE_TMPL_H
#define TIA_SIMD_RAYS_TRIANGLE_TMPL_H

#include "flat_tmpl.h"
#include "sure_faces.h"

/* The lines that certainly pass inside all edges of a face, and those that certainly pass outside of one. */
struct sides {
    vm inside, outside;
};

/* Returns the line of each ray; `extent`: R. */
LANE_OP struct line line_of(const struct packet *p, const double centre[3], double extent)
{
    struct v3 o = v3_sub(p->o, v3_set(centre));
    vd far = BOUND_OF(TRIANGLE_FAR, v3_sum(o) + vset(extent) + p->eo);
    vd e = BOUND_OF(TRIANGLE_ROUNDINGS, far * (BOUND(TRIANGLE_CORNERS) + far * BOUND(TRIANGLE_AREA)));
    vd each = BOUND_OF(TRIANGLE_EDGE, 2 * (p->eo + far * p->ed));

    return (struct line){v3_cross(o, p->d), centre, e, each};
}

LANE_OP struct sides face_sides(const struct packet *p, const struct line *l, const struct sure_face *f)
{
    struct sure_edges edges = sure_edges_of(f, l->centre);
    vd w[3], e = BOUND_OF(TRIANGLE_SIDE, l->e + l->each * vset(f->extent));

    for (int i = 0; i < 3; i++)
        w[i] = v3_dot(p->d, v3_set(edges.edge[i][0])) + v3_dot(l->moment, v3_set(edges.edge[i][1]));
    vd least = vmin(vmin(w[0], w[1]), w[2]), most = vmax(vmax(w[0], w[1]), w[2]);
    vm none = mof(f->any ? 0 : (1u << LANES) - 1);

    return (struct sides){mor(vlt(e, least), vlt(most, -e)), mor(none, mand(vlt(least, -e), vlt(e, most)))};
}

/* Returns the lanes whose rays return to the face on which they started. */
LANE_OP vm returns_to(const struct query *q, vd element)
{
    return mand(mand(from_object(q), from_element(q, element)), vlt(q->p->from.side, vset(0)));
}

/* Sets the distances of rays that return to their own face. They start at a height b over it, wherever on the face, so
 * that t is b/|D.N|, and its bound does not include eo. The fixed-point height is off by less than 2^-40: corners were
 * displaced by 2^-46 + 2^-59 z in two coordinates, z below 2^17, which moves the plane by 2^-41.4; the roundings of t
 * and of the point are eight units, 2^-42, that of b G is one. */
LANE_OP void return_to_face(const struct query *q, struct v3 n, vd round, vd more, struct flat *f, vd *ep, vm back)
{
    vd size = vsel(f->steep, vabs(v3_dot(q->p->d, n)), vset(1)),
       turn = BOUND_OF(PLANE_SLOPE, q->p->ed + BOUND(PLANE_WAY));
    vd t = -q->p->from.side / size,
       e = BOUND_OF(TRIANGLE_RETURN_DISTANCE,
                    (BOUND(TRIANGLE_RETURN) + round + BOUND(PLANE_HEIGHT_UNITS) + t * turn) / (size - turn)) +
           more;

    f->t = vsel(back, t, f->t);
    f->e = vsel(back, e, f->e);
    *ep = vsel(back, BOUND_OF(TRIANGLE_RETURN_POINT, q->p->eo + e + t * q->p->ed + BOUND(POINT_UNITS)), *ep);
}

LANE_OP void meet_plane_of(struct query *q, const double at[3], const double normal[3], double extent, uint32_t face,
                           struct sides sides)
{
    vd element = vset((double)face);

    if (!any(mand(q->active, mnot(mor(sides.outside, starts_on(q, element))))))
        return;
    struct v3 a = v3_sub(v3_set(at), q->p->o);
    vd l = v3_sum(a) + vset(extent), round = l * BOUND(TRIANGLE_AHEAD);
    vd more = BOUND(TRIANGLE_UNITS) + l * BOUND(TRIANGLE_QUOTIENT);
    struct flat flat = flat_meet(q->p, v3_set(normal), a, round, more);
    vd ep = BOUND_OF(PLANE_POINT, flat.e + BOUND(POINT_UNIT));
    vm back = returns_to(q, element);

    if (any(back))
        return_to_face(q, v3_set(normal), round, more, &flat, &ep, back);
    flat_report(q, &flat, sides.inside, sides.outside, ep, element);
}

LANE_OP void meet_face(struct query *q, const struct sure_face *f, uint32_t face)
{
    struct line line = line_of(q->p, f->at[0], f->extent);
    struct sides sides = face_sides(q->p, &line, f);

    if (any(mand(mnot(sides.outside), q->active)))
        meet_plane_of(q, f->at[0], f->normal, f->extent, face, sides);
}

#endif
