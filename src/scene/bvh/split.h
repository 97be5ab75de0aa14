/* split.h - where a node's items are best divided, by the binned surface-area heuristic. */
#ifndef TIA_BVH_SPLIT_H
#define TIA_BVH_SPLIT_H

#include <tia/bvh.h>

#define SPLIT_ITEMS_MOST 8 /* that a leaf takes even when dividing them would cost less */

/* Items and the boxes of all that there are; an item is an index into them. */
struct tia_bvh_split_items {
    const struct tia_bounds *boxes;
    uint32_t *items;
    uint32_t count;
};

/* The box around all items. */
struct tia_bounds tia_bvh_split_bounds(const struct tia_bvh_split_items *items);

/* Orders the items so that the first n of them, n being what is returned, become the first child and the rest the
 * second; 0: they are better a leaf. No child gets more than `most` items, which is at least half of them. */
uint32_t tia_bvh_split_items(const struct tia_bvh_split_items *items, const struct tia_bounds *bounds, uint32_t most);

#endif
