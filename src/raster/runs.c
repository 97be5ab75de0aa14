#include "runs.h"

/* True if the polygon is nearer at a pixel where nearness does not decide. It is nearer than an empty pixel, but not
 * nearer than its own face. */
static bool settle(const struct raster_polygon *p, size_t at)
{
    uint32_t there = p->face[at];

    return there == TIA_NO_FACE || (there != p->own && p->is_nearer(p->ctx, at));
}

static void nearest(const struct raster_polygon *p, size_t at, int pixels, uint64_t z)
{
    uint64_t *nearness = p->nearness, step = p->step;
    uint32_t *faces = p->face, own = p->own;

    for (size_t end = at + (size_t)pixels; at < end; at++, z += step) {
        int64_t difference = (int64_t)(z - nearness[at]);
        if (difference < -DEPTH_UNSURE || (difference <= DEPTH_UNSURE && !settle(p, at)))
            continue;
        nearness[at] = (int64_t)z < 0 ? 0 : z; /* errors may lead below 0, that is, infinity */
        faces[at] = own;
    }
}

static inline bool is_unsure(int64_t difference)
{
    return (uint64_t)difference + DEPTH_UNSURE <= 2 * DEPTH_UNSURE;
}

/* Adds to the counts where the sign bit of the difference in nearness, inverted if nearer pixels count, is set. */
static void add(const struct raster_polygon *p, size_t at, int pixels, uint64_t z)
{
    const uint64_t *nearness = p->nearness;
    uint64_t step = p->step, flip = p->nearer ? UINT64_MAX : 0;
    uint32_t *count = p->count, one = p->one;

    for (size_t end = at + (size_t)pixels; at < end; at++, z += step) {
        uint64_t difference = z - nearness[at];
        if (is_unsure((int64_t)difference))
            difference = settle(p, at) ? 1 : UINT64_MAX;
        count[at] += (uint32_t)((int64_t)(difference ^ flip) >> 63) & one;
    }
}

const struct tia_raster_runs tia_raster_runs_plain = {nearest, add, NULL};
