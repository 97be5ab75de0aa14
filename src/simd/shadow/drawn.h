/* drawn.h - the part of a shadow map that visible points can look up. */
#ifndef TIA_SIMD_SHADOW_DRAWN_H
#define TIA_SIMD_SHADOW_DRAWN_H

#include "shadow/map.h"

/* Narrows the `drawn` tile of each of a map's views to the texels that a filter other than TIA_FILTER_PCSS can read for
 * a visible point of the eye's view that no bias moves. */
void tia_simd_map_drawn(struct tia_map *map, const struct tia_world *world, const tia_flat_light *light);

#endif
