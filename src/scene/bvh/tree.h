/* tree.h - one hierarchy, built from the root down. */
#ifndef TIA_BVH_TREE_H
#define TIA_BVH_TREE_H

#include <tia/bvh.h>

/* Nodes that n items take at most: each leaf has one item or more. */
#define TREE_NODES(n) ((n) ? 2 * (uint64_t)(n)-1 : 0)

/* Makes `nodes`, with room for TREE_NODES(count), and orders `items`, whose boxes are boxes[item]; in each leaf they
 * rise. */
struct tia_bvh_tree tia_bvh_build_tree(struct tia_bvh_node *nodes, uint32_t *items, uint32_t count,
                                       const struct tia_bounds *boxes);

#endif
