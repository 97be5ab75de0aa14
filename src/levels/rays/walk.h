/* walk.h - packets through the hierarchy: any active lane enters a node. The nearest hit of each ray, and what stands
 * between a point and a light. */
#ifndef TIA_LEVELS_RAYS_WALK_H
#define TIA_LEVELS_RAYS_WALK_H

#include "box.h"
#include "check.h"
#include "flat.h"
#include "grid.h"
#include "instance.h"
#include "round.h"
#include "sphere.h"
#include "triangle.h"

struct child {
    uint32_t index, count;
    int place; /* 0 or 1 */
};

/* A child that waits, and which bits are its lanes. */
struct waiting {
    vp near;
    unsigned lanes;
    struct child child;
};

/* A child that is visited. */
struct visit {
    struct child child;
    const vp *near;
};

/* What a packet still looks for. Of each lane there are two bits, as there are floats of a `vp`. */
struct outlook {
    vd farthest;
    vp limit;
    unsigned active;
};

#define EVEN 0x5555u

LANE_OP unsigned twice(unsigned lanes)
{
    lanes = (lanes | lanes << 4) & 0x0f0f;
    lanes = (lanes | lanes << 2) & 0x3333;
    return ((lanes | lanes << 1) & EVEN) * 3;
}

LANE_OP void look(struct outlook *w, const struct query *q)
{
    w->farthest = q->limit;
    w->limit = vp_of(up(q->limit));
    w->active = twice(mbits(q->active));
}

/* After a leaf: what is farther than now known does not count. Mostly nothing is new, so that the branch is less than
 * what it saves the next node from waiting for. */
LANE_OP void look_again(struct outlook *w, const struct query *q)
{
    if (twice(mbits(q->active)) != w->active || many(vlt(q->limit, w->farthest)))
        look(w, q);
}

/* Called for 0 or for 1, in branches: they are foreseen, where an index that is computed is waited for. */
LANE_OP void visit(struct child *to, const struct sure_node *n, int place)
{
    *to = (struct child){n->index[place], n->count[place], place};
}

/* Goes to the child that more lanes enter first; the other one waits, at `other`, if it is entered. -1: none is, else
 * whether one waits. */
LANE_OP int descend(struct visit *v, const struct outlook *w, vp *near, struct waiting *other,
                    const struct sure_tree *tree, const struct query *q)
{
    const struct sure_node *n = &tree->nodes[v->child.index];
    vp in;
    unsigned lanes = enter_two(&q->p->slabs, n, w->limit, &in) & w->active;
    unsigned first = lanes & EVEN, second = lanes >> 1 & EVEN;
    bool turn = !first;

    if (!lanes)
        return -1;
    *near = in;
    if (first && second) {
        unsigned closer = vp_le(in, vp_swap(in)); /* of each two, which is */
        turn = LANES == 1 ? !(closer & 1)
                          : __builtin_popcount(second & (~first | closer >> 1)) >
                                __builtin_popcount(first & (~second | closer));
        other->near = in;
        other->lanes = lanes & EVEN << !turn;
        if (turn)
            visit(&other->child, n, 0);
        else
            visit(&other->child, n, 1);
    }
    if (turn)
        visit(&v->child, n, 1);
    else
        visit(&v->child, n, 0);
    v->near = near;
    return first && second;
}

/* The next child that waits and is still of use; returns how many wait behind it, -1: there is none. */
LANE_OP int resume(struct visit *v, const struct outlook *w, const struct waiting *stack, int depth)
{
    while (depth > 0 && w->active) {
        const struct waiting *next = &stack[--depth];
        if (next->lanes & w->active & vp_le(next->near, w->limit)) {
            *v = (struct visit){next->child, &next->near};
            return depth;
        }
    }
    return -1;
}

/* Two walks of one shape: a mesh's is called from within the scene's. */
#define WALK(name, leaf)                                                                                               \
    static __attribute__((noinline)) void name(const struct sure_scene *s, const struct sure_tree *tree,               \
                                               struct query *q)                                                        \
    {                                                                                                                  \
        struct waiting stack[TIA_BVH_DEPTH_MAX + 1];                                                                   \
        struct visit v = {.child = {.count = SURE_INNER}};                                                             \
        struct outlook w;                                                                                              \
        int depth = 0, more = 0;                                                                                       \
        vp near;                                                                                                       \
                                                                                                                       \
        if (!tree->node_count)                                                                                         \
            return;                                                                                                    \
        look(&w, q);                                                                                                   \
        do {                                                                                                           \
            while (v.child.count == SURE_INNER && (more = descend(&v, &w, &near, &stack[depth], tree, q)) >= 0)        \
                depth += more;                                                                                         \
            if (v.child.count != SURE_INNER) {                                                                         \
                leaf(s, tree, &v, q);                                                                                  \
                look_again(&w, q);                                                                                     \
            }                                                                                                          \
        } while ((depth = resume(&v, &w, stack, depth)) >= 0);                                                         \
    }

