/* slab.h - the slab test: the interval of a ray between two planes across an axis. Distances are in the format of
 * num_slab. */
#ifndef TIA_RENDER_GEOMETRY_SLAB_H
#define TIA_RENDER_GEOMETRY_SLAB_H

#include "num/num_ray.h"

struct slab {
    num_length origin, reciprocal; /* 1/direction, see num_reciprocal */
    bool parallel;
};

/* Prepares a ray for slab_clip. num_reciprocal clamps the reciprocal for a ray nearly parallel to the planes. So the
 * computed entry is early, which is safe, but the computed exit is early too, which is not: slab_clip ignores the exit
 * unless the planes are behind the ray. */
static inline struct slab slab_of(num_length origin, num_unit direction)
{
    bool parallel = direction < NUM_UNIT_PARALLEL && direction > -NUM_UNIT_PARALLEL;

    return (struct slab){origin, num_reciprocal(direction), parallel};
}

/* Clips near..far to the part between the planes at `min` and `max`. */
static inline void slab_clip(const struct slab *slab, num_length min, num_length max, num_length *near, num_length *far)
{
    num_length a = num_slab(min - slab->origin, slab->reciprocal), b = num_slab(max - slab->origin, slab->reciprocal);
    num_length enter = a < b ? a : b, leave = a < b ? b : a;

    *near = enter > *near ? enter : *near;
    if (!slab->parallel || leave < 0)
        *far = leave < *far ? leave : *far;
}

#endif
