/* walk_tmpl.h - traversal of the hierarchy by packets: the nearest hit of each ray, and the occlusion between a point
 * and a light.
 *
 * Parameters: the doubles and pairs of floats of isa/isa.h, the hooks of sure_check.h. Defines: find_nearest(),
 * begin_nearest(), end_nearest(), find_shadow(), begin_any(), end_any(), begin_lines(), meet_one(), meet_unbounded(),
 * meet_light(), struct shadow, struct room, LIGHT_ID.
 *
 * A packet enters a node if any active lane does. */
#ifndef TIA_SIMD_RAYS_WALK_TMPL_H
#define TIA_SIMD_RAYS_WALK_TMPL_H

#include "box_tmpl.h"
#include "cylinder_tmpl.h"
#include "descend_tmpl.h"
#include "faces_tmpl.h"
#include "flat_tmpl.h"
#include "grid_tmpl.h"
#include "instance_tmpl.h"
#include "level_tmpl.h"
#include "pairs_tmpl.h"
#include "round_tmpl.h"
#include "sphere_tmpl.h"
#include "sure_check.h"
#include "triangle_tmpl.h"
#include "wide_tmpl.h"

/* Shadow rays and their results: the lanes that are blocked or undecided, and the transmission of the other lanes. */
struct shadow {
    struct packet p;
    vd distance, edistance;
    vm blocked, unsure;
    vd through[3], ethrough;
    uint32_t work;
};

/* Working storage of hierarchy walks. It is part of the memory passed to the call, since a thread's stack may be too
 * small. */
struct room {
    struct pending objects[TIA_BVH_DEPTH_MAX + 1], faces[TIA_BVH_DEPTH_MAX + 1];
    struct single single;
    bool scattered; /* the packet's rays start where other rays ended, and may soon diverge */
    struct placed placed;
    struct query inner; /* query in the axes of an instance */
    struct query any;   /* query of shadow rays */
    struct lines lines;
    struct grid_walk grid;
    struct group_list groups;
};

LANE_OP void meet_faces(const struct sure_scene *s, const struct sure_tree *tree, const struct node_ref *v,
                        struct query *q)
{
    (void)s;
    for (uint32_t i = 0; i < v->child.count; i += SURE_LEAF / 2) {
        uint32_t left = v->child.count - i;
        meet_some(tree, tree->pairs + v->child.index + i, left < SURE_LEAF / 2 ? left : SURE_LEAF / 2, q);
    }
}

WALK(walk_faces, meet_faces, stay, faces)

/* Reports a possible hit of a shape of unknown kind, no nearer than its box. */
LANE_OP void meet_unknown(struct query *q, vd near)
{
    report_hit(q, (struct hit_report){.sure = mnone(),
                                      .may = vle(near, q->limit),
                                      .t = vset(0),
                                      .e = vset(0),
                                      .ep = vset(0),
                                      .low = near,
                                      .element = vset(0)});
}

/* Sets the rays as lines relative to a mesh, after begin_object(). */
LANE_OP void begin_lines(struct query *q, const struct sure_tree *mesh)
{
    lines_of(&q->room->lines, q->p, mesh);
    q->room->lines.starts = mbits(starts_here(q));
    q->lines = &q->room->lines;
}

LANE_OP void meet_mesh(const struct sure_scene *s, const struct sure_object *o, struct query *q)
{
    if (o->mesh->level && !any(mand(q->active, mnot(leaves_level(q, o->mesh)))))
        return;
    begin_lines(q, o->mesh);
    walk_faces(s, o->mesh, q);
}

/* Intersects a shape. `scale` is the factor from distances in the world to those in the object's axes. */
LANE_OP void meet_shape(const struct sure_scene *s, const struct sure_object *o, struct query *q,
                        const struct node_ref *at, vd scale)
{
    switch (o->kind) {
    case SURE_SPHERE:
        meet_sphere(q, o->at, o->radius);
        break;
    case SURE_MESH:
        meet_mesh(s, o, q);
        break;
    case SURE_TRIANGLE:
        meet_face(q, o->face, 0);
        break;
    case SURE_PLANE:
        meet_plane(q, o);
        break;
    case SURE_DISC:
        meet_disc(q, o);
        break;
    case SURE_ROUND:
        if (o->round->sine != 0)
            meet_round(q, o->round);
        else if (comes_near(q, o->round))
            meet_cylinder(q, o->round);
        break;
    case SURE_BOX:
        meet_box(q, o->at, o->normal);
        break;
    case SURE_GRID:
        meet_grid(q, o->grid, &q->room->grid);
        break;
    case SURE_UNKNOWN:
        meet_unknown(q, lanes_of(*at->near, at->child.place) * scale);
        break;
    }
}

