/* halves.h - 128-bit numbers in the caller's memory, which is aligned for uint64_t only: the lower half first. */
#ifndef TIA_RASTER_HALVES_H
#define TIA_RASTER_HALVES_H

#include "math/wide.h"

static inline void halves_put(uint64_t halves[2], wide a)
{
    halves[0] = wide_low(a);
    halves[1] = (uint64_t)wide_high(a);
}

static inline wide halves_get(const uint64_t halves[2])
{
    return wide_of_halves((int64_t)halves[1], halves[0]);
}

#endif
