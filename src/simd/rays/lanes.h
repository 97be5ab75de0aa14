/* lanes.h - what a level's file defines before it includes tracer.h and walk_paths.h:
 *
 *   LANES            1, 2, 4 or 8
 *   vd, vi, vm       so many doubles, 64-bit integers, and truth values; vd has the language's + - * /, vi also << >>
 *   vset(x)          x in every lane
 *   vsqrt vabs vmin vmax      vmin(a, NaN) and vmax(a, NaN) may be anything
 *   vlt vle          a < b, a <= b: false where one is NaN
 *   vsel(m, a, b)    a where m is true
 *   mand mor mnot, mbits(m), mof(bits)    lane k is bit k
 *
 * and may define, where that is quick:
 *   OF16(table, index)        of 16 words those that the low four bits of each lane's index say: vu, see random.h */
#ifndef TIA_SIMD_RAYS_LANES_H
#define TIA_SIMD_RAYS_LANES_H

#include "sure.h"

#define LANE_OP static inline __attribute__((always_inline, unused))

/* Two floats that lie side by side, as a double: what levels load twice, four or eight times. */
LANE_OP double two_floats(const float *p)
{
    double both;

    __builtin_memcpy(&both, p, sizeof both);
    return both;
}

#define SURE(simd)                                                                                                     \
    extern const struct sure_kernels tia_sure_##simd;                                                                  \
    const struct sure_kernels tia_sure_##simd = {trace,      set_pixels,          occlude,                             \
                                                 walk_paths, sizeof(struct work), sizeof(struct path_state)}

#endif