/* Some of a leaf's faces: first which of them any line meets, without a branch for each, then where. */
LANE_OP void meet_some(const struct sure_tree *tree, const uint32_t *items, uint32_t count, struct query *q)
{
    vm inside[SURE_LEAF], outside[SURE_LEAF];
    unsigned met = 0;

    for (uint32_t i = 0; i < count; i++) {
        struct sides sides = face_sides(q->p, &q->line, &tree->faces[items[i]]);
        inside[i] = sides.inside;
        outside[i] = sides.outside;
        met |= (unsigned)many(mand(mnot(sides.outside), q->active)) << i;
    }
    for (; met; met &= met - 1) {
        int i = __builtin_ctz(met);
        q->group = q->groups ? tree->groups[items[i]] : 0;
        meet_plane_of(q, &tree->faces[items[i]], items[i], (struct sides){inside[i], outside[i]});
    }
}

LANE_OP void meet_faces(const struct sure_scene *s, const struct sure_tree *tree, const struct visit *v,
                        struct query *q)
{
    (void)s;
    for (uint32_t i = 0; i < v->child.count; i += SURE_LEAF) {
        uint32_t left = v->child.count - i;
        meet_some(tree, tree->items + v->child.index + i, left < SURE_LEAF ? left : SURE_LEAF, q);
    }
}

WALK(walk_faces, meet_faces)

/* What is not known may be hit from its box on. */
LANE_OP void meet_unknown(struct query *q, vd near)
{
    report(q, (struct report){.sure = mnone(),
                              .may = vle(near, q->limit),
                              .t = vset(0),
                              .e = vset(0),
                              .ep = vset(0),
                              .low = near,
                              .element = vset(0)});
}

/* `scale`: how much longer distances are in the object's axes than those of its box. */
LANE_OP void meet_shape(const struct sure_scene *s, const struct sure_object *o, struct query *q,
                        const struct visit *at, vd scale)
{
    switch (o->kind) {
    case SURE_SPHERE:
        meet_sphere(q, o->at, o->radius);
        break;
    case SURE_MESH:
        q->line = line_of(q->p, o->mesh->centre, o->mesh->extent);
        walk_faces(s, o->mesh, q);
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
        meet_round(q, o->round);
        break;
    case SURE_BOX:
        meet_box(q, o->at, o->normal);
        break;
    case SURE_GRID:
        meet_grid(q, o->grid);
        break;
    case SURE_UNKNOWN:
        meet_unknown(q, lanes_of(*at->near, at->child.place) * scale);
        break;
    }
}

static __attribute__((noinline)) void meet_placed(const struct sure_scene *s, const struct sure_object *o,
                                                  struct query *q, const struct visit *at)
{
    struct placed placed;
    struct query inner;

    place_rays(o->placed, q->p, o->kind == SURE_BOX, q->active, &placed);
    placed_query(q, &placed, &inner);
    if (many(inner.active))
        meet_shape(s, o, &inner, at, placed.k);
    report_placed(q, &placed, &inner, o->placed->most);
}

/* An object that filters light does so once, wherever it is met; either side rounds each product. */
LANE_OP void filter(struct query *q, const struct sure_object *o)
{
    vm unclear = mand(q->may_meet, mnot(q->met));

    if (o->unclear)
        unclear = mor(unclear, q->met);
    q->maybe = mor(q->maybe, unclear);
    q->ethrough = q->ethrough + vsel(q->met, vset(UNIT), vset(0));
    for (int c = 0; c < 3; c++)
        q->through[c] = vsel(q->met, q->through[c] * vset(o->transmission[c]), q->through[c]);
}

/* A mesh of groups that lets light through. */
static __attribute__((noinline)) void meet_grouped(const struct sure_scene *s, const struct sure_object *o,
                                                   struct query *q)
{
    struct group_list groups; /* not set to zero as a whole: it is large */

    groups.full = 0;
    for (int k = 0; k < LANES; k++)
        groups.count[k] = 0;
    q->groups = &groups;
    q->line = line_of(q->p, o->mesh->centre, o->mesh->extent);
    walk_faces(s, o->mesh, q);
    q->groups = NULL;
    filter_groups(q, &groups, o->transmission);
}

