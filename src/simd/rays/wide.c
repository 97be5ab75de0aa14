/* wide.c - wide nodes for rays that are traced one by one, made by collapsing the hierarchy: see wide_tmpl.h. */
#include <tia/bvh.h>

#include "sure.h"

#define NEVER 1e30f /* the box of a missing child is from NEVER to -NEVER */

/* A child of a node, and its items: items[first] .. items[end - 1]. */
struct branch {
    const struct sure_node *parent;
    int place;
    uint32_t first, end;
};

/* The wide nodes so far. Ranges of items are visited in rising order; the items from the last visited one to `other`
 * are spheres. */
struct maker {
    const struct sure_tree *tree;
    const struct sure_object *objects;
    uint32_t spheres;
    struct sure_wide *nodes;
    double *leaves;
    uint32_t *wide_of, made, used, other;
};

static uint32_t count_of(const struct branch *b)
{
    return b->parent->count[b->place];
}

/* Returns a child, with its items: they start with those of the first leaf below it and end with those of the last. */
static struct branch branch_of(const struct sure_tree *tree, const struct sure_node *parent, int place)
{
    const struct sure_node *n = parent;
    int at = place;

    while (n->count[at] == SURE_INNER) {
        n = &tree->nodes[n->index[at]];
        at = 0;
    }
    struct branch b = {parent, place, n->index[at], 0};
    for (n = parent, at = place; n->count[at] == SURE_INNER; at = 1)
        n = &tree->nodes[n->index[at]];
    b.end = n->index[at] + n->count[at];
    return b;
}

static bool is_leaf(const struct branch *b)
{
    return b->end - b->first <= SURE_WIDE || count_of(b) != SURE_INNER;
}

/* Returns half the surface of a child's box. */
static float surface(const struct branch *b)
{
    const float(*box)[2] = b->parent->box;
    float x = box[3][b->place] - box[0][b->place], y = box[4][b->place] - box[1][b->place],
          z = box[5][b->place] - box[2][b->place];

    return x * y + y * z + z * x;
}

/* Returns the index of the branch with the largest surface that is not a leaf, or -1 if there is none. */
static int largest(const struct branch *b, int count)
{
    int best = -1;

    for (int i = 0; i < count; i++)
        if (!is_leaf(&b[i]) && (best < 0 || surface(&b[i]) > surface(&b[best])))
            best = i;
    return best;
}

/* Sets the branches of a wide node: the children of the given node, of which the largest is replaced by its own
 * children while there is room. Returns their number. */
static int open_branches(const struct sure_tree *tree, uint32_t node, struct branch b[SURE_WIDE])
{
    int count = 2, next = 0;

    b[0] = branch_of(tree, &tree->nodes[node], 0);
    b[1] = branch_of(tree, &tree->nodes[node], 1);
    while (count < SURE_WIDE && (next = largest(b, count)) >= 0) {
        const struct sure_node *n = &tree->nodes[b[next].parent->index[b[next].place]];
        b[next] = branch_of(tree, n, 0);
        b[count++] = branch_of(tree, n, 1);
    }
    return count;
}

/* Makes a leaf, and returns its place. */
static uint32_t set_leaf(struct maker *m, const struct branch *b)
{
    uint32_t place = m->used, n = b->end - b->first;
    double *to = m->leaves + place + 1;

    for (uint32_t i = 0; i < n; i++) {
        uint32_t item = m->tree->items[b->first + i];
        for (uint32_t axis = 0; axis < 3; axis++)
            to[axis * n + i] = m->objects[item].at[axis];
        to[3 * n + i] = m->objects[item].radius;
        to[4 * n + i] = item;
    }
    m->leaves[place] = n;
    m->used += 5 * n + 1;
    return place | SURE_LEAF_AT;
}

static void set_child(struct maker *m, struct sure_wide *to, int i, const struct branch *b)
{
    for (int k = 0; k < 6; k++)
        to->box[k][i] = b->parent->box[k][b->place];
    if (is_leaf(b))
        to->child[i] = set_leaf(m, b);
}

static void clear_node(struct sure_wide *to)
{
    *to = (struct sure_wide){.child = {0}};
    for (int i = 0; i < SURE_WIDE; i++)
        for (int k = 0; k < 3; k++) {
            to->box[k][i] = NEVER;
            to->box[k + 3][i] = -NEVER;
        }
}

/* A node whose wide node is still to be made; `parent` and `place` are where its index belongs. */
struct queued {
    uint32_t node, parent;
    int place;
};

/* Makes wide nodes of a node and those below it. */
static void widen(struct maker *m, uint32_t node)
{
    struct queued stack[SURE_WIDE_WAITS];
    int depth = 0;

    stack[depth++] = (struct queued){node, 0, -1};
    while (depth) {
        struct queued next = stack[--depth];
        struct branch b[SURE_WIDE];
        struct sure_wide *to = &m->nodes[m->made];
        int count = open_branches(m->tree, next.node, b);
        if (next.place >= 0)
            m->nodes[next.parent].child[next.place] = m->made;
        m->wide_of[next.node] = m->made;
        clear_node(to);
        for (int i = 0; i < count; i++) {
            set_child(m, to, i, &b[i]);
            if (!is_leaf(&b[i]))
                stack[depth++] = (struct queued){b[i].parent->index[b[i].place], m->made, i};
        }
        m->made++;
    }
}

/* True if all items of a range are spheres. */
static bool all_spheres(struct maker *m, uint32_t first, uint32_t end)
{
    m->other = m->other < first ? first : m->other;
    while (m->other < end && m->tree->items[m->other] < m->spheres)
        m->other++;
    return m->other >= end;
}

void tia_sure_widen(struct sure_tree *tree, const struct sure_object *objects, uint32_t spheres,
                    struct sure_wide *nodes, double *leaves, uint32_t *wide_of)
{
    struct maker m = {
        .tree = tree, .objects = objects, .spheres = spheres, .nodes = nodes, .leaves = leaves, .wide_of = wide_of};
    uint32_t done = 0; /* items before this one are in wide nodes */

    for (uint32_t i = 0; i < tree->node_count; i++)
        wide_of[i] = SURE_NO_WIDE;
    for (uint32_t i = 0; i < tree->node_count; i++) {
        uint32_t first = branch_of(tree, &tree->nodes[i], 0).first, end = branch_of(tree, &tree->nodes[i], 1).end;
        if (end <= done || end - first <= SURE_WIDE || !all_spheres(&m, first, end))
            continue;
        widen(&m, i);
        done = end;
    }
    for (int i = 0; i < SURE_WIDE; i++)
        leaves[m.used++] = 0;
    tree->wide = nodes;
    tree->leaves = leaves;
    tree->wide_of = wide_of;
}
