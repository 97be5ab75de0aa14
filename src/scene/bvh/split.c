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

/* True if cancelled. Small nodes are not counted here, since the caller polls often enough. */
static bool stops(const struct tia_bvh_split_items *items)
{
    return items->count > CANCEL_INTERVAL && cancelled(items->cancel, 1);
}

static tia_q16 smaller(tia_q16 a, tia_q16 b)
{
    return a < b ? a : b;
}

static tia_q16 larger(tia_q16 a, tia_q16 b)
{
    return a > b ? a : b;
}

/* Enlarges `to` as tia_bounds_add does, but inline: a call would take longer than the work. */
static inline void add(struct tia_bounds *to, const struct tia_bounds *more)
{
    to->min = (struct tia_vec3){smaller(to->min.x, more->min.x), smaller(to->min.y, more->min.y),
                                smaller(to->min.z, more->min.z)};
    to->max = (struct tia_vec3){larger(to->max.x, more->max.x), larger(to->max.y, more->max.y),
                                larger(to->max.z, more->max.z)};
}

/* Returns twice the centre's coordinate, exact. */
static int64_t centre(const struct tia_bounds *b, int axis)
{
    return axis == 0   ? (int64_t)b->min.x + b->max.x
           : axis == 1 ? (int64_t)b->min.y + b->max.y
                       : (int64_t)b->min.z + b->max.z;
}

static uint64_t extent(tia_q16 min, tia_q16 max)
{
    return max < min ? 0 : (uint64_t)((int64_t)max - min);
}

/* Returns the shift that brings extents within `b` to 19 bits: areas then stay below 3 * 2^38, and areas times 2^24
 * items below 2^64. */
static unsigned area_shift(const struct tia_bounds *b)
{
    uint64_t all = extent(b->min.x, b->max.x) | extent(b->min.y, b->max.y) | extent(b->min.z, b->max.z);
    unsigned bits = all ? 64 - tia_clz64(all) : 0;
    return bits > 19 ? bits - 19 : 0;
}

/* Returns half the surface area of a box, its extents shifted down by `shift`. */
static uint64_t area(const struct tia_bounds *b, unsigned shift)
{
    uint64_t x = extent(b->min.x, b->max.x) >> shift, y = extent(b->min.y, b->max.y) >> shift,
             z = extent(b->min.z, b->max.z) >> shift;
    return x * y + y * z + z * x;
}

void tia_bvh_join_extents(struct tia_bvh_extent *to, const struct tia_bvh_extent *more)
{
    add(&to->bounds, &more->bounds);
    for (int axis = 0; axis < 3; axis++) {
        to->least[axis] = more->least[axis] < to->least[axis] ? more->least[axis] : to->least[axis];
        to->most[axis] = more->most[axis] > to->most[axis] ? more->most[axis] : to->most[axis];
    }
}

