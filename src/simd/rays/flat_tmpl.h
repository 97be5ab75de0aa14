/* flat_tmpl.h - intersection of rays with planes, discs, and flat lights.
 *
 * Parameters: the doubles of isa/isa.h. Defines: meet_plane(), meet_disc(), meet_flat_light(), flat_meet(),
 * flat_report(), starts_on(), struct flat. */
#ifndef TIA_SIMD_RAYS_FLAT_TMPL_H
#define TIA_SIMD_RAYS_FLAT_TMPL_H

#include "hit_report_tmpl.h"

/* Intersection with a plane: t = (P - O).N/(D.N). The numerator has the error eh = eo + 16 u |P - O|1 + 2 U and the
 * denominator es = ed + 16 u, so t has the error (eh + |t| es)/(|D.N| - es) and the quotient's rounding. `steep` is
 * false in lanes whose rays are nearly parallel to the plane, which are undecided. */
struct flat {
    vm steep;
    vd t, e;
};

LANE_OP struct flat flat_meet(const struct packet *p, struct v3 n, struct v3 way, vd round, vd more)
{
    vd slope = v3_dot(p->d, n), size = vabs(slope), eslope = BOUND_OF(PLANE_SLOPE, p->ed + BOUND(PLANE_WAY));
    struct flat f;

    f.steep = vlt(vset(BOUND(PLANE_STEEP)) + eslope, size);
    size = vsel(f.steep, size, vset(1));
    f.t = v3_dot(way, n) / vsel(f.steep, slope, vset(1));
    f.e = BOUND_OF(PLANE_DISTANCE, (p->eo + round + BOUND(PLANE_HEIGHT_UNITS) + vabs(f.t) * eslope) / (size - eslope)) +
          more;
    return f;
}

/* Returns the lanes whose rays start on the tested plane or face and move away from it. */
LANE_OP vm starts_on(const struct query *q, vd element)
{
    return mand(starts_here(q), from_element(q, element));
}

/* Reports hits. `inside` and `outside` are the lanes whose point is certainly inside or certainly outside the shape's
 * area. Within the plane the point is off by no more than t, and from the plane by no more than the fixed-point
 * rounding. */
LANE_OP void flat_report(struct query *q, const struct flat *f, vm inside, vm outside, vd ep, vd element)
{
    vm own = starts_on(q, element);
    vm not = mor(mor(own, outside), mand(f->steep, vlt(f->t + f->e, vset(0))));
    vm sure = mand(mand(mand(f->steep, inside), vlt(f->e, f->t)), mnot(not ));

    report_hit(q, (struct hit_report){.sure = sure,
                                      .may = mnot(mor(sure, not )),
                                      .t = f->t,
                                      .e = f->e,
                                      .ep = ep,
                                      .low = vsel(f->steep, vmax(f->t - f->e, vset(0)), vset(0)),
                                      .element = element});
}

/* Returns the lanes whose plane is certainly behind the origin: N.(P - O) and D.N have opposite signs. The error of
 * N.(P - O) is larger by another 2 U here, for fixed-point quotients that are rounded to 0. */
LANE_OP vm flat_behind(const struct packet *p, struct v3 n, struct v3 way, vd round)
{
    vd slope = v3_dot(p->d, n), turn = BOUND_OF(PLANE_SLOPE, p->ed + BOUND(PLANE_WAY)), height = v3_dot(way, n);
    vd eheight = BOUND_OF(PLANE_BEHIND, p->eo + round + BOUND(PLANE_BEHIND_UNITS));

    return mor(mand(vlt(eheight, height), vlt(slope, -turn)), mand(vlt(height, -eheight), vlt(turn, slope)));
}

