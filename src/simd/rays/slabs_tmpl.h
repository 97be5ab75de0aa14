/* slabs_tmpl.h - the box test of the hierarchy, in floats.
 *
 * Parameters: the doubles and pairs of floats of isa/isa.h. Defines: packet_start(), enter_two(), lanes_of(), up().
 *
 * The certified and the fixed-point ray are at most `pad` apart everywhere in the scene. So if the fixed-point ray
 * enters a box, the certified ray enters the box enlarged by pad. (o +- pad)/d in place of o/d is such an enlargement.
 * Components of d below 2^-60 are replaced by 2^-60. This turns the ray and moves it by up to 2^-43, far less than the
 * last term of pad.
 *
 * For a plane at b, floats compute b inv - c. The errors, with v = 2^-24, are v |b inv| each for inv and for the
 * product, v |c| for c, and v of the difference. As a distance of the plane this is v (2 |b| + |c/inv| + |b - c/inv|)
 * <= v (3 |b| + 2 |o|), and terms of second order. As |b - o| is at most `reach`, |b| <= |o| + reach. So the error is
 * below 8 v (|o| + reach). The last term of pad, 2^-21 (|o| + reach), covers this and the roundings of doubles. Boxes
 * are rounded outward and limits up. So the computed entry into a box is never behind that of the fixed-point ray.
 *
 * Fixed-point roundings of intersections need no margin here: boxes are larger than their contents by 2^-16
 * (tia_bounds_with_margin), and roundings move no intersection as far as 2^-30 out of a shape. */
#ifndef TIA_SIMD_RAYS_SLABS_TMPL_H
#define TIA_SIMD_RAYS_SLABS_TMPL_H

#include "query_tmpl.h"

/* Prepares a packet for the boxes of a scene or an instance, which lie within one box around `centre`; `extent` is the
 * sum of its half axes. False in lanes whose error is too large for a margin around the ray. */
LANE_OP vm packet_start(const double centre[3], double extent, struct packet *p, vm active)
{
    vd tiny = vset(BOUND(SLABS_TINY)), zero = vset(0);
    const vd o[3] = {p->o.x, p->o.y, p->o.z},
             d[3] = {vsel(vlt(vabs(p->d.x), tiny), tiny, p->d.x), vsel(vlt(vabs(p->d.y), tiny), tiny, p->d.y),
                     vsel(vlt(vabs(p->d.z), tiny), tiny, p->d.z)};
    vd size = v3_sum(p->o), reach = v3_sum(v3_sub(p->o, v3_set(centre))) + vset(extent);
    vd off = BOUND_OF(SLABS_APART, p->eo + reach * p->ed), pad = off + (size + reach) * BOUND(SLABS_FLOATS);
    struct slabs *s = &p->slabs;
    unsigned all = mbits(active);

    p->pad = pad;
    s->uniform = true;
    for (int i = 0; i < 3; i++) {
        unsigned back = mbits(vlt(d[i], zero)) & all;
        s->uniform = s->uniform && (back == 0 || back == all);
        s->near[i] = back ? 3 : 0;
    }
    p->inv = (struct v3){1 / d[0], 1 / d[1], 1 / d[2]};
    const vd inv[3] = {p->inv.x, p->inv.y, p->inv.z};
    for (int i = 0; i < 3; i++) {
        vd middle = o[i] * inv[i], aside = pad * (s->uniform ? vabs(inv[i]) : inv[i]);
        s->inv[i] = vp_of(inv[i]);
        s->in[i] = vp_of(middle + aside);
        s->out[i] = vp_of(middle - aside);
    }
    return vlt(off, vset((extent + BOUND(SLABS_LEAST)) * BOUND(SLABS_WIDE)));
}

/* Returns a limit with a margin for its conversion to a float, so that a box within the limit is within it in floats
 * too. */
LANE_OP vd up(vd limit)
{
    return limit + vabs(limit) * BOUND(SLABS_LIMIT);
}

/* Returns the lanes that may enter a node's children before their limits, two bits per lane. *near receives the
 * distances of the entries. */
LANE_OP unsigned enter_two(const struct slabs *s, const struct sure_node *n, vp limit, vp *near)
{
#define PLANE(i) vp_load(n->box[i])
    vp in, out;

    if (s->uniform) {
        int x = s->near[0], y = s->near[1], z = s->near[2];
        in = vp_max(vp_max(PLANE(x) * s->inv[0] - s->in[0], PLANE(y + 1) * s->inv[1] - s->in[1]),
                    vp_max(PLANE(z + 2) * s->inv[2] - s->in[2], vp_set(0)));
        out = vp_min(vp_min(PLANE(3 - x) * s->inv[0] - s->out[0], PLANE(4 - y) * s->inv[1] - s->out[1]),
                     vp_min(PLANE(5 - z) * s->inv[2] - s->out[2], limit));
    } else {
        vp ax = PLANE(0) * s->inv[0] - s->in[0], bx = PLANE(3) * s->inv[0] - s->out[0];
        vp ay = PLANE(1) * s->inv[1] - s->in[1], by = PLANE(4) * s->inv[1] - s->out[1];
        vp az = PLANE(2) * s->inv[2] - s->in[2], bz = PLANE(5) * s->inv[2] - s->out[2];
        in = vp_max(vp_max(vp_min(ax, bx), vp_min(ay, by)), vp_max(vp_min(az, bz), vp_set(0)));
        out = vp_min(vp_min(vp_max(ax, bx), vp_max(ay, by)), vp_min(vp_max(az, bz), limit));
    }
    *near = in;
    return vp_le(in, out);
#undef PLANE
}

/* Returns one float of each pair: the first if `place` is 0, the second if it is 1. */
LANE_OP vd lanes_of(vp pairs, int place)
{
    float of[2 * LANES];
    double lanes[LANES];

    __builtin_memcpy(of, &pairs, sizeof of);
    for (int k = 0; k < LANES; k++)
        lanes[k] = of[2 * k + place];
    return vload(lanes);
}

#endif
