/* split.c - the surface area heuristic, binned.
 *
 * A ray that hits a box also hits a box inside it with a probability equal to the ratio of their surface areas. If
 * visiting two children costs 1, and testing an item costs c, splitting n items pays if
 *
 *     1/c + n_left area_left/area + n_right area_right/area < n.
 *
 * On each axis the items' centres are sorted into SPLIT_BINS bins of equal width, and only the planes between bins are
 * tried. That is nearly as good as trying all planes, and takes linear time.
 */
#include "split.h"

#include "math/integer.h"
#include "scene/object_bounds.h"

struct split {
    uint64_t cost; /* sum of area times items over both children */
    int axis;
    uint32_t bin;   /* first bin of the second child */
    uint32_t count; /* number of items of the first child */
};

static bool is_cancelled(struct cancel *cancel)
{
    return cancelled(cancel, 1);
}

/* True if cancelled. Small nodes are not counted here, since the caller polls often enough. */
static inline bool stops(const struct tia_bvh_split_items *items)
{
    return items->count > CANCEL_INTERVAL && is_cancelled(items->cancel);
}

#define LANES_NOTHING                                                                                                  \
    {                                                                                                                  \
        {                                                                                                              \
            INT32_MAX, INT32_MAX, INT32_MAX, INT32_MAX, INT32_MAX, INT32_MAX, INT32_MAX, INT32_MAX                     \
        }                                                                                                              \
    }

static inline struct tia_bvh_lanes lanes_of(const struct tia_bounds *b)
{
    static const int32_t inverted[8] = {0, 0, 0, -1, 0, -1, -1, -1};
    const int32_t at[8] = {b->min.x, b->min.y, b->min.z, b->max.x, b->min.z, b->max.x, b->max.y, b->max.z};
    struct tia_bvh_lanes lanes;

    for (int k = 0; k < 8; k++)
        lanes.at[k] = at[k] ^ inverted[k];
    return lanes;
}

static struct tia_bounds bounds_of(const struct tia_bvh_lanes *l)
{
    return (struct tia_bounds){{l->at[0], l->at[1], l->at[2]}, {~l->at[5], ~l->at[6], ~l->at[7]}};
}

/* Enlarges `to`, inline: a call would take longer than the work. */
static inline void add(struct tia_bvh_lanes *to, const struct tia_bvh_lanes *more)
{
    for (int k = 0; k < 8; k++)
        to->at[k] = more->at[k] < to->at[k] ? more->at[k] : to->at[k];
}

/* Returns twice the centre's coordinate, exact. */
static inline int64_t centre(const struct tia_bounds *b, int axis)
{
    return axis == 0   ? (int64_t)b->min.x + b->max.x
           : axis == 1 ? (int64_t)b->min.y + b->max.y
                       : (int64_t)b->min.z + b->max.z;
}

/* Returns the extent along an axis, whose places among the lanes are `min` and `max`; 0 if the box is empty. */
static inline uint32_t extent_of(const struct tia_bvh_lanes *l, int min, int max)
{
    int32_t end = ~l->at[max];
    return end > l->at[min] ? (uint32_t)end - (uint32_t)l->at[min] : 0;
}

/* Returns the shift that brings extents within a box to 19 bits: areas then stay below 3 * 2^38, and areas times 2^24
 * items below 2^64. */
static unsigned area_shift(const struct tia_bvh_lanes *l)
{
    uint32_t all = extent_of(l, 0, 5) | extent_of(l, 1, 6) | extent_of(l, 2, 7);
    unsigned bits = all ? 32 - tia_clz32(all) : 0;
    return bits > 19 ? bits - 19 : 0;
}

/* Returns half the surface area of a box, its extents shifted down by `shift`. */
static inline uint64_t area(const struct tia_bvh_lanes *l, unsigned shift)
{
    uint32_t x = extent_of(l, 0, 5) >> shift, y = extent_of(l, 1, 6) >> shift, z = extent_of(l, 2, 7) >> shift;
    return (uint64_t)x * (y + z) + (uint64_t)y * z;
}

struct tia_bounds tia_bvh_bounds(const struct tia_bvh_extent *extent)
{
    return bounds_of(&extent->box);
}

static inline void include(struct tia_bvh_extent *extent, int axis, int64_t least, int64_t most)
{
    extent->least[axis] = least < extent->least[axis] ? least : extent->least[axis];
    extent->most[axis] = most > extent->most[axis] ? most : extent->most[axis];
}