static __attribute__((noinline)) void meet_placed(const struct sure_scene *s, const struct sure_object *o,
                                                  struct query *q, const struct node_ref *at)
{
    struct placed *placed = &q->room->placed;
    struct query *inner = &q->room->inner;

    place_rays(o->placed, q->p, o->kind == SURE_BOX, q->active, placed);
    placed_query(q, placed, inner);
    if (any(inner->active))
        meet_shape(s, o, inner, at, placed->k);
    q->work = inner->work;
    report_placed(q, placed, inner, o->placed->most);
}

/* Filters light by a mesh that transmits some of it, once for each group that a ray meets. */
static __attribute__((noinline)) void meet_grouped(const struct sure_scene *s, const struct sure_object *o,
                                                   struct query *q)
{
    struct group_list *groups = &q->room->groups; /* not cleared as a whole, since it is large */

    groups->full = 0;
    groups->count = 0;
    q->groups = groups;
    meet_mesh(s, o, q);
    q->groups = NULL;
    filter_groups(q, groups, o->transmission);
}

LANE_OP void meet_object(const struct sure_scene *s, uint32_t index, struct query *q, const struct node_ref *at)
{
    const struct sure_object *o = &s->object[index];

    begin_object(o, index, q);
    if (q->any && !q->solid && o->grouped) {
        meet_grouped(s, o, q);
        return;
    }
    if (o->placed)
        meet_placed(s, o, q, at);
    else
        meet_shape(s, o, q, at, vset(1));
    end_object(o, q);
}

LANE_OP void meet_objects(const struct sure_scene *s, const struct sure_tree *tree, const struct node_ref *v,
                          struct query *q)
{
    for (uint32_t i = v->child.index; i < v->child.index + v->child.count; i++)
        if (tree->items[i] != q->tested)
            meet_object(s, tree->items[i], q, v);
}

WALK(walk_together, meet_objects, stay, objects)

static __attribute__((noinline)) void meet_apart(const struct sure_scene *s, const struct sure_tree *tree,
                                                 const struct node_ref *v, struct query *q)
{
    meet_objects(s, tree, v, q);
}

/* Visits the wide node in place of a node, if there is one and few rays enter it. Returns true if it did. */
LANE_OP bool leave(const struct sure_scene *s, const struct sure_tree *tree, const struct node_ref *v, struct query *q)
{
    if (__builtin_popcount(v->lanes) > WIDE_LANES || tree->wide_of[v->child.index] == SURE_NO_WIDE)
        return false;
    walk_wide(s, tree, &q->room->single, q, tree->wide_of[v->child.index], half(v->lanes));
    return true;
}

WALK(walk_scattered, meet_apart, leave, objects)

LANE_OP void walk_objects(const struct sure_scene *s, struct query *q)
{
    if (WIDE_LANES && q->room->scattered && s->objects.wide)
        walk_scattered(s, &s->objects, q);
    else
        walk_together(s, &s->objects, q);
}

/* Intersects an object whose box, if it has one, was not tested. */
LANE_OP void meet_at_once(const struct sure_scene *s, uint32_t object, struct query *q)
{
    static const vp zero;
    const struct node_ref start = {{0, 0, 0}, &zero, 0};

    meet_object(s, object, q, &start);
}

static __attribute__((noinline)) void meet_unbounded(const struct sure_scene *s, struct query *q)
{
    for (uint32_t i = 0; i < s->unbounded_count; i++)
        meet_at_once(s, s->unbounded[i], q);
}

static __attribute__((noinline)) void meet_one(const struct sure_scene *s, uint32_t object, struct query *q)
{
    meet_at_once(s, object, q);
}

