/* triangle_tmpl.h - triangles and the faces of meshes.
 *
 * Parameters: the doubles of isa/isa.h. Defines: meet_face(), meet_plane_of(), face_sides(), line_of(), struct sides.
 *
 * With a, b from the origin to two corners, D.(a x b) has the sign of the fixed-point area, sheared along the ray,
 * times that of D's main component. It is D.(a x (b - a)): an origin that is off by eo moves a, not the edge, so it
 * changes by |b - a| eo; a direction that is off by ed changes it by ed |a| |b - a|. Edges are no longer than twice the
 * extent; corners no farther than `far`, the origin's |x| + |y| + |z| from a centre and the most of a corner's, R.
 *
 * Of A, B and O from that centre it is D.(A x B) + (O x D).(B - A), of which A x B and B - A are the face's and O x D
 * the ray's. Roundings: the sizes of the former's terms add up to R^2 at most, those of the latter's to |O| 2 R, in all
 * far^2. A term of the former is rounded by its product and difference, then by the product with D and five sums; one
 * of the latter by the centre's difference, then as often: nine times. The fixed-point corners are aside by 2^-46 +
 * 2^-59 z, in coordinates below 2 far, so their areas by 8 far (2^-46 + 2^-59 far): far 2^-42, and far less than the
 * doubles' own part. Inside: all three are certainly of one sign.
 *
 * t comes from the plane here, from a weighted mean of the corners there: that is off the plane by no more than its
 * corners are (geometry/triangle.c), l 2^-48. */
#ifndef TIA_SIMD_RAYS_TRIANGLE_TMPL_H
#define TIA_SIMD_RAYS_TRIANGLE_TMPL_H

#include "flat_tmpl.h"

/* The sides of a face's edges: the side on which each line passes. */
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

/* Reports the hits of rays that return to their face. They start at a height b that does not depend on the place on the
 * face, so that t is b/|D.N|, and eo is no part of its bound. Error of the fixed-point height: corners were aside by
 * 2^-46 + 2^-59 z, in two coordinates, z below 2^17, which is 2^-41.4 of the plane; t by some units, eight with the
 * point's roundings, 2^-42; and b G by one: less than 2^-40. */
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

LANE_OP void meet_plane_of(struct query *q, const struct sure_face *f, uint32_t face, struct sides sides)
{
    vd element = vset((double)face);

    if (!any(mand(q->active, mnot(mor(sides.outside, starts_on(q, element))))))
        return;
    struct v3 a = v3_sub(v3_set(f->at[0]), q->p->o);
    vd l = v3_sum(a) + vset(f->extent), round = l * BOUND(TRIANGLE_AHEAD);
    vd more = BOUND(TRIANGLE_UNITS) + l * BOUND(TRIANGLE_QUOTIENT);
    struct flat flat = flat_meet(q->p, v3_set(f->normal), a, round, more);
    vd ep = BOUND_OF(PLANE_POINT, flat.e + BOUND(POINT_UNIT));
    vm back = returns_to(q, element);

    if (any(back))
        return_to_face(q, v3_set(f->normal), round, more, &flat, &ep, back);
    flat_report(q, &flat, sides.inside, sides.outside, ep, element);
}

LANE_OP void meet_face(struct query *q, const struct sure_face *f, uint32_t face)
{
    struct line line = line_of(q->p, f->at[0], f->extent);
    struct sides sides = face_sides(q->p, &line, f);

    if (any(mand(mnot(sides.outside), q->active)))
        meet_plane_of(q, f, face, sides);
}

#endif