/* Intersects a plane, which ends where the size of a coordinate reaches 2^16. */
LANE_OP void meet_plane(struct query *q, const struct sure_object *o)
{
    struct v3 way = v3_sub(v3_set(o->at), q->p->o);
    vd round = v3_sum(way) * BOUND(PLANE_WAY);
    vm behind = flat_behind(q->p, v3_set(o->normal), way, round);

    if (!any(mand(q->active, mnot(mor(behind, starts_here(q))))))
        return;
    struct flat f = flat_meet(q->p, v3_set(o->normal), way, round, vset(BOUND(QUOTIENT_UNIT)));
    f.e = f.e + vabs(f.t) * BOUND(QUOTIENT);
    struct v3 point = v3_along(q->p->o, q->p->d, f.t);
    vd far = vmax(vmax(vabs(point.x), vabs(point.y)), vabs(point.z)),
       e = BOUND_OF(PLANE_FAR, f.e + vabs(f.t) * q->p->ed + q->p->eo);
    vm near = vlt(far + e, vset(65535)), beyond = mand(f.steep, vlt(vset(65537), far - e));

    flat_report(q, &f, near, beyond, BOUND_OF(PLANE_POINT, f.e + BOUND(POINT_UNIT)), vset(0));
}

/* Decides which points are within `radius` of the disc's centre C, and reports them; O + t D - C has the error e. */
LANE_OP void round_flat(struct query *q, const struct flat *f, struct v3 way, double radius, vd element)
{
    const struct packet *p = q->p;
    struct v3 at = v3_sub(v3_scale(p->d, f->t), way);
    vd l1 = v3_sum(way),
       e = BOUND_OF(DISC_PLACE, f->e + BOUND(POINT_UNITS) + p->eo + (l1 + vabs(f->t)) * BOUND(DISC_PLACE_ROUNDING) +
                                    vabs(f->t) * p->ed);
    vd r = vset(radius), square = v3_dot(at, at), less = vmax(r - e, vset(0)), more = r + e;
    vm in = vlt(square * (1 + BOUND(DISC_SQUARE)), less * less);
    vm out = mand(f->steep, vlt(more * more, square * (1 - BOUND(DISC_SQUARE))));

    flat_report(q, f, in, out, BOUND_OF(PLANE_POINT, f->e + BOUND(POINT_UNIT)), element);
}

LANE_OP void meet_disc(struct query *q, const struct sure_object *o)
{
    struct v3 way = v3_sub(v3_set(o->at), q->p->o);
    struct flat f = flat_meet(q->p, v3_set(o->normal), way, v3_sum(way) * BOUND(PLANE_WAY), vset(BOUND(QUOTIENT_UNIT)));

    f.e = f.e + vabs(f.t) * BOUND(QUOTIENT);
    round_flat(q, &f, way, o->radius, vset(0));
}

/* Intersects a rectangle light: compares the point's components along `across` with those of the half sides. */
LANE_OP void meet_rectangle(struct query *q, const struct sure_light *l, const struct flat *f, struct v3 way)
{
    const struct packet *p = q->p;
    struct v3 at = v3_sub(v3_scale(p->d, f->t), way);
    vd l1 = v3_sum(way),
       e = BOUND_OF(RECTANGLE_PLACE, f->e + BOUND(POINT_UNITS) + p->eo +
                                         (l1 + vabs(f->t)) * BOUND(RECTANGLE_PLACE_ROUNDING) + vabs(f->t) * p->ed);
    vd a = vabs(v3_dot(at, v3_set(l->across[0]))), b = vabs(v3_dot(at, v3_set(l->across[1])));
    vd ra = vset(l->reach[0]), rb = vset(l->reach[1]);
    vm in = mand(vlt(a + e, ra), vlt(b + e, rb)), out = mor(vlt(ra, a - e), vlt(rb, b - e));

    flat_report(q, f, in, mand(f->steep, out), f->e, vset(0));
}

LANE_OP void meet_flat_light(struct query *q, const struct sure_light *l)
{
    struct v3 way = v3_sub(v3_set(l->at), q->p->o);
    struct flat f = flat_meet(q->p, v3_set(l->normal), way, v3_sum(way) * BOUND(PLANE_WAY), vset(BOUND(QUOTIENT_UNIT)));

    f.e = f.e + vabs(f.t) * BOUND(QUOTIENT);
    if (tia_light_has(l->from->kind, TIA_LIGHT_SIDES))
        meet_rectangle(q, l, &f, way);
    else
        round_flat(q, &f, way, l->radius, vset(0));
}

#endif
