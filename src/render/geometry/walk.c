#include "walk.h"

/* Clips near..far to the part between two planes. For a ray nearly parallel to the planes, num_slope clamps 1/d. So the
 * computed entry is early, which is safe, but the computed exit is early too: it is ignored if the planes are ahead. */
static inline void clip(const struct num_slope *s, tia_q16 min, tia_q16 max, num_walk *near, num_walk *far)
{
    num_walk enter = num_walk_to(s, s->backward ? max : min), leave = num_walk_to(s, s->backward ? min : max);

    *near = enter > *near ? enter : *near;
    if (leave < *far && (!s->parallel || leave < 0))
        *far = leave;
}

/* True if the ray may meet the box before `limit`; *near receives the t of entry. */
static bool enters(const struct walk *w, const struct tia_bounds *b, num_walk limit, num_walk *near)
{
    num_walk far = limit;

    *near = 0;
    clip(&w->slopes[0], b->min.x, b->max.x, near, &far);
    clip(&w->slopes[1], b->min.y, b->max.y, near, &far);
    if (*near > num_walk_slack(far))
        return false;
    clip(&w->slopes[2], b->min.z, b->max.z, near, &far);
    return *near <= num_walk_slack(far);
}

static inline void push(struct walk *w, uint32_t node, num_walk near)
{
    w->stack[w->depth] = node;
    w->near[w->depth++] = near;
}

void walk_start(struct walk *w, const struct tia_bvh_tree *tree, const struct ray *ray)
{
    w->tree = tree;
    w->ray = ray;
    w->slopes[0] = num_slope(ray->origin.x, ray->direction.x);
    w->slopes[1] = num_slope(ray->origin.y, ray->direction.y);
    w->slopes[2] = num_slope(ray->origin.z, ray->direction.z);
    w->depth = 0;
    if (tree->node_count)
        push(w, 0, 0);
}

static void push_children(struct walk *w, uint32_t node, num_walk limit)
{
    const struct tia_bvh_node *nodes = w->tree->nodes;
    uint32_t first = node + 1, second = nodes[node].index;
    num_walk near_first, near_second;
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
    num_walk most = num_walk_limit(limit);

    while (w->depth > 0) {
        uint32_t node = w->stack[--w->depth];
        if (w->near[w->depth] > most)
            continue;
        if (w->tree->nodes[node].count)
            return &w->tree->nodes[node];
        push_children(w, node, most);
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

/* Gives the next leaf's objects; false: there is none. */
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
