/* split.c - the surface-area heuristic.
 *
 * A ray that meets a box meets a box within it with the chance of the ratio of their surfaces. So dividing n
 * items costs on average, with the cost of an item and that of visiting two children both 1,
 *
 *     1 + n_left area_left/area + n_right area_right/area   against   n.
 *
 * Only the planes between BINS equal slices of the room that the items' centres take are tried, on each axis.
 */
#include "split.h"

#include "math/integer.h"
#include "scene/bounds.h"

#define BINS 16

struct bin {
    struct tia_bounds bounds;
    uint32_t count;
};

/* A slice of an axis: bin = ((centre - first) >> shift) * scale >> 28. */
struct cone_rows {
    int axis;
    int64_t first;
    unsigned shift;
    uint32_t scale;
};

struct choice {
    uint64_t cost; /* areas times items */
    struct cone_rows slices;
    uint32_t bin; /* the first of the second child's */
    uint32_t count;
};

struct tia_bounds tia_bvh_split_bounds(const struct tia_bvh_split_items *items)
{
    struct tia_bounds bounds = BOUNDS_NOTHING;

    for (uint32_t i = 0; i < items->count; i++)
        tia_bounds_add(&bounds, &items->boxes[items->items[i]]);
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

/* How far extents within `b` are shifted down so that they have 19 bits: areas then stay below 3 * 2^38,
 * and times 2^24 items below 2^64. */
static unsigned coarseness(const struct tia_bounds *b)
{
    uint64_t all = extent(b->min.x, b->max.x) | extent(b->min.y, b->max.y) | extent(b->min.z, b->max.z);
    unsigned bits = all ? 64 - tia_clz64(all) : 0;
    return bits > 19 ? bits - 19 : 0;
}

/* Half the surface. */
static uint64_t area(const struct tia_bounds *b, unsigned coarseness)
{
    uint64_t x = extent(b->min.x, b->max.x) >> coarseness, y = extent(b->min.y, b->max.y) >> coarseness,
             z = extent(b->min.z, b->max.z) >> coarseness;
    return x * y + y * z + z * x;
}

/* False when all centres are the same there. */
static bool slice(struct cone_rows *slices, const struct tia_bvh_split_items *items, int axis)
{
    int64_t least = INT64_MAX, most = INT64_MIN;

    for (uint32_t i = 0; i < items->count; i++) {
        int64_t c = centre(&items->boxes[items->items[i]], axis);
        least = c < least ? c : least;
        most = c > most ? c : most;
    }
    if (most <= least)
        return false;
    /* The range, below 2^34, as 28 bits; one more than it divides, so that its end is still in the last bin. */
    unsigned bits = 64 - tia_clz64((uint64_t)(most - least));
    unsigned shift = bits > 28 ? bits - 28 : 0;
    uint64_t range = (uint64_t)(most - least) >> shift;
    *slices = (struct cone_rows){axis, least, shift, (uint32_t)(((uint64_t)BINS << 28) / (range + 1))};
    return true;
}

static uint32_t bin_of(const struct cone_rows *slices, const struct tia_bounds *b)
{
    uint32_t place = (uint32_t)((uint64_t)(centre(b, slices->axis) - slices->first) >> slices->shift);
    return (uint32_t)(tia_mul_u32(place, slices->scale) >> 28);
}

static void fill(struct bin bins[BINS], const struct tia_bvh_split_items *items, const struct cone_rows *slices)
{
    for (int i = 0; i < BINS; i++)
        bins[i] = (struct bin){BOUNDS_NOTHING, 0};
    for (uint32_t i = 0; i < items->count; i++) {
        const struct tia_bounds *box = &items->boxes[items->items[i]];
        struct bin *bin = &bins[bin_of(slices, box)];
        tia_bounds_add(&bin->bounds, box);
        bin->count++;
    }
}

/* The best plane of one axis, if it is better than what *best has. */
static void choose(struct choice *best, const struct tia_bvh_split_items *items, const struct cone_rows *slices,
                   unsigned coarseness)
{
    struct bin bins[BINS];
    uint64_t right[BINS]; /* the cost of the bins from here on */
    struct tia_bounds bounds = BOUNDS_NOTHING;
    uint32_t count = 0;

    fill(bins, items, slices);
    for (int i = BINS - 1; i > 0; i--) {
        tia_bounds_add(&bounds, &bins[i].bounds);
        count += bins[i].count;
        right[i] = area(&bounds, coarseness) * count;
    }
    bounds = BOUNDS_NOTHING;
    count = 0;
    for (uint32_t i = 1; i < BINS; i++) {
        tia_bounds_add(&bounds, &bins[i - 1].bounds);
        count += bins[i - 1].count;
        uint64_t cost = area(&bounds, coarseness) * count + right[i];
        if (count && count < items->count && cost < best->cost)
            *best = (struct choice){cost, *slices, i, count};
    }
}

static void divide(const struct tia_bvh_split_items *items, const struct choice *choice)
{
    uint32_t low = 0, high = items->count;

    while (low < high) {
        uint32_t item = items->items[low];
        if (bin_of(&choice->slices, &items->boxes[item]) < choice->bin) {
            low++;
        } else {
            items->items[low] = items->items[--high];
            items->items[high] = item;
        }
    }
}

uint32_t tia_bvh_split_items(const struct tia_bvh_split_items *items, const struct tia_bounds *bounds, uint32_t most)
{
    struct choice best = {.cost = UINT64_MAX};
    unsigned coarse = coarseness(bounds);
    uint64_t visit = area(bounds, coarse);

    if (items->count < 2)
        return 0;
    for (int axis = 0; axis < 3; axis++) {
        struct cone_rows slices;
        if (slice(&slices, items, axis))
            choose(&best, items, &slices, coarse);
    }
    bool leaf = best.cost == UINT64_MAX || best.cost + visit >= visit * items->count;
    if (leaf && items->count <= SPLIT_ITEMS_MOST)
        return 0;
    /* All in one place, or so far apart from each other that the depth would not do: as they come. */
    if (best.cost == UINT64_MAX || best.count > most || items->count - best.count > most)
        return items->count / 2;
    divide(items, &best);
    return best.count;
}
