/* tree.h - builds one hierarchy, top down. */
#ifndef TIA_SCENE_BVH_TREE_H
#define TIA_SCENE_BVH_TREE_H

#include <tia/bvh.h>

#include "scene/asker.h"

/* Upper bound of the nodes for n items: each leaf has at least one. */
#define TREE_NODES(n) ((n) ? 2 * (uint64_t)(n)-1 : 0)

/* Fills `nodes`, which has room for TREE_NODES(count), and reorders `items`, whose boxes are boxes[item]. In each leaf
 * the items are in rising order. `cost` is what it costs to test one, in visits to a node's children, at least 1. When
 * it is stopped, the tree is not complete. */
struct tia_bvh_tree tia_bvh_build_tree(struct tia_bvh_node *nodes, uint32_t *items, uint32_t count, uint32_t cost,
                                       const struct tia_bounds *boxes, struct asker *asker);

#endif
