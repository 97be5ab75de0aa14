/* box_tmpl.h - intersection of rays with boxes by slabs, as in geometry/box.c.
 *
 * Parameters: the doubles of isa/isa.h. Defines: meet_box().
 *
 * A plane across an axis is met at t = (plane - o)/d, with the error (eo + 4 u (|plane| + |o|) + 2 U + |t| (ed + 4
 * u))/(|d| - ed) + U. Along an axis in which the ray hardly moves, these times are undecided. Even then, the slab is
 * decided if the ray is certainly between the two planes, or certainly outside them, up to the far end of the box. */
#ifndef TIA_SIMD_RAYS_BOX_TMPL_H
#define TIA_SIMD_RAYS_BOX_TMPL_H

#include "hit_report_tmpl.h"

/* The times at which a ray enters and leaves a slab, with their errors; valid in the lanes of `fine`. */
struct slab_times {
    vd in, out, ein, eout;
    vm fine, apart; /* apart: the ray is certainly never between the planes */
    vm back;
};

LANE_OP vd plane_bound(const struct packet *p, vd t, vd round, vd over)
{
    return BOUND_OF(SLAB_TIME, (p->eo + round + vabs(t) * (p->ed + BOUND(SLAB))) * over) + BOUND(QUOTIENT_UNIT);
}

LANE_OP struct slab_times slab_times_of(const struct packet *p, vd o, vd d, vd inv, double min, double max, vd reach)
{
    vd size = vabs(d),
       round = (vabs(o) + vset(__builtin_fabs(min) + __builtin_fabs(max))) * BOUND(SLAB_PLANE) + BOUND(SLAB_UNITS);
    vm steep = vlt(BOUND(SLAB_TURN) * p->ed + vset(BOUND(SLAB_STEEP)), size);
    vd over = vabs(inv) * BOUND(SLAB_OVER), off = BOUND_OF(SLAB_LEVEL, p->eo + reach * (p->ed + size) + round);
    vd first = (vset(min) - o) * inv, second = (vset(max) - o) * inv;
    vm between = mand(vlt(vset(min) + off, o), vlt(o, vset(max) - off));
    vm beside = mor(vlt(o + off, vset(min)), vlt(vset(max) + off, o));
    struct slab_times s = {.back = vlt(d, vset(0)), .fine = mor(steep, between), .apart = mand(mnot(steep), beside)};

    s.in = vsel(steep, vsel(s.back, second, first), vset(-INFINITE));
    s.out = vsel(steep, vsel(s.back, first, second), vset(INFINITE));
    s.ein = vsel(steep, plane_bound(p, s.in, round, over), vset(0));
    s.eout = vsel(steep, plane_bound(p, s.out, round, over), vset(0));
    return s;
}

/* The slab with the largest time: the one entered last or, with negated times, the one left first. `sure`: this time is
 * certainly the largest. */
struct slab_last {
    vd t, e, axis;
    vm sure;
};

LANE_OP struct slab_last slab_last_of(const vd t[3], const vd e[3])
{
    vm first = mand(vlt(t[1], t[0]), vlt(t[2], t[0])), second = mand(mnot(first), vlt(t[2], t[1]));
    struct slab_last last = {.t = vsel(first, t[0], vsel(second, t[1], t[2])),
                             .e = vsel(first, e[0], vsel(second, e[1], e[2])),
                             .axis = vsel(first, vset(0), vsel(second, vset(1), vset(2)))};

    last.sure = mnot(mnone());
    for (int i = 0; i < 3; i++) {
        vm self = mand(vle(last.axis, vset(i)), vle(vset(i), last.axis));
        last.sure = mand(last.sure, mor(self, vlt(t[i] + e[i], last.t - last.e)));
    }
    return last;
}

/* Returns 1 in lanes whose ray moves from the maximum to the minimum along `axis`, else 0. */
LANE_OP vd comes_back(const struct slab_times s[3], vd axis)
{
    vm back = mor(
        mand(s[0].back, vlt(axis, vset(0.5))),
        mor(mand(s[1].back, mand(vlt(vset(0.5), axis), vlt(axis, vset(1.5)))), mand(s[2].back, vlt(vset(1.5), axis))));

    return vsel(back, vset(1), vset(0));
}

LANE_OP void meet_box(struct query *q, const double min[3], const double max[3])
{
    const struct packet *p = q->p;
    const vd o[3] = {p->o.x, p->o.y, p->o.z}, d[3] = {p->d.x, p->d.y, p->d.z};
    struct v3 centre = {vset((min[0] + max[0]) / 2), vset((min[1] + max[1]) / 2), vset((min[2] + max[2]) / 2)};
    vd reach = v3_sum(v3_sub(p->o, centre)) + vset((max[0] - min[0] + max[1] - min[1] + max[2] - min[2]) / 2);
    const vd inv[3] = {p->inv.x, p->inv.y, p->inv.z};
    vd in[3], ein[3], out[3], eout[3];
    struct slab_times s[3];
    vm fine = mnot(mnone()), miss = starts_outside(q), inside = fine, meets = fine;

    for (int i = 0; i < 3; i++) {
        s[i] = slab_times_of(p, o[i], d[i], inv[i], min[i], max[i], reach);
        in[i] = s[i].in;
        ein[i] = s[i].ein;
        out[i] = -s[i].out; /* negated, so that the slab left first has the largest time */
        eout[i] = s[i].eout;
        fine = mand(fine, s[i].fine);
        miss = mor(miss, s[i].apart);
    }
    struct slab_last enters = slab_last_of(in, ein), leaves = slab_last_of(out, eout);
    for (int i = 0; i < 3; i++) {
        inside = mand(inside, vlt(in[i] + ein[i], vset(0)));
        miss = mor(miss, mand(s[i].fine, vlt(eout[i] - out[i], vset(0))));
        for (int j = 0; j < 3; j++) {
            miss = mor(miss, mand(mand(s[i].fine, s[j].fine), vlt(eout[j] - out[j], in[i] - ein[i])));
            meets = mand(meets, mor(mof(i == j ? (1u << LANES) - 1 : 0), vlt(in[i] + ein[i], -out[j] - eout[j])));
        }
    }
    inside = mor(inside, starts_inside(q));
    vm outside = mand(mand(enters.sure, vlt(enters.e, enters.t)), mnot(inside));
    vm leaving = mand(inside, mand(leaves.sure, vlt(leaves.t, -leaves.e)));
    vm sure = mand(mand(fine, mnot(miss)), mor(mand(outside, meets), leaving));
    vd t = vsel(leaving, -leaves.t, enters.t), e = vsel(leaving, leaves.e, enters.e);
    vd axis = vsel(leaving, leaves.axis, enters.axis), back = comes_back(s, axis);

    report_hit(q, (struct hit_report){.sure = sure,
                                      .may = mnot(mor(sure, miss)),
                                      .t = t,
                                      .e = e,
                                      .ep = BOUND_OF(POINT, e + p->eo + vabs(t) * p->ed + BOUND(POINT_UNIT)),
                                      .low = vmax(vsel(fine, enters.t - enters.e, vset(0)), vset(0)),
                                      .element = 2 * axis + vsel(leaving, 1 - back, back)});
}

#endif
