/* query_tmpl.h - packets of rays, their queries, and the report of a hit.
 *
 * Parameters: the doubles and pairs of floats of isa/isa.h. Defines: struct packet, struct query, struct hit_report,
 * struct origin, struct slabs, struct line, struct group_list, from_object(), from_element(), starts_here(),
 * starts_outside(), starts_inside(), GROUPS. */
#ifndef TIA_SIMD_RAYS_QUERY_TMPL_H
#define TIA_SIMD_RAYS_QUERY_TMPL_H

#include "vector_tmpl.h"

/* Rays for the box test, see slabs_tmpl.h, in floats: 1/d and (o +- pad)/d. Each lane has two floats side by side, one
 * for each of two boxes. */
struct slabs {
    vp inv[3];
    vp in[3], out[3]; /* (o +- pad)/d of the nearer planes and of the farther ones, or of the minima and the maxima */
    bool uniform;     /* all lanes have the same nearer planes; else rows are minima and maxima */
    int near[3];      /* rows of the nearer planes in a box, which begin at 0 or 3 */
};

/* Starts of rays on an object's surface: b off it and certainly moving away from it; object -1: elsewhere.
 *
 * The fixed-point point may be eo from the certified one, but it lies on its own surface: its roundings put it off that
 * by no more than some 2^-30 (a face is 2^-48 of its distance off the plane of its corners, a sphere's point 2^-43 of
 * its own; a unit of a placed shape's axes is 2^-35 at most, as scales are 2^10 at most), and b is 2^-26 at least: rays
 * of samples and of scenes with fine digits start that far off, others 2^-13 or, in larger units, less. A ray that goes
 * on straight starts b behind the point along itself; it must move away by 2^-2 of its length, or where b is 2^-20 or
 * more by 2^-6, which leaves 2^-28 and 2^-26. So the fixed-point ray does not meet the same plane or face, nor, from
 * outside, the same convex solid; from inside it meets that where it leaves. Without this, every ray would be undecided
 * once eo is b.
 *
 * Where a normal is interpolated a mirrored ray may go into its face: the height that it comes from has a far smaller
 * bound than its start, see return_to_face(). */
struct origin {
    vd object, element;
    vd side; /* 1 inside a solid, 0 outside, -b where the ray certainly returns to the face */
};

/* Rays: the fixed-point origin is within eo of o, the direction within ed of d. */
struct packet {
    struct v3 o, d;
    vd eo, ed, pad; /* pad: bound of their distance anywhere in the scene, see slabs_tmpl.h */
    struct origin from;
    struct v3 inv; /* 1/d */
    struct slabs slabs;
};

/* Rays as lines: their moments O x D about a centre, and the bound of an edge's side, see triangle_tmpl.h. */
struct line {
    struct v3 moment;
    const double *centre;
    vd e, each;
};

/* Largest number of groups in a ray's list. */
#define GROUPS 16

/* The groups of a mesh that each ray meets, see struct query. */
struct group_list {
    uint32_t group[LANES][GROUPS];
    bool sure[LANES][GROUPS];
    int count[LANES];
    unsigned full; /* lanes with more than GROUPS */
};

struct lines;
struct room;

/* Search for the nearest hit: t and e are those of the best hit, `low` is the least t - e of all other hits and
 * possible hits. The best hit is certain if t + e < low in the end; hits behind it may be undecided. Equal distances
 * are never certain: in fixed point the lower index wins.
 *
 * Search for any hit: `blocked` lanes are certainly occluded, `maybe` lanes undecided. */
struct query {
    const struct packet *p;
    struct room *room;         /* the call's memory, see walk_tmpl.h */
    const struct lines *lines; /* relative to the centre of a mesh */
    vm active;
    vd limit; /* hits certainly farther do not count */
    bool any;
    bool solid; /* any hit: every object occludes, except perhaps those with an opacity */
    double object;
    bool opaque;
    vd t, e, ep, low; /* ep: bound of the point */
    vd id, element;
    vd distance, edistance;
    vm blocked, maybe, met, may_meet; /* met, may_meet: hits of a single object that filters light */
    vd through[3], ethrough;
    uint32_t index, blocker;
    struct group_list *groups; /* NULL, or receives `group` of each hit */
    uint32_t group;
    uint32_t work; /* work so far, in items of cancel.h */
};

/* Returns the lanes whose rays start on the object that is tested. */
LANE_OP vm from_object(const struct query *q)
{
    vd here = vset(q->object);

    return mand(vle(q->p->from.object, here), vle(here, q->p->from.object));
}

/* Returns the lanes whose rays start on this element, of any object. */
LANE_OP vm from_element(const struct query *q, vd element)
{
    return mand(vle(element, q->p->from.element), vle(q->p->from.element, element));
}

/* Returns the lanes whose rays start on the object and move away from it. */
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

/* A shape's result: a certain hit at t +- e, its point within ep, or a possible hit no nearer than `low`. */
struct hit_report {
    vm sure, may;
    vd t, e, ep, low, element;
};

#endif