LANE_OP void meet_object(const struct sure_scene *s, uint32_t index, struct query *q, const struct visit *at)
{
    const struct sure_object *o = &s->object[index];

    q->index = index;
    q->object = (double)index;
    q->opaque = q->solid ? !o->layered : o->opaque;
    q->met = q->may_meet = mnone();
    if (q->any && !q->solid && o->grouped) {
        meet_grouped(s, o, q);
        return;
    }
    if (o->placed)
        meet_placed(s, o, q, at);
    else
        meet_shape(s, o, q, at, vset(1));
    if (q->any && !q->opaque)
        filter(q, o);
}

LANE_OP void meet_objects(const struct sure_scene *s, const struct sure_tree *tree, const struct visit *v,
                          struct query *q)
{
    for (uint32_t i = v->child.index; i < v->child.index + v->child.count; i++)
        meet_object(s, tree->items[i], q, v);
}

WALK(walk_objects, meet_objects)

/* Objects that no box is around, or that are tried before their boxes. */
LANE_OP void meet_at_once(const struct sure_scene *s, uint32_t object, struct query *q)
{
    static const vp zero;
    const struct visit start = {{0, 0, 0}, &zero};

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

/* Lights have no index among objects: light n is told as this and n. */
#define LIGHT_ID 4294967296.0

LANE_OP void meet_light(const struct sure_light *l, struct query *q)
{
    if (l->from->kind == TIA_POINT_LIGHT || l->from->kind == TIA_SPHERE_LIGHT)
        meet_sphere(q, l->at, l->radius);
    else
        meet_flat_light(q, l);
}

static __attribute__((noinline)) void meet_lights(const struct sure_scene *s, struct query *q)
{
    for (uint32_t n = 0; n < s->light_count; n++) {
        const struct sure_light *l = &s->lights[n];
        q->object = LIGHT_ID + n;
        if (l->seen)
            meet_light(l, q);
    }
}

/* The nearest object, before lights are tried. Returns the lanes that are too far off, for end_nearest(). */
LANE_OP vm begin_nearest(const struct sure_scene *s, struct query *q, struct pack *p, vm active)
{
    vm fine = pack_start(s->centre, s->extent, p, active);

    q->p = p;
    q->active = mand(active, fine);
    q->any = q->solid = false;
    q->groups = NULL;
    q->limit = q->t = q->low = vset(NEVER);
    q->e = q->ep = vset(0);
    q->id = q->element = vset(-1);
    meet_unbounded(s, q);
    walk_objects(s, &s->objects, q);
    return mand(active, mnot(fine));
}

/* Those may have met anything. */
LANE_OP void end_nearest(struct query *q, vm wild)
{
    q->low = vsel(wild, vset(-1), q->low);
    q->t = vsel(wild, vset(0), q->t);
}

/* The nearest, lights included. */
static void find_nearest(const struct sure_scene *s, struct query *q, struct pack *p, vm active)
{
    vm wild = begin_nearest(s, q, p, active);

    meet_lights(s, q);
    end_nearest(q, wild);
}

/* Shadow rays, and what is known of them. */
struct shadow {
    struct pack p;
    vd distance, edistance;
    vm blocked, unsure;
    vd through[3], ethrough;
};

/* *blocker is tried first, and becomes what blocked a ray. */
static void find_shadow(const struct sure_scene *s, struct shadow *shadow, vm active, uint32_t *blocker)
{
    vm fine = pack_start(s->centre, s->extent, &shadow->p, active);
    struct query q; /* field by field: what only the nearest hit has is not used, and it is large */

    check_shadow(mbits(active));
    q.p = &shadow->p;
    q.active = mand(active, fine);
    q.any = true;
    q.solid = false;
    q.blocker = *blocker;
    q.groups = NULL;
    q.group = 0;
    q.distance = shadow->distance;
    q.edistance = shadow->edistance;
    q.limit = q.distance + q.edistance;
    q.blocked = q.maybe = q.met = q.may_meet = mnone();
    q.ethrough = vset(0);
    for (int c = 0; c < 3; c++)
        q.through[c] = vset(1);
    if (*blocker != TIA_NO_OBJECT)
        meet_one(s, *blocker, &q);
    if (many(q.active))
        meet_unbounded(s, &q);
    if (many(q.active))
        walk_objects(s, &s->objects, &q);
    *blocker = q.blocker;
    shadow->ethrough = q.ethrough;
    shadow->blocked = q.blocked;
    shadow->unsure = mor(mand(q.maybe, mnot(q.blocked)), mand(active, mnot(fine)));
    for (int c = 0; c < 3; c++)
        shadow->through[c] = q.through[c];
}

#endif
