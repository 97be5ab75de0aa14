/* tree.h - builds one hierarchy, or a part of one, top down. */
#ifndef TIA_SCENE_BVH_TREE_H
#define TIA_SCENE_BVH_TREE_H

#include <tia/bvh.h>

#include "scene/cancel.h"
#include "split.h"

#define BVH_LARGE_MESH ((uint32_t)1 << 21) /* a mesh of more faces is stored in less memory */

/* The largest number of nodes for n items: each leaf has at least one item. */
#define TREE_NODES(n) ((n) ? 2 * (uint64_t)(n)-1 : 0)

/* The input of a tree's construction. Building reorders the items together with their boxes: boxes[i] is the box of
 * items[i], except in finished leaves, where boxes are no longer needed and items are in rising order. `cost` is the
 * cost of testing an item, in visits to a node's children, at least 1. A node of at most `undivided` items is a leaf;
 * this is at least 1 and at most SPLIT_ITEMS_MOST. */
struct bvh_items {
    uint32_t *items;
    struct tia_bounds *boxes;
    uint32_t cost, undivided;
};

/* The items below a node, and its depth. */
struct bvh_range {
    uint32_t first, count, depth;
};

static inline struct tia_bvh_split_items bvh_items_of(const struct bvh_items *all, struct bvh_range range,
                                                      struct cancel *cancel)
{
    return (struct tia_bvh_split_items){
        all->boxes + range.first, all->items + range.first, range.count, all->cost, all->undivided, cancel};
}

/* Returns the largest number of items that a node at `depth` may have, so that halving reaches single items at
 * TIA_BVH_DEPTH_MAX. */
static inline uint32_t bvh_most_items(uint32_t depth)
{
    uint32_t left = TIA_BVH_DEPTH_MAX - depth;
    return UINT32_C(1) << (left < 31 ? left : 31);
}

/* Writes the tree of the range to `nodes`, which must hold TREE_NODES(range.count) nodes; the root comes first. Returns
 * the number of nodes. If cancelled, the tree is incomplete. */
uint32_t tia_bvh_build_range(struct tia_bvh_node *nodes, const struct bvh_items *all, struct bvh_range range,
                             struct cancel *cancel);

#endif