void tia_bvh_join_extents(struct tia_bvh_extent *to, const struct tia_bvh_extent *more)
{
    add(&to->box, &more->box);
    for (int axis = 0; axis < 3; axis++)
        include(to, axis, more->least[axis], more->most[axis]);
}

void tia_bvh_measure(struct tia_bvh_extent *extent, const struct tia_bvh_split_items *items)
{
    struct tia_bvh_extent all = {LANES_NOTHING, {INT64_MAX, INT64_MAX, INT64_MAX}, {INT64_MIN, INT64_MIN, INT64_MIN}};

    for (uint32_t i = 0; i < items->count && !stops(items); i++) {
        const struct tia_bounds *box = &items->boxes[i];
        const struct tia_bvh_lanes lanes = lanes_of(box);
        add(&all.box, &lanes);
        include(&all, 0, centre(box, 0), centre(box, 0));
        include(&all, 1, centre(box, 1), centre(box, 1));
        include(&all, 2, centre(box, 2), centre(box, 2));
    }
    *extent = all;
}

/* Returns the binning of the range least..most. The range's length, below 2^34, is reduced to 28 bits; dividing by the
 * reduced length + 1 puts the range's end into the last bin. */
static struct tia_bvh_binning binning_of(int64_t least, int64_t most)
{
    if (most <= least)
        return (struct tia_bvh_binning){0};
    unsigned bits = 64 - tia_clz64((uint64_t)(most - least));
    unsigned shift = bits > 28 ? bits - 28 : 0;
    uint64_t range = (uint64_t)(most - least) >> shift;
    return (struct tia_bvh_binning){least, shift, (uint32_t)(((uint64_t)SPLIT_BINS << 28) / (range + 1)), true};
}

bool tia_bvh_choose_bins(struct tia_bvh_binning binning[3], const struct tia_bvh_extent *extent)
{
    for (int axis = 0; axis < 3; axis++)
        binning[axis] = binning_of(extent->least[axis], extent->most[axis]);
    return binning[0].divides || binning[1].divides || binning[2].divides;
}

static inline uint32_t bin_of(const struct tia_bvh_binning *binning, const struct tia_bounds *b, int axis)
{
    uint32_t place = (uint32_t)((uint64_t)(centre(b, axis) - binning->first) >> binning->shift);
    return (uint32_t)(tia_mul_u32(place, binning->scale) >> 28);
}

static inline void add_to_bin(struct tia_bvh_bins *bins, int axis, uint32_t bin, const struct tia_bvh_lanes *box,
                              uint32_t count)
{
    struct tia_bvh_bin *to = &bins->axes[axis][bin];

    if (bins->used[axis] >> bin & 1) {
        add(&to->box, box);
        to->count += count;
    } else {
        bins->used[axis] |= UINT32_C(1) << bin;
        *to = (struct tia_bvh_bin){*box, count};
    }
}

static inline void add_item(struct tia_bvh_bins *bins, const struct tia_bvh_binning binning[3], int axis,
                            const struct tia_bounds *box, const struct tia_bvh_lanes *lanes)
{
    if (binning[axis].divides)
        add_to_bin(bins, axis, bin_of(&binning[axis], box, axis), lanes, 1);
}

void tia_bvh_fill_bins(struct tia_bvh_bins *bins, const struct tia_bvh_split_items *items,
                       const struct tia_bvh_binning binning[3])
{
    bins->used[0] = bins->used[1] = bins->used[2] = 0;
    for (uint32_t i = 0; i < items->count && !stops(items); i++) {
        const struct tia_bounds *box = &items->boxes[i];
        const struct tia_bvh_lanes lanes = lanes_of(box);
        add_item(bins, binning, 0, box, &lanes);
        add_item(bins, binning, 1, box, &lanes);
        add_item(bins, binning, 2, box, &lanes);
    }
}

void tia_bvh_join_bins(struct tia_bvh_bins *to, const struct tia_bvh_bins *more)
{
    for (int axis = 0; axis < 3; axis++)
        for (uint32_t i = 0; i < SPLIT_BINS; i++)
            if (more->used[axis] >> i & 1)
                add_to_bin(to, axis, i, &more->axes[axis][i].box, more->axes[axis][i].count);
}

static inline uint32_t first_bin(uint32_t used)
{
    return 31 - tia_clz32(used & (0 - used));
}

/* Sets *best to the best plane of one axis if that plane is better than *best. Planes behind empty bins are not tried:
 * each of them divides the items as the plane before it does. Most nodes have few items, and use few bins. */
