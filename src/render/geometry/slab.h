/* slab.h - where a ray is between two planes across an axis. Distances are those of num_slab. */
#ifndef TIA_SHAPE_SLAB_H
#define TIA_SHAPE_SLAB_H

#include "num/num_ray.h"

struct slab {
    num_length origin, steep; /* steep: 1/direction, see num_steepness */
    bool level;
};

/* A slope that num_steepness cuts off makes entering early, which is safe; leaving would be too early as well, so a
 * level ray that is between the planes never leaves. */
static inline struct slab slab_of(num_length origin, num_unit direction)
{
    bool level = direction < NUM_UNIT_LEVEL && direction > -NUM_UNIT_LEVEL;

    return (struct slab){origin, num_steepness(direction), level};
}

static inline void slab_clip(const struct slab *slab, num_length min, num_length max, num_length *near, num_length *far)
{
    num_length a = num_slab(min - slab->origin, slab->steep), b = num_slab(max - slab->origin, slab->steep);
    num_length enter = a < b ? a : b, leave = a < b ? b : a;

    *near = enter > *near ? enter : *near;
    if (!slab->level || leave < 0)
        *far = leave < *far ? leave : *far;
}

#endif
