/* query.h - rays, what they look for, and how a shape tells of a hit. */
#ifndef TIA_LEVELS_RAYS_QUERY_H
#define TIA_LEVELS_RAYS_QUERY_H

#include "vector.h"

/* Where rays start, when that is an object's surface: b off it and surely moving away from it; -1: elsewhere.
 *
 * The integers' point may be eo from ours, but it lies on their surface: what they round by puts it off that by no more
 * than some 2^-30 (a face is 2^-48 of its distance off the plane of its corners, a sphere's point 2^-43 of its own),
 * and b is 2^-26 at least: samples' rays start that far off, others 2^-20. A ray that goes on straight starts b behind
 * the point along itself; it must move away by 2^-2 of its length, or where b is 2^-20 by 2^-6, which leaves 2^-28 and
 * 2^-26. So their ray does not meet the same plane or face, nor, from outside, the same convex solid;
 * from inside it meets that where it leaves. Without this, nothing would be sure once eo is b. */
struct origin {
    vd object, element, inside; /* inside a solid: 1, else 0 */
};

/* Rays: the integers' origin is within eo of o, their direction within ed of d. */
struct pack {
    struct v3 o, d;
    vd eo, ed;
    struct origin from;
    struct v3 inv, low, high; /* 1/d and (o +- pad)/d, pad being how far the ray is off anywhere in the scene */
    int near[3];              /* of all lanes the nearer planes: 0 or 3 */
    bool uniform;             /* all lanes agree on that; then in and out are what of low and high is for the nearer */
    struct v3 in, out;        /* planes, and for the farther ones */
};

/* Rays as lines: their moments O x D about a centre, and by what the side of an edge is off, see triangle.h. */
struct line {
    struct v3 moment;
    vd e, each;
};

/* Nearest: t, e are those of the best hit; `low` is the least t - e of every other hit, and of what may be hit. The
 * best one is sure when t + e < low in the end: hits behind the best one may be as unsure as they like. Equal
 * distances are never sure: the lower index wins with the integers.
 *
 * Any: blocked, where something opaque is surely met before the distance; maybe, where that is not known. */
#define GROUPS 16

/* The groups of a mesh that each ray met. */
struct group_list {
    uint32_t group[LANES][GROUPS];
    bool sure[LANES][GROUPS];
    int count[LANES];
    unsigned full; /* lanes with more than GROUPS */
};

struct query {
    const struct pack *p;
    struct line line; /* about the centre of a mesh */
    vm active;
    vd limit; /* what is farther does not count, for sure */
    bool any;
    bool solid; /* of any: nothing is seen through objects, but perhaps where they have an opacity */
    double object;
    bool opaque;
    vd t, e, ep, low; /* ep: of the point */
    vd id, element;
    vd distance, edistance;
    vm blocked, maybe, met, may_meet; /* the latter two of one object that filters light */
    vd through[3], ethrough;
    uint32_t index, blocker;
    struct group_list *groups; /* NULL, or receives `group` of each hit */
    uint32_t group;
};

/* Lanes whose rays start on the object that is looked at. */
LANE_OP vm starts_here(const struct query *q)
{
    vd here = vset(q->object);

    return mand(vle(q->p->from.object, here), vle(here, q->p->from.object));
}

LANE_OP vm starts_outside(const struct query *q)
{
    return mand(starts_here(q), vlt(q->p->from.inside, vset(0.5)));
}

LANE_OP vm starts_inside(const struct query *q)
{
    return mand(starts_here(q), vlt(vset(0.5), q->p->from.inside));
}

/* What a shape tells: it is surely met at t, within e, the point there within ep; or it may be met, not before low. */
struct report {
    vm sure, may;
    vd t, e, ep, low, element;
};