static void choose_split(struct split *best, const struct tia_bvh_bins *all, int axis, unsigned shift)
{
    const struct tia_bvh_bin *bins = all->axes[axis];
    uint32_t used = all->used[axis], count = 0, left = used;
    uint64_t right[SPLIT_BINS]; /* right[i]: cost of a second child that starts at bin i, for bins that are used */
    const struct tia_bvh_lanes nothing = LANES_NOTHING;
    struct tia_bvh_lanes box = nothing;

    while (left & (left - 1)) {
        uint32_t i = 31 - tia_clz32(left);
        left ^= UINT32_C(1) << i;
        add(&box, &bins[i].box);
        count += bins[i].count;
        right[i] = area(&box, shift) * count;
    }
    box = nothing;
    count = 0;
    for (left = used; left & (left - 1);) {
        uint32_t i = first_bin(left);
        left &= left - 1;
        add(&box, &bins[i].box);
        count += bins[i].count;
        uint64_t cost = area(&box, shift) * count + right[first_bin(left)];
        if (cost < best->cost)
            *best = (struct split){cost, axis, i + 1, count};
    }
}

static inline void swap(const struct tia_bvh_split_items *items, uint32_t i, uint32_t k)
{
    uint32_t item = items->items[i];
    struct tia_bounds box = items->boxes[i];

    items->items[i] = items->items[k];
    items->boxes[i] = items->boxes[k];
    items->items[k] = item;
    items->boxes[k] = box;
}

static void partition(const struct tia_bvh_split_items *items, const struct split *choice,
                      const struct tia_bvh_binning *binning)
{
    uint32_t low = 0, high = items->count;

    while (low < high && !stops(items))
        if (bin_of(binning, &items->boxes[low], choice->axis) < choice->bin)
            low++;
        else
            swap(items, low, --high);
}

/* True if `count` items are cheaper as a leaf of the area `visit` than split at the given cost. */
static bool is_leaf(uint64_t cost, uint64_t visit, const struct tia_bvh_split_items *items)
{
    return cost == UINT64_MAX || cost + visit / items->cost >= visit * items->count;
}

uint32_t tia_bvh_split_at_best(const struct tia_bvh_split_items *items, const struct tia_bvh_extent *extent,
                               const struct tia_bvh_bins *bins, const struct tia_bvh_binning binning[3], uint32_t most)
{
    struct split best = {.cost = UINT64_MAX};
    unsigned shift = area_shift(&extent->box);

    for (int axis = 0; axis < 3 && bins; axis++)
        if (binning[axis].divides)
            choose_split(&best, bins, axis, shift);
    if (items->count <= SPLIT_ITEMS_MOST && is_leaf(best.cost, area(&extent->box, shift), items))
        return 0;
    /* no plane separates the centres, or a child would be too large for the depth limit: halve the list */
    if (best.cost == UINT64_MAX || best.count > most || items->count - best.count > most)
        return items->count / 2;
    partition(items, &best, &binning[best.axis]);
    return best.count;
}

/* Does what tia_bvh_split_items does for two items. Whichever axis separates them, their bins differ, and the cost is
 * the same: the first such axis orders them. */
static uint32_t split_two(const struct tia_bvh_split_items *items, struct tia_bounds *bounds)
{
    const struct tia_bounds *boxes = items->boxes;
    const struct tia_bvh_lanes one = lanes_of(&boxes[0]), other = lanes_of(&boxes[1]);
    struct tia_bvh_lanes both = one;
    int64_t order = 0;

    add(&both, &other);
    *bounds = bounds_of(&both);
    for (int axis = 0; axis < 3 && !order; axis++)
        order = centre(&boxes[0], axis) - centre(&boxes[1], axis);
    unsigned shift = area_shift(&both);
    if (!order || is_leaf(area(&one, shift) + area(&other, shift), area(&both, shift), items))
        return 0;
    if (order > 0)
        swap(items, 0, 1);
    return 1;
}

uint32_t tia_bvh_split_items(const struct tia_bvh_split_items *items, struct tia_bounds *bounds, uint32_t most)
{
    struct tia_bvh_extent extent;
    struct tia_bvh_binning binning[3];
    struct tia_bvh_bins bins;

    if (items->count == 2 && items->undivided < 2 && most > 0)
        return split_two(items, bounds);
    tia_bvh_measure(&extent, items);
    *bounds = bounds_of(&extent.box);
    if (items->count <= items->undivided || items->cancel->stopped)
        return 0;
    bool divides = tia_bvh_choose_bins(binning, &extent);
    if (divides)
        tia_bvh_fill_bins(&bins, items, binning);
    return items->cancel->stopped ? 0 : tia_bvh_split_at_best(items, &extent, divides ? &bins : NULL, binning, most);
}
