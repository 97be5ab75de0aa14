/* noise.h - gradient noise, see struct tia_texture. */
#ifndef TIA_RENDER_TRACE_NOISE_H
#define TIA_RENDER_TRACE_NOISE_H

#include "num/num_ray.h"

/* A point in units of the first octave: the cube of integers around it, modulo 2^31, and the position in it, 0..1. */
struct noise_place {
    int32_t cell[3];
    num_length part[3];
};

/* Moves to the cube around a position that may be outside of `cell`. */
static inline void noise_carry(struct noise_place *place)
{
    for (int k = 0; k < 3; k++) {
        int32_t whole = num_floor(place->part[k]);
        place->cell[k] = (int32_t)(((uint32_t)place->cell[k] + (uint32_t)whole) & INT32_MAX);
        place->part[k] -= num_integer(whole);
    }
}

/* Returns 1/2 + 3/4 of the sum of the octaves at the place, not clamped, between -1.1 and 2.1. `width` is that of the
 * part of space to average over, 0 for a point: an octave fades to its mean, 0, while the width grows from half the
 * octave's unit to all of it. */
num_length noise_value(const struct noise_place *place, unsigned octaves, num_length width);

#endif
