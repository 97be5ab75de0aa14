/* descend_tmpl.h - traversal of a hierarchy by a packet, for any kind of leaf: see walk_tmpl.h.
 *
 * Parameters: the doubles and pairs of floats of isa/isa.h. Defines: WALK(), stay(), EVEN, twice(), half(), struct
 * child, struct pending, struct node_ref. */
#ifndef TIA_SIMD_RAYS_DESCEND_TMPL_H
#define TIA_SIMD_RAYS_DESCEND_TMPL_H

#include "query_tmpl.h"
#include "slabs_tmpl.h"

struct child {
    uint32_t index, count;
    int place; /* place of the child in its node, 0 or 1 */
};

/* A queued child, and the lanes that enter it, as in struct search. */
struct pending {
    vp near;
    unsigned lanes;
    struct child child;
};

/* The child being visited, and the lanes that enter it. */
struct node_ref {
    struct child child;
    const vp *near;
    unsigned lanes;
};

/* Search state of a packet. Lanes have two bits each, one for each float of a `vp`. */
struct search {
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

/* Returns the even bits, packed. */
LANE_OP unsigned half(unsigned bits)
{
    bits &= EVEN;
    bits = (bits | bits >> 1) & 0x3333;
    bits = (bits | bits >> 2) & 0x0f0f;
    return (bits | bits >> 4) & 0xff;
}

LANE_OP void search_begin(struct search *w, const struct query *q)
{
    w->farthest = q->limit;
    w->limit = vp_of(up(q->limit));
    w->active = twice(mbits(q->active));
}

/* Updates the search after a leaf, so that boxes beyond the new limit are skipped. The limit rarely changes: a
 * predicted branch is cheaper than making the next node depend on it. */
LANE_OP void search_update(struct search *w, const struct query *q)
{
    if (twice(mbits(q->active)) != w->active || any(vlt(q->limit, w->farthest)))
        search_begin(w, q);
}

/* Sets *to to the child at `place`, which is a constant in each branch of the caller: a predicted branch is cheaper
 * than a load from a computed address. */
LANE_OP void child_of(struct child *to, const struct sure_node *n, int place)
{
    *to = (struct child){n->index[place], n->count[place], place};
}

/* Goes on to the child that more lanes enter first, and stores the other in *other if any lane enters it. Returns the
 * number of children stored, or -1 if no lane enters either child. */
LANE_OP int descend(struct node_ref *v, const struct search *w, vp *near, struct pending *other,
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
        unsigned closer = vp_le(in, vp_swap(in)); /* two bits per lane: child 0 or 1 is no farther than the other */
        turn = LANES == 1 ? !(closer & 1)
                          : __builtin_popcount(second & (~first | closer >> 1)) >
                                __builtin_popcount(first & (~second | closer));
        other->near = in;
        other->lanes = lanes & EVEN << !turn;
        if (turn)
            child_of(&other->child, n, 0);
        else
            child_of(&other->child, n, 1);
    }
    if (turn)
        child_of(&v->child, n, 1);
    else
        child_of(&v->child, n, 0);
    v->near = near;
    v->lanes = turn ? second : first;
    return first && second;
}

/* Takes the next queued child within the limit. Returns the number of children still queued, or -1 if there was none
 * within it. */
LANE_OP int resume(struct node_ref *v, const struct search *w, const struct pending *stack, int depth)
{
    while (depth > 0 && w->active) {
        const struct pending *next = &stack[--depth];
        unsigned lanes = next->lanes & w->active & vp_le(next->near, w->limit);
        if (lanes) {
            *v = (struct node_ref){next->child, &next->near, (lanes | lanes >> 1) & EVEN};
            return depth;
        }
    }
    return -1;
}

/* The last parameter but one of WALK(), for walks that visit all nodes alike. */
LANE_OP bool stay(const struct sure_scene *s, const struct sure_tree *tree, const struct node_ref *v, struct query *q)
{
    (void)s, (void)tree, (void)v, (void)q;
    return false;
}

/* Defines a function that walks a hierarchy and calls `leaf` at each leaf. `waits` is the member of struct room that
 * holds the queued children; no other pointer refers to it. Walks of meshes run within that of the scene, so each kind
 * of walk is a function with a queue of its own. `leave` may visit a node in another way, and then returns true. */
#define WALK(name, leaf, leave, waits)                                                                                 \
    static __attribute__((noinline)) void name(const struct sure_scene *s, const struct sure_tree *tree,               \
                                               struct query *q)                                                        \
    {                                                                                                                  \
        struct pending *restrict stack = q->room->waits;                                                               \
        struct node_ref v = {.child = {.count = SURE_INNER}};                                                          \
        struct search w;                                                                                               \
        int depth = 0, more = 0;                                                                                       \
        vp near;                                                                                                       \
                                                                                                                       \
        if (!tree->node_count)                                                                                         \
            return;                                                                                                    \
        search_begin(&w, q);                                                                                           \
        v.lanes = w.active & EVEN;                                                                                     \
        do {                                                                                                           \
            bool left = false;                                                                                         \
            while (v.child.count == SURE_INNER && !(left = leave(s, tree, &v, q)) &&                                   \
                   (more = descend(&v, &w, &near, &stack[depth], tree, q)) >= 0)                                       \
                depth += more;                                                                                         \
            if (left) {                                                                                                \
                search_update(&w, q);                                                                                  \
            } else if (v.child.count != SURE_INNER) {                                                                  \
                q->work += v.child.count;                                                                              \
                leaf(s, tree, &v, q);                                                                                  \
                search_update(&w, q);                                                                                  \
            }                                                                                                          \
        } while ((depth = resume(&v, &w, stack, depth)) >= 0);                                                         \
    }

#endif
