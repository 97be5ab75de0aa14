/* split.h - where to split a node's items, by the binned surface area heuristic. */
#ifndef TIA_SCENE_BVH_SPLIT_H
#define TIA_SCENE_BVH_SPLIT_H

#include <tia/bvh.h>

#include "scene/asker.h"

#define SPLIT_ITEMS_MOST 8 /* more items are always split, whatever the heuristic finds */

/* Items are indices into `boxes`. Once the asker is stopped, what the functions return means nothing. */
struct tia_bvh_split_items {
    const struct tia_bounds *boxes;
    uint32_t *items;
    uint32_t count;
    uint32_t cost; /* of testing an item, in visits to a node's two children; not 0 */
    struct asker *asker;
};

/* The bounding box of all items. */
struct tia_bounds tia_bvh_split_bounds(const struct tia_bvh_split_items *items);

/* Partitions the items and returns n: the first n become the first child, the rest the second. 0: better make a
 * leaf. No child gets more than `most` items; `most` must be at least half of them. */
uint32_t tia_bvh_split_items(const struct tia_bvh_split_items *items, const struct tia_bounds *bounds, uint32_t most);

#endif
