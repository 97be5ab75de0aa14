#include "walk.h"

/* Where a ray is between two planes across an axis. */
static void clip(num_x origin, num_x steep, bool backward, tia_q16 min, tia_q16 max, num_x *near, num_x *far)
{
    num_x enter = num_slab(num_x_of(backward ? max : min) - origin, steep);
    num_x leave = num_slab(num_x_of(backward ? min : max) - origin, steep);

    *near = enter > *near ? enter : *near;
    *far = leave < *far ? leave : *far;
}

/* Whether the ray may meet the box before `limit`, and where it enters. */
static bool enters(const struct walk *w, const struct tia_bounds *b, num_x limit, num_x *near)
{
    num_x far = num_slab_of(limit);

    *near = 0;
    clip(w->origin.x, w->steep[0], w->backward[0], b->min.x, b->max.x, near, &far);
    clip(w->origin.y, w->steep[1], w->backward[1], b->min.y, b->max.y, near, &far);
    clip(w->origin.z, w->steep[2], w->backward[2], b->min.z, b->max.z, near, &far);
    return *near <= far + NUM_SLAB_ERROR;
}

static void push(struct walk *w, uint32_t node, num_x near)
{
    w->stack[w->depth] = node;
    w->near[w->depth++] = near;
}

void walk_start(struct walk *w, const struct tia_bvh_tree *tree, const struct ray *ray)
{
    w->tree = tree;
    w->origin = ray->origin;
    w->steep[0] = num_steep(ray->direction.x);
    w->steep[1] = num_steep(ray->direction.y);
    w->steep[2] = num_steep(ray->direction.z);
    for (int i = 0; i < 3; i++)
        w->backward[i] = w->steep[i] < 0;
    w->depth = 0;
    if (tree->node_count)
        push(w, 0, 0);
}

static void push_children(struct walk *w, uint32_t node, num_x limit)
{
    const struct tia_bvh_node *nodes = w->tree->nodes;
    uint32_t first = node + 1, second = nodes[node].index;
    num_x near_first, near_second;
    bool a = enters(w, &nodes[first].bounds, limit, &near_first);
    bool b = enters(w, &nodes[second].bounds, limit, &near_second);

    if (a && b && near_second < near_first) {
        push(w, first, near_first);
        push(w, second, near_second);
        return;
    }
    if (b)
        push(w, second, near_second);
    if (a)
        push(w, first, near_first);
}

const struct tia_bvh_node *walk_leaf(struct walk *w, num_x limit)
{
    while (w->depth > 0) {
        uint32_t node = w->stack[--w->depth];
        if (w->near[w->depth] > num_slab_of(limit) + NUM_SLAB_ERROR)
            continue;
        if (w->tree->nodes[node].count)
            return &w->tree->nodes[node];
        push_children(w, node, limit);
    }
    return NULL;
}
