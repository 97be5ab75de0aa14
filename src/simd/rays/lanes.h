/* lanes.h - SURE(), which defines the table of an instruction set's ray kernels. */
#ifndef TIA_SIMD_RAYS_LANES_H
#define TIA_SIMD_RAYS_LANES_H

#include "sure.h"

#define SURE(simd)                                                                                                     \
    extern const struct sure_kernels tia_sure_##simd;                                                                  \
    const struct sure_kernels tia_sure_##simd = {                                                                      \
        trace, shade_seen, set_pixels, occlude, walk_paths, sizeof(struct work), sizeof(struct path_state)}

#endif
