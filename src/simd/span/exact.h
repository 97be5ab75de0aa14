/* exact.h - draws the pixels that the kernels leave undecided. */
#ifndef TIA_SIMD_SPAN_EXACT_H
#define TIA_SIMD_SPAN_EXACT_H

#include "bound_cache.h"

/* Draws pixels x .. x + count - 1 of row y, which all see the sphere, by the integer code. */
void tia_simd_plain(const struct tia_view *view, uint32_t sphere, int x, int y, int count, const num_u threshold[8],
                    tia_rgb565 *out);

/* Draws the listed pixels in double precision, and by the integer code where they are still undecided. The list has
 * indices from the run's first pixel, to which `out` points. `cache` has the bounds for double precision. */
void tia_simd_decide(struct simd_fine *fine, struct simd_bound_cache *cache, const uint16_t *list, int count,
                     const num_u threshold[8], tia_rgb565 *out);

#endif
