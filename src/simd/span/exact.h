/* exact.h - the pixels that the kernels leave undecided. */
#ifndef TIA_SIMD_SPAN_EXACT_H
#define TIA_SIMD_SPAN_EXACT_H

#include "bound_cache.h"

/* Draws pixels x .. x + count - 1 of row y, which all see the sphere, by the integer code. */
void tia_simd_plain(const struct tia_view *view, uint32_t sphere, int x, int y, int count, const num_u threshold[8],
                    tia_rgb565 *out);

/* Draws the listed pixels, counted from the run's first: in double precision, and undecided ones by the integer code.
 * `out` is the run's first pixel; `cache` is for the bounds in double precision. */
void tia_simd_decide(struct simd_fine *fine, struct simd_bound_cache *cache, const uint16_t *list, int count,
                     const num_u threshold[8], tia_rgb565 *out);

#endif
