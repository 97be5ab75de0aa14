/* split.h - splits a node's items by the binned surface area heuristic. */
#ifndef TIA_SCENE_BVH_SPLIT_H
#define TIA_SCENE_BVH_SPLIT_H

#include <tia/bvh.h>

#include "scene/cancel.h"

#define SPLIT_ITEMS_MOST 8 /* number of items of the largest leaf: nodes with more items are always split */
#define SPLIT_BINS 16

/* The items of a node; boxes[i] is the box of items[i]. Items and boxes are reordered together, so that a node's items
 * are consecutive in memory. Once cancelled, the results of all functions below are undefined. */
struct tia_bvh_split_items {
    struct tia_bounds *boxes;
    uint32_t *items;
    uint32_t count;
    uint32_t cost;      /* cost of testing an item, in visits to a node's two children; not 0 */
    uint32_t undivided; /* number of items of the largest node that is a leaf at any cost; not 0 */
    struct cancel *cancel;
};

/* A box, as eight numbers side by side for vector units: x, y, z of `min` and x of `max`, then z of `min` and x, y, z
 * of `max`. The bits of `max` are inverted, so that the box around two boxes has the smaller of each two numbers. */
struct tia_bvh_lanes {
    int32_t at[8];
};

/* The extent of a node's items. */
struct tia_bvh_extent {
    struct tia_bvh_lanes box;  /* box around all items */
    int64_t least[3], most[3]; /* range of twice the coordinates of the items' centres */
};

/* The binning of an axis: an item's bin is ((centre - first) >> shift) * scale >> 28, `centre` being twice the centre's
 * coordinate. */
struct tia_bvh_binning {
    int64_t first;
    unsigned shift;
    uint32_t scale;
    bool divides; /* false if all centres are equal */
};

struct tia_bvh_bin {
    struct tia_bvh_lanes box;
    uint32_t count;
};

/* The bins of all axes. Bin i of an axis is undefined unless bit i of `used` is set: most nodes have few items, and
 * clearing all bins would take longer. */
struct tia_bvh_bins {
    uint32_t used[3];
    struct tia_bvh_bin axes[3][SPLIT_BINS];
};

/* Partitions the items, and returns n: the first n items form the first child, the others the second. Returns 0 if a
 * leaf is cheaper. Neither child gets more than `most` items, which must be at least half of all. Sets *bounds to the
 * bounds of all items. */
uint32_t tia_bvh_split_items(const struct tia_bvh_split_items *items, struct tia_bounds *bounds, uint32_t most);

/* ---- the steps of tia_bvh_split_items ---- */

/* Computes the extent of some of a node's items. */
void tia_bvh_measure(struct tia_bvh_extent *extent, const struct tia_bvh_split_items *items);
/* Returns the box around all items. */
struct tia_bounds tia_bvh_bounds(const struct tia_bvh_extent *extent);
/* Adds the extent of further items; the result does not depend on how the items are divided. */
void tia_bvh_join_extents(struct tia_bvh_extent *to, const struct tia_bvh_extent *more);

/* Computes the binning of each axis. Returns false if there is no axis to split along. */
bool tia_bvh_choose_bins(struct tia_bvh_binning binning[3], const struct tia_bvh_extent *extent);

/* Fills the bins with some of a node's items. */
void tia_bvh_fill_bins(struct tia_bvh_bins *bins, const struct tia_bvh_split_items *items,
                       const struct tia_bvh_binning binning[3]);
/* Adds the bins of further items; the result does not depend on how the items are divided. */
void tia_bvh_join_bins(struct tia_bvh_bins *to, const struct tia_bvh_bins *more);

/* Splits at the best plane, or into halves. Returns the same as tia_bvh_split_items. `bins` is NULL when there is no
 * axis to split along. */
uint32_t tia_bvh_split_at_best(const struct tia_bvh_split_items *items, const struct tia_bvh_extent *extent,
                               const struct tia_bvh_bins *bins, const struct tia_bvh_binning binning[3], uint32_t most);

#endif