/* Light n has the object number LIGHT_ID + n. */
#define LIGHT_ID 4294967296.0

LANE_OP void meet_light(const struct sure_light *l, struct query *q)
{
    if (tia_light_has(l->from->kind, TIA_LIGHT_BALL))
        meet_sphere(q, l->at, l->radius);
    else
        meet_flat_light(q, l);
}

static __attribute__((noinline)) void meet_lights(const struct sure_scene *s, struct query *q)
{
    for (uint32_t n = 0; n < s->light_count; n++) {
        const struct sure_light *l = &s->lights[n];
        q->object = vset(LIGHT_ID + n);
        if (l->seen)
            meet_light(l, q);
    }
}

/* Finds the nearest object, before lights are tested. Returns the lanes whose error is too large for the box test, for
 * end_nearest(). */
LANE_OP vm begin_nearest(const struct sure_scene *s, struct room *room, struct query *q, struct packet *p, vm active)
{
    vm fine = packet_start(s->centre, s->extent, p, active);

    q->p = p;
    q->room = room;
    q->work = SURE_PACKET + s->unbounded_count + s->light_count;
    q->active = mand(active, fine);
    q->any = q->solid = false;
    q->tested = TIA_NO_OBJECT;
    q->groups = NULL;
    q->limit = q->t = q->low = vset(INFINITE);
    q->e = q->ep = vset(0);
    q->id = q->element = vset(-1);
    meet_unbounded(s, q);
    walk_objects(s, q);
    return mand(active, mnot(fine));
}

/* Makes the lanes of `wild` undecided: they may hit any object. */
LANE_OP void end_nearest(struct query *q, vm wild)
{
    q->low = vsel(wild, vset(-1), q->low);
    q->t = vsel(wild, vset(0), q->t);
}

/* Finds the nearest hit, lights included. */
static void find_nearest(const struct sure_scene *s, struct room *room, struct query *q, struct packet *p, vm active)
{
    vm wild = begin_nearest(s, room, q, p, active);

    meet_lights(s, q);
    end_nearest(q, wild);
}

/* Begins a search for any hit between the origins and the distances of shadow rays, without its active lanes. */
LANE_OP void begin_any(struct query *q, struct room *room, const struct shadow *shadow, uint32_t blocker)
{
    q->p = &shadow->p; /* a query is large, so it is set field by field; fields of the nearest hit stay unused */
    q->room = room;
    q->work = 0;
    q->any = true;
    q->solid = false;
    q->blocker = q->tested = blocker;
    q->groups = NULL;
    q->group = 0;
    q->distance = shadow->distance;
    q->edistance = shadow->edistance;
    q->limit = q->distance + q->edistance;
    q->blocked = q->maybe = q->met = q->may_meet = mnone();
    q->ethrough = vset(0);
    for (int c = 0; c < 3; c++)
        q->through[c] = vset(1);
}

LANE_OP void end_any(const struct query *q, struct shadow *shadow)
{
    shadow->work = q->work;
    shadow->ethrough = q->ethrough;
    shadow->blocked = q->blocked;
    shadow->unsure = mand(q->maybe, mnot(q->blocked));
    for (int c = 0; c < 3; c++)
        shadow->through[c] = q->through[c];
}

/* Traces shadow rays. *blocker, unless it is TIA_NO_OBJECT, is tested first; it receives the last object that blocked a
 * ray. */
static void find_shadow(const struct sure_scene *s, struct room *room, struct shadow *shadow, vm active,
                        uint32_t *blocker)
{
    vm fine = packet_start(s->centre, s->extent, &shadow->p, active);
    struct query *q = &room->any;

    check_shadow(mbits(active));
    begin_any(q, room, shadow, *blocker);
    q->work = SURE_PACKET + s->unbounded_count;
    q->active = mand(active, fine);
    if (*blocker != TIA_NO_OBJECT)
        meet_one(s, *blocker, q);
    if (any(q->active))
        meet_unbounded(s, q);
    if (any(q->active))
        walk_objects(s, q);
    *blocker = q->blocker;
    end_any(q, shadow);
    shadow->unsure = mor(shadow->unsure, mand(active, mnot(fine)));
}

#endif
