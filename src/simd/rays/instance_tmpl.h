/* instance_tmpl.h - rays transformed to the axes of an instance, and their hits transformed to the world:
 * geometry/instance.c in doubles.
 *
 * Parameters: the doubles of isa/isa.h. Defines: place_rays(), placed_query(), report_placed(), struct placed.
 *
 * The vector v = O - p has, along the axes, the error eo, its roundings and less than two units. Divided by the least
 * scale, this is the error of the origin in the instance's axes. The fixed-point code first moves the ray's origin to
 * the box, by `start`. This turns the ray by up to 2^-57, which displaces v by 2^-57 of the box's distance; the
 * roundings of v include that. The direction (D.a_i)/s_i, before it is normalised, and its length k have the error (ed
 * + 2^-49) over the least scale. A distance t in the instance's axes is t/k in the world, with the error
 *
 *     |t/k - t'/k'| <= |t - t'|/k + t' |1/k - 1/k'| <= e/k + (t + e) ek/(k (k - ek)).
 *
 * For ek < k/16 this is at most e/k + 1.07 (t + e) ek/k^2.
 *
 * A ray that starts b below the tangent plane in the world also starts below it in the instance's axes, but not along
 * the normal: a stretched sphere or cylinder may be so thin at this point that the ray starts outside and enters the
 * shape again. Only for a box, whose normals keep their directions, do such rays certainly leave it or miss it. */
#ifndef TIA_SIMD_RAYS_INSTANCE_TMPL_H
#define TIA_SIMD_RAYS_INSTANCE_TMPL_H

#include "hit_report_tmpl.h"
#include "slabs_tmpl.h"

struct placed {
    struct packet p;
    vd k, ek;
    vm fine;
};

static void place_rays(const struct sure_instance *i, const struct packet *p, bool box, vm active, struct placed *to)
{
    struct v3 a[3] = {v3_set(i->axes[0]), v3_set(i->axes[1]), v3_set(i->axes[2])},
              v = v3_sub(p->o, v3_set(i->position));
    vd over = vset(1 / i->least), size = v3_sum(v) + vset(i->size);

    to->p.o = (struct v3){v3_dot(v, a[0]) * vset(i->inverse[0]), v3_dot(v, a[1]) * vset(i->inverse[1]),
                          v3_dot(v, a[2]) * vset(i->inverse[2])};
    to->p.eo = BOUND_OF(INSTANCE_PLACE, (p->eo + size * BOUND(INSTANCE_ORIGIN) + BOUND(INSTANCE_UNITS)) * over) +
               BOUND(INSTANCE_SCALED_UNITS) + v3_sum(to->p.o) * BOUND(INSTANCE_SCALED);
    struct v3 d = {v3_dot(p->d, a[0]) * vset(i->inverse[0]), v3_dot(p->d, a[1]) * vset(i->inverse[1]),
                   v3_dot(p->d, a[2]) * vset(i->inverse[2])};
    to->ek = BOUND_OF(INSTANCE_LENGTH, (p->ed + vset(BOUND(INSTANCE_DIRECTION))) * over);
    to->k = vsqrt(v3_dot(d, d));
    to->p.d = v3_unit(d, to->ek, &to->p.ed);
    to->p.from = p->from;
    if (!box && i->least < i->most)
        to->p.from.object = vsel(vlt(vset(0.5), p->from.side), vset(-1), p->from.object);
    to->p.from.object = vsel(vlt(p->from.side, vset(0)), vset(-1), to->p.from.object); /* b differs in these axes */
    to->fine = mand(packet_start(i->centre, i->extent, &to->p, active), vlt(BOUND(INSTANCE_KNOWN) * to->ek, to->k));
}

/* Sets the query in the instance's axes, which is always one for the nearest hit. */
LANE_OP void placed_query(const struct query *q, const struct placed *placed, struct query *inner)
{
    *inner = *q;
    inner->p = &placed->p;
    inner->active = mand(q->active, placed->fine);
    inner->any = false;
    inner->groups = NULL;
    inner->limit =
        q->limit * (placed->k + placed->ek) * BOUND(INSTANCE_LIMIT) + placed->p.eo + BOUND(INSTANCE_LIMIT_MORE);
    inner->t = inner->low = vset(INFINITE);
    inner->e = inner->ep = vset(0);
    inner->id = inner->element = vset(-1);
}

/* Reports hits in the world. The error of the point is at most `most` times that in the instance's axes, and at most
 * the sum of the errors of the ray and of the distance along it; the smaller bound is used. */
static void report_placed(struct query *q, const struct placed *placed, const struct query *inner, double most)
{
    const struct packet *p = q->p;
    vm met = vlt(inner->t, vset(INFINITE)), sure = mand(met, vlt(inner->t + inner->e, inner->low));
    vm wild = mand(q->active, mnot(placed->fine)), may = mand(mnot(sure), mor(met, vlt(inner->low, vset(INFINITE))));
    vd least = vmin(inner->low, vsel(met, inner->t - inner->e, vset(INFINITE))),
       over = 1 / vsel(wild, vset(1), placed->k);
    vd t = vsel(met, inner->t, vset(0)) * over, ratio = placed->ek * over;
    vd e = BOUND_OF(INSTANCE_DISTANCE, inner->e * over * (1 + BOUND(INSTANCE_RATIO) * ratio) +
                                           BOUND(INSTANCE_RATIO) * t * ratio + BOUND(INSTANCE_DISTANCE_UNITS) +
                                           t * BOUND(INSTANCE_DISTANCE_ROUNDING));
    vd low = vsel(vlt(least, vset(INFINITE)),
                  least * over * (1 - BOUND(INSTANCE_LOW) * ratio) - BOUND(INSTANCE_DISTANCE_UNITS), vset(INFINITE));

    report_hit(q, (struct hit_report){.sure = mand(sure, mnot(wild)),
                                      .may = mor(may, wild),
                                      .t = t,
                                      .e = e,
                                      .ep = vmin(BOUND_OF(INSTANCE_POINT, inner->ep * vset(most) + p->eo +
                                                                              t * BOUND(INSTANCE_DISTANCE_ROUNDING) +
                                                                              BOUND(INSTANCE_POINT_UNITS)),
                                                 BOUND_OF(POINT, p->eo + e + t * p->ed + BOUND(POINT_UNITS))),
                                      .low = vmax(vsel(wild, vset(0), low), vset(0)),
                                      .element = inner->element});
}

#endif