/* Makes a pack ready for the boxes of a scene, or of a mesh: around a centre, the sum of the half axes being `extent`.
 * False in lanes whose rays are too far off for a margin around them. Where the doubles' ray and the integers' differ
 * by `pad` everywhere in the scene, a box enlarged by pad is entered by the one if the box is by the other; taking (o
 * +- pad)/d in place of o/d does that. d is at least 2^-60 in size: a ray that is turned by so little is moved by
 * 2^-43, far less than pad's last term. That term is for the products with 1/d: b inv - c is off by u (|b| + |o|)
 * |inv|, which as a distance of the plane is u (|b| + |o|).
 *
 * What the integers round by when they meet a shape needs no room here: boxes are larger than what is in them by 2^-16
 * (tia_bounds_with_margin), and no shape is met 2^-30 beside itself. */
LANE_OP vm pack_start(const double centre[3], double extent, struct pack *p, vm active)
{
    vd tiny = vset(SURE_2(60)), zero = vset(0);
    struct v3 d = {vsel(vlt(vabs(p->d.x), tiny), tiny, p->d.x), vsel(vlt(vabs(p->d.y), tiny), tiny, p->d.y),
                   vsel(vlt(vabs(p->d.z), tiny), tiny, p->d.z)};
    vd size = v3_sum(p->o), reach = v3_sum(v3_sub(p->o, v3_set(centre))) + vset(extent);
    vd pad = p->eo + reach * p->ed + (size + reach) * SURE_2(50);

    p->inv = (struct v3){1 / d.x, 1 / d.y, 1 / d.z};
    p->low = (struct v3){(p->o.x - pad) * p->inv.x, (p->o.y - pad) * p->inv.y, (p->o.z - pad) * p->inv.z};
    p->high = (struct v3){(p->o.x + pad) * p->inv.x, (p->o.y + pad) * p->inv.y, (p->o.z + pad) * p->inv.z};
    unsigned all = mbits(active);
    unsigned back[3] = {mbits(vlt(d.x, zero)) & all, mbits(vlt(d.y, zero)) & all, mbits(vlt(d.z, zero)) & all};
    p->uniform = true;
    for (int i = 0; i < 3; i++) {
        p->uniform = p->uniform && (back[i] == 0 || back[i] == all);
        p->near[i] = back[i] ? 3 : 0;
    }
    p->in = (struct v3){back[0] ? p->low.x : p->high.x, back[1] ? p->low.y : p->high.y, back[2] ? p->low.z : p->high.z};
    p->out =
        (struct v3){back[0] ? p->high.x : p->low.x, back[1] ? p->high.y : p->low.y, back[2] ? p->high.z : p->low.z};
    return vlt(pad, vset((extent + SURE_2(10)) * SURE_2(9)));
}

/* Lanes that may enter a box before their limit, and where. */
LANE_OP vm box_enter(const struct query *q, const double box[6], vd *near)
{
    const struct pack *p = q->p;
    vd in, out;

    if (p->uniform) {
        int x = p->near[0], y = p->near[1], z = p->near[2];
        in = vmax(vmax(vset(box[x]) * p->inv.x - p->in.x, vset(box[y + 1]) * p->inv.y - p->in.y),
                  vmax(vset(box[z + 2]) * p->inv.z - p->in.z, vset(0)));
        out = vmin(vmin(vset(box[3 - x]) * p->inv.x - p->out.x, vset(box[4 - y]) * p->inv.y - p->out.y),
                   vmin(vset(box[5 - z]) * p->inv.z - p->out.z, q->limit));
    } else {
        vd ax = vset(box[0]) * p->inv.x - p->high.x, bx = vset(box[3]) * p->inv.x - p->low.x;
        vd ay = vset(box[1]) * p->inv.y - p->high.y, by = vset(box[4]) * p->inv.y - p->low.y;
        vd az = vset(box[2]) * p->inv.z - p->high.z, bz = vset(box[5]) * p->inv.z - p->low.z;
        in = vmax(vmax(vmin(ax, bx), vmin(ay, by)), vmax(vmin(az, bz), vset(0)));
        out = vmin(vmin(vmax(ax, bx), vmax(ay, by)), vmin(vmax(az, bz), q->limit));
    }
    *near = in;
    return mand(vle(in, out), q->active);
}

#endif
