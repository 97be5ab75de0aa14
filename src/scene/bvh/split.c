/* split.c - the surface area heuristic, binned.
 *
 * A ray that hits a box hits a box inside it with a probability of the ratio of their surface areas. When
 * visiting two children costs 1 and testing an item c, a split of n items is worth it if
 *
 *     1/c + n_left area_left/area + n_right area_right/area < n.
 *
 * On each axis the items' centres are sorted into BINS bins of equal width, and only the planes between bins
 * are tried: nearly as good as trying all, in linear time.
 */
#include "split.h"

#include "math/integer.h"
#include "scene/bounds.h"

#define BINS 16

struct bin {
    struct tia_bounds bounds;
    uint32_t count;
};

/* The bin of an item is ((centre - first) >> shift) * scale >> 28. */
struct binning {
    int axis;
    int64_t first;
    unsigned shift;
    uint32_t scale;
    bool divides; /* not all centres are the same */
};

struct split {
    uint64_t cost; /* the sum of area times items over the two children */
    struct binning binning;
    uint32_t bin;   /* the second child's first bin */
    uint32_t count; /* the first child's items */
};

/* Of few items the caller's question is enough. */
static bool stops(const struct tia_bvh_split_items *items)
{
    return items->count > ASKER_PATIENCE && asker_stops(items->asker, 1);
}

static tia_q16 smaller(tia_q16 a, tia_q16 b)
{
    return a < b ? a : b;
}

static tia_q16 larger(tia_q16 a, tia_q16 b)
{
    return a > b ? a : b;
}

/* tia_bounds_add, where a call costs more than what it does. */
static inline void add(struct tia_bounds *to, const struct tia_bounds *more)
{
    to->min = (struct tia_vec3){smaller(to->min.x, more->min.x), smaller(to->min.y, more->min.y),
                                smaller(to->min.z, more->min.z)};
    to->max = (struct tia_vec3){larger(to->max.x, more->max.x), larger(to->max.y, more->max.y),
                                larger(to->max.z, more->max.z)};
}

struct tia_bounds tia_bvh_split_bounds(const struct tia_bvh_split_items *items)
{
    struct tia_bounds bounds = BOUNDS_NOTHING;

    for (uint32_t i = 0; i < items->count && !stops(items); i++)
        add(&bounds, &items->boxes[items->items[i]]);
    return bounds;
}

/* Twice the centre's coordinate, exact. */
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

/* The shift that brings extents within `b` to 19 bits: areas then stay below 3 * 2^38, and areas times 2^24 items
 * below 2^64. */
static unsigned area_shift(const struct tia_bounds *b)
{
    uint64_t all = extent(b->min.x, b->max.x) | extent(b->min.y, b->max.y) | extent(b->min.z, b->max.z);
    unsigned bits = all ? 64 - tia_clz64(all) : 0;
    return bits > 19 ? bits - 19 : 0;
}

/* Half the surface area. */
static uint64_t area(const struct tia_bounds *b, unsigned shift)
{
    uint64_t x = extent(b->min.x, b->max.x) >> shift, y = extent(b->min.y, b->max.y) >> shift,
             z = extent(b->min.z, b->max.z) >> shift;
    return x * y + y * z + z * x;
}

/* False when all centres coincide on that axis. */
static bool choose_bins(struct binning *binning, int axis, int64_t least, int64_t most)
{
    if (most <= least)
        return false;
    /* The range, below 2^34, is brought to 28 bits. Dividing by range + 1 keeps its end in the last bin. */
    unsigned bits = 64 - tia_clz64((uint64_t)(most - least));
    unsigned shift = bits > 28 ? bits - 28 : 0;
    uint64_t range = (uint64_t)(most - least) >> shift;
    *binning = (struct binning){axis, least, shift, (uint32_t)(((uint64_t)BINS << 28) / (range + 1)), true};
    return true;
}

/* All axes at once, since the boxes lie about in memory. False when there is no axis to split along, or when it is
 * stopped: an item without a look may have no bin. */
