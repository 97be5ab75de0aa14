/* query_tmpl.h - packets of rays, their queries, and the report of a hit.
 *
 * Parameters: the doubles and pairs of floats of isa/isa.h. Defines: struct packet, struct query, struct hit_report,
 * struct origin, struct slabs, struct line, struct group_list, from_object(), from_element(), starts_here(),
 * starts_outside(), starts_inside(), GROUPS. */
#ifndef TIA_SIMD_RAYS_QUERY_TMPL_H
#define TIA_SIMD_RAYS_QUERY_TMPL_H

#include "vector_tmpl.h"

/* Rays prepared for the box test of slabs_tmpl.h, in floats: 1/d and (o +- pad)/d. Each lane has two floats side by
 * side, one for each of two boxes. */
struct slabs {
    vp inv[3];
    vp in[3], out[3]; /* (o +- pad)/d for the nearer and the farther planes, or for the minima and the maxima */
    bool uniform;     /* all lanes have the same nearer planes; else `in` and `out` are for minima and maxima */
    int near[3];      /* first row of the nearer planes in a box: 0 for the minima, 3 for the maxima */
};

/* Origins of rays that start on the surface of `object`, at a height b off it, and certainly move away from it.
 * `object` is -1 for any other origin.
 *
 * The fixed-point point may be eo away from the certified one, but it lies on the same surface: roundings put it off by
 * no more than about 2^-30. (A face's point is off the plane of the corners by 2^-48 of its distance, a sphere's point
 * off the sphere by 2^-43 of its distance. A unit in an instance's axes is 2^-35 at most, as scales are 2^10 at most.)
 * b is at least 2^-26: samples and scenes with fine digits use this height, others 2^-13 or, in larger units, less.
 *
 * A ray that goes straight on starts b behind the point, along itself. The cosine to the normal must then be at least
 * 2^-2, or 2^-6 where b is 2^-20 or more. This leaves heights of 2^-28 and 2^-26.
 *
 * So the fixed-point ray does not meet the same plane or face again, nor, from outside, the same convex solid. From
 * inside, it meets the solid where it leaves. Without this rule, every ray would be undecided as soon as eo is as large
 * as b.
 *
 * Where the normal is interpolated, a mirrored ray may go back into its face. The bound of its height over the face is
 * then far smaller than that of its origin, see return_to_face(). */
struct origin {
    vd object, element;
    vd side; /* 1: inside a solid; 0: outside; -b: the ray certainly returns to its face from height b */
};

/* Rays: the fixed-point origin is within eo of o, the direction within ed of d. */
struct packet {
    struct v3 o, d;
    vd eo, ed, pad; /* pad: bound of the distance between certified and fixed-point ray anywhere in the scene */
    struct origin from;
    struct v3 inv; /* 1/d */
    struct slabs slabs;
};

/* Rays as lines: their moments O x D about a centre. An edge's area is within e + each times the face's extent, see
 * triangle_tmpl.h. */
struct line {
    struct v3 moment;
    const double *centre;
    vd e, each;
};

/* Largest number of groups in a packet's list. */
#define GROUPS 64

/* The groups of a mesh that a packet meets, see struct query: for each group the lanes that certainly meet it, and
 * those that may. */
struct group_list {
    uint32_t group[GROUPS];
    unsigned sure[GROUPS], open[GROUPS];
    int count;
    unsigned full; /* lanes that meet a group for which there is no room */
};

struct lines;
struct room;

/* Search for the nearest hit. t and e are those of the nearest certain hit; `low` is the least distance that any other
 * certain or possible hit may have. The nearest hit is decided if t + e < low at the end; hits behind it may stay
 * undecided. Equal distances are never decided; in fixed point, the lower index then wins.
 *
 * Search for any hit: `blocked` lanes are certainly occluded, `maybe` lanes undecided. */
struct query {
    const struct packet *p;
    struct room *room;         /* the call's memory, see walk_tmpl.h */
    const struct lines *lines; /* lines relative to the centre of the mesh that is tested */
    vm active;
    vd limit; /* hits that are certainly farther do not count */
    bool any;
    bool solid; /* search for any hit: all objects occlude, transparent ones too; an opacity is undecided */
    vd object;
    bool opaque;
    vd t, e, ep, low; /* ep: bound of the point */
    vd id, element;
    vd distance, edistance;
    vm blocked, maybe, met, may_meet; /* met, may_meet: lanes that hit the current object, which filters light */
    vd through[3], ethrough;
    uint32_t index, blocker;
    uint32_t tested;           /* an object that walks pass over, as it was tested before, or TIA_NO_OBJECT */
    struct group_list *groups; /* NULL, or receives `group` of each hit */
    uint32_t group;
    uint32_t work; /* work so far, in items of cancel.h */
};

/* Returns the lanes whose rays start on the object that is tested. */
LANE_OP vm from_object(const struct query *q)
{
    return mand(vle(q->p->from.object, q->object), vle(q->object, q->p->from.object));
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
