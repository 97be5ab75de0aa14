/* query_tmpl.h - rays, what they look for, and how a shape tells of a hit. */
#ifndef TIA_SIMD_RAYS_QUERY_TMPL_H
#define TIA_SIMD_RAYS_QUERY_TMPL_H

#include "vector_tmpl.h"

/* Rays as boxes know them, see slabs_tmpl.h, in floats: 1/d and (o +- pad)/d. Of each lane there are two, side by side,
 * one for each of two boxes. */
struct slabs {
    vp inv[3];
    vp in[3],
        out[3];   /* (o +- pad)/d: what the nearer planes need, and the farther ones; those of minima and of maxima, */
    bool uniform; /* unless all lanes agree on which are nearer: */
    int near[3];  /* rows 0 or 3 */
};

/* Where rays start, when that is an object's surface: b off it and surely moving away from it; -1: elsewhere.
 *
 * The integers' point may be eo from ours, but it lies on their surface: what they round by puts it off that by no more
 * than some 2^-30 (a face is 2^-48 of its distance off the plane of its corners, a sphere's point 2^-43 of its own; a
 * unit of a placed shape's axes is 2^-35 at most, as scales are 2^10 at most), and b is 2^-26 at least: samples' rays
 * and those of scenes with fine digits start that far off, others 2^-13 or, in larger units, less. A ray that goes on
 * straight starts b behind the point along itself; it must move away by 2^-2 of its length, or where b is 2^-20 or more
 * by 2^-6, which leaves 2^-28 and 2^-26. So their ray does not meet the same plane or face, nor, from outside, the same
 * convex solid; from inside it meets that where it leaves. Without this, nothing would be sure once eo is b.
 *
 * Where a normal is interpolated a mirrored ray may go into its face: the height that it comes from is known far better
 * than where it starts, see return_to_face. */
struct origin {
    vd object, element;
    vd side; /* inside a solid 1, outside 0; -b, where it surely goes back to the face */
};

/* Rays: the integers' origin is within eo of o, their direction within ed of d. */
struct packet {
    struct v3 o, d;
    vd eo, ed, pad; /* pad: how far they are apart anywhere in the scene, see slabs_tmpl.h */
    struct origin from;
    struct v3 inv; /* 1/d */
    struct slabs slabs;
};

/* Rays as lines: their moments O x D about a centre, and by what the side of an edge is off, see triangle_tmpl.h. */
struct line {
    struct v3 moment;
    const double *centre;
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

struct lines;
struct room;

struct query {
    const struct packet *p;
    struct room *room;         /* of the call, see walk_tmpl.h */
    const struct lines *lines; /* about the centre of a mesh */
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
    uint32_t work; /* so far, in items of cancel.h */
};

/* Lanes whose rays start on the object that is looked at, or on this part of one. */
LANE_OP vm from_object(const struct query *q)
{
    vd here = vset(q->object);

    return mand(vle(q->p->from.object, here), vle(here, q->p->from.object));
}

LANE_OP vm from_element(const struct query *q, vd element)
{
    return mand(vle(element, q->p->from.element), vle(q->p->from.element, element));
}

/* Lanes whose rays start on the object and move away from it. */
LANE_OP vm starts_here(const struct query *q)
{
    return mand(from_object(q), vle(vset(0), q->p->from.side));
}

LANE_OP vm starts_outside(const struct query *q)
{
    return mand(starts_here(q), vlt(q->p->from.side, vset(0.5)));
}

LANE_OP vm starts_inside(const struct query *q)
{
    return mand(from_object(q), vlt(vset(0.5), q->p->from.side));
}

/* What a shape tells: it is surely met at t, within e, the point there within ep; or it may be met, not before low. */
struct hit_report {
    vm sure, may;
    vd t, e, ep, low, element;
};

#endif
