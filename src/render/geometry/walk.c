#include "walk.h"

/* Whether the ray may meet the box before `limit`, and where it enters. */
static bool enters(const struct walk *w, const struct tia_bounds *b, num_length limit, num_length *near)
{
    num_length far = num_slab_of(limit);

    *near = 0;
    slab_clip(&w->slabs[0], num_length_of(b->min.x), num_length_of(b->max.x), near, &far);
    slab_clip(&w->slabs[1], num_length_of(b->min.y), num_length_of(b->max.y), near, &far);
    slab_clip(&w->slabs[2], num_length_of(b->min.z), num_length_of(b->max.z), near, &far);
    return *near <= far + NUM_SLAB_ERROR;
}

static void push(struct walk *w, uint32_t node, num_length near)
{
    w->stack[w->depth] = node;
    w->near[w->depth++] = near;
}

void walk_start(struct walk *w, const struct tia_bvh_tree *tree, const struct ray *ray)
{
    w->tree = tree;
    w->ray = ray;
    w->slabs[0] = slab_of(ray->origin.x, ray->direction.x);
    w->slabs[1] = slab_of(ray->origin.y, ray->direction.y);
    w->slabs[2] = slab_of(ray->origin.z, ray->direction.z);
    w->depth = 0;
    if (tree->node_count)
        push(w, 0, 0);
}

static void push_children(struct walk *w, uint32_t node, num_length limit)
{
    const struct tia_bvh_node *nodes = w->tree->nodes;
    uint32_t first = node + 1, second = nodes[node].index;
    num_length near_first, near_second;
    bool a = enters(w, &nodes[first].bounds, limit, &near_first);
    bool b = enters(w, &nodes[second].bounds, limit, &near_second);

    ray_tested(w->ray, 2);
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

const struct tia_bvh_node *walk_leaf(struct walk *w, num_length limit)
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

void candidates_start(struct candidates *c, const struct tia_scene *scene, const struct ray *ray)
{
    const struct tia_bvh *bvh = scene->bvh;

    c->scene = scene;
    c->ray = ray;
    c->items = bvh ? bvh->unbounded : NULL;
    c->next = 0;
    c->end = bvh ? bvh->unbounded_count : scene->sphere_count + scene->shape_count;
    c->walking = false;
}

/* The next leaf's objects; false: there is none. */
static bool take_leaf(struct candidates *c, num_length limit)
{
    const struct tia_bvh_tree *tree = &c->scene->bvh->objects;

    if (!c->walking)
        walk_start(&c->walk, tree, c->ray);
    c->walking = true;
    const struct tia_bvh_node *leaf = walk_leaf(&c->walk, limit);
    if (!leaf)
        return false;
    c->items = tree->items;
    c->next = leaf->index;
    c->end = leaf->index + leaf->count;
    return true;
}

uint32_t candidates_next(struct candidates *c, num_length limit)
{
    if (c->next == c->end && (!c->scene->bvh || !take_leaf(c, limit)))
        return TIA_NO_OBJECT;
    uint32_t place = c->next++;
    ray_tested(c->ray, 1);
    return c->items ? c->items[place] : place;
}