static bool choose_axes(struct binning binning[3], const struct tia_bvh_split_items *items)
{
    int64_t least[3] = {INT64_MAX, INT64_MAX, INT64_MAX}, most[3] = {INT64_MIN, INT64_MIN, INT64_MIN};
    bool any = false;

    for (uint32_t i = 0; i < items->count && !stops(items); i++) {
        const struct tia_bounds *box = &items->boxes[items->items[i]];
        for (int axis = 0; axis < 3; axis++) {
            int64_t c = centre(box, axis);
            least[axis] = c < least[axis] ? c : least[axis];
            most[axis] = c > most[axis] ? c : most[axis];
        }
    }
    for (int axis = 0; axis < 3; axis++) {
        binning[axis].divides = false;
        any = choose_bins(&binning[axis], axis, least[axis], most[axis]) || any;
    }
    return any && !items->asker->stopped;
}

static uint32_t bin_of(const struct binning *binning, const struct tia_bounds *b)
{
    uint32_t place = (uint32_t)((uint64_t)(centre(b, binning->axis) - binning->first) >> binning->shift);
    return (uint32_t)(tia_mul_u32(place, binning->scale) >> 28);
}

static void fill_bins(struct bin bins[3][BINS], const struct tia_bvh_split_items *items,
                      const struct binning binning[3])
{
    for (int i = 0; i < BINS; i++)
        bins[0][i] = bins[1][i] = bins[2][i] = (struct bin){BOUNDS_NOTHING, 0};
    for (uint32_t i = 0; i < items->count && !stops(items); i++) {
        const struct tia_bounds *box = &items->boxes[items->items[i]];
        for (int axis = 0; axis < 3; axis++) {
            if (!binning[axis].divides)
                continue;
            struct bin *bin = &bins[axis][bin_of(&binning[axis], box)];
            add(&bin->bounds, box);
            bin->count++;
        }
    }
}

/* Sets *best to the best plane of one axis if that is better. A plane behind an empty bin is as good as the one before
 * it, which was tried. */
static void choose_split(struct split *best, uint32_t items, const struct bin bins[BINS], const struct binning *binning,
                         unsigned shift)
{
    uint64_t right[BINS], cost = 0; /* right: cost of a second child that starts at bin i */
    struct tia_bounds bounds = BOUNDS_NOTHING;
    uint32_t count = 0;

    for (int i = BINS - 1; i > 0; i--) {
        if (bins[i].count) {
            add(&bounds, &bins[i].bounds);
            count += bins[i].count;
            cost = area(&bounds, shift) * count;
        }
        right[i] = cost;
    }
    bounds = BOUNDS_NOTHING;
    count = 0;
    for (uint32_t i = 1; i < BINS; i++) {
        if (!bins[i - 1].count)
            continue;
        add(&bounds, &bins[i - 1].bounds);
        count += bins[i - 1].count;
        cost = area(&bounds, shift) * count + right[i];
        if (count < items && cost < best->cost)
            *best = (struct split){cost, *binning, i, count};
    }
}

static void partition(const struct tia_bvh_split_items *items, const struct split *choice)
{
    uint32_t low = 0, high = items->count;

    while (low < high && !stops(items)) {
        uint32_t item = items->items[low];
        if (bin_of(&choice->binning, &items->boxes[item]) < choice->bin) {
            low++;
        } else {
            items->items[low] = items->items[--high];
            items->items[high] = item;
        }
    }
}

static void find_split(struct split *best, const struct tia_bvh_split_items *items, unsigned shift)
{
    struct binning binning[3];
    struct bin bins[3][BINS];

    if (!choose_axes(binning, items))
        return;
    fill_bins(bins, items, binning);
    for (int axis = 0; axis < 3; axis++)
        if (binning[axis].divides)
            choose_split(best, items->count, bins[axis], &binning[axis], shift);
}

uint32_t tia_bvh_split_items(const struct tia_bvh_split_items *items, const struct tia_bounds *bounds, uint32_t most)
{
    struct split best = {.cost = UINT64_MAX};
    unsigned shift = area_shift(bounds);
    uint64_t visit = area(bounds, shift);

    if (items->count < 2)
        return 0;
    find_split(&best, items, shift);
    bool leaf = best.cost == UINT64_MAX || best.cost + visit / items->cost >= visit * items->count;
    if (leaf && items->count <= SPLIT_ITEMS_MOST)
        return 0;
    /* No plane separates the centres, or a child would be too large for the depth limit: halve the list. */
    if (best.cost == UINT64_MAX || best.count > most || items->count - best.count > most)
        return items->count / 2;
    partition(items, &best);
    return best.count;
}