void tia_bvh_measure(struct tia_bvh_extent *extent, const struct tia_bvh_split_items *items)
{
    struct tia_bvh_extent all = {BOUNDS_NOTHING, {INT64_MAX, INT64_MAX, INT64_MAX}, {INT64_MIN, INT64_MIN, INT64_MIN}};

    for (uint32_t i = 0; i < items->count && !stops(items); i++) {
        const struct tia_bounds *box = &items->boxes[i];
        int64_t x = centre(box, 0), y = centre(box, 1), z = centre(box, 2);
        const struct tia_bvh_extent one = {*box, {x, y, z}, {x, y, z}};
        tia_bvh_join_extents(&all, &one);
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

static uint32_t bin_of(const struct tia_bvh_binning *binning, const struct tia_bounds *b, int axis)
{
    uint32_t place = (uint32_t)((uint64_t)(centre(b, axis) - binning->first) >> binning->shift);
    return (uint32_t)(tia_mul_u32(place, binning->scale) >> 28);
}

static inline void add_to_bin(struct tia_bvh_bins *bins, int axis, uint32_t bin, const struct tia_bounds *box,
                              uint32_t count)
{
    struct tia_bvh_bin *to = &bins->axes[axis][bin];

    if (bins->used[axis] >> bin & 1) {
        add(&to->bounds, box);
        to->count += count;
    } else {
        bins->used[axis] |= UINT32_C(1) << bin;
        *to = (struct tia_bvh_bin){*box, count};
    }
}

void tia_bvh_fill_bins(struct tia_bvh_bins *bins, const struct tia_bvh_split_items *items,
                       const struct tia_bvh_binning binning[3])
{
    bins->used[0] = bins->used[1] = bins->used[2] = 0;
    for (uint32_t i = 0; i < items->count && !stops(items); i++) {
        const struct tia_bounds *box = &items->boxes[i];
        for (int axis = 0; axis < 3; axis++)
            if (binning[axis].divides)
                add_to_bin(bins, axis, bin_of(&binning[axis], box, axis), box, 1);
    }
}

void tia_bvh_join_bins(struct tia_bvh_bins *to, const struct tia_bvh_bins *more)
{
    for (int axis = 0; axis < 3; axis++)
        for (uint32_t i = 0; i < SPLIT_BINS; i++)
            if (more->used[axis] >> i & 1)
                add_to_bin(to, axis, i, &more->axes[axis][i].bounds, more->axes[axis][i].count);
}

/* Sets *best to the best plane of one axis if that plane is better than *best. Planes behind empty bins are not tried:
 * each of them divides the items as the plane before it does. */
static void choose_split(struct split *best, uint32_t items, const struct tia_bvh_bins *all, int axis, unsigned shift)
{
    const struct tia_bvh_bin *bins = all->axes[axis];
    uint32_t used = all->used[axis];
    uint64_t right[SPLIT_BINS], cost = 0; /* right[i]: cost of a second child that starts at bin i */
    struct tia_bounds bounds = BOUNDS_NOTHING;
    uint32_t count = 0;

    for (int i = SPLIT_BINS - 1; i > 0; i--) {
        if (used >> i & 1) {
            add(&bounds, &bins[i].bounds);
            count += bins[i].count;
            cost = area(&bounds, shift) * count;
        }
        right[i] = cost;
    }
    bounds = BOUNDS_NOTHING;
    count = 0;
    for (uint32_t i = 1; i < SPLIT_BINS; i++) {
        if (!(used >> (i - 1) & 1))
            continue;
        add(&bounds, &bins[i - 1].bounds);
        count += bins[i - 1].count;
        cost = area(&bounds, shift) * count + right[i];
        if (count < items && cost < best->cost)
            *best = (struct split){cost, axis, i, count};
    }
}

static void partition(const struct tia_bvh_split_items *items, const struct split *choice,
                      const struct tia_bvh_binning *binning)
{
    uint32_t low = 0, high = items->count;

    while (low < high && !stops(items)) {
        struct tia_bounds box = items->boxes[low];
        if (bin_of(binning, &box, choice->axis) < choice->bin) {
            low++;
        } else {
            uint32_t item = items->items[low];
            items->items[low] = items->items[--high];
            items->boxes[low] = items->boxes[high];
            items->items[high] = item;
            items->boxes[high] = box;
        }
    }
}

uint32_t tia_bvh_split_at_best(const struct tia_bvh_split_items *items, const struct tia_bounds *bounds,
                               const struct tia_bvh_bins *bins, const struct tia_bvh_binning binning[3], uint32_t most)
{
    struct split best = {.cost = UINT64_MAX};
    unsigned shift = area_shift(bounds);
    uint64_t visit = area(bounds, shift);

    for (int axis = 0; axis < 3 && bins; axis++)
        if (binning[axis].divides)
            choose_split(&best, items->count, bins, axis, shift);
    bool leaf = best.cost == UINT64_MAX || best.cost + visit / items->cost >= visit * items->count;
    if (leaf && items->count <= SPLIT_ITEMS_MOST)
        return 0;
    /* no plane separates the centres, or a child would be too large for the depth limit: halve the list */
    if (best.cost == UINT64_MAX || best.count > most || items->count - best.count > most)
        return items->count / 2;
    partition(items, &best, &binning[best.axis]);
    return best.count;
}

uint32_t tia_bvh_split_items(const struct tia_bvh_split_items *items, struct tia_bounds *bounds, uint32_t most)
{
    struct tia_bvh_extent extent;
    struct tia_bvh_binning binning[3];
    struct tia_bvh_bins bins;

    tia_bvh_measure(&extent, items);
    *bounds = extent.bounds;
    if (items->count < 2 || items->cancel->stopped)
        return 0;
    bool divides = tia_bvh_choose_bins(binning, &extent);
    if (divides)
        tia_bvh_fill_bins(&bins, items, binning);
    return items->cancel->stopped ? 0 : tia_bvh_split_at_best(items, bounds, divides ? &bins : NULL, binning, most);
}
