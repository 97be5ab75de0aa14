/* exact.h - draws single pixels: those that the kernels leave undecided, and those of runs whose errors have no small
 * bound. */
#ifndef TIA_SIMD_SPAN_EXACT_H
#define TIA_SIMD_SPAN_EXACT_H

#include "pair.h"
#include "row.h"

/* Pixels of a row, from x = `first` on, that all see one sphere. `out` points to the first. */
struct simd_pixels {
    const struct tia_view *view;
    const struct simd_row *row;
    uint32_t sphere;
    const struct simd_lamp *lamps; /* of the sphere, one for each light */
    int first;
    const num_u *threshold;
    tia_rgb565 *out;
};

/* Draws the `count` pixels whose indices from the first are in `list`, or the first `count` pixels if `list` is NULL:
 * in double precision and, where that leaves one undecided, with balls (exact/pixel.h). */
void tia_simd_decide(const struct simd_pixels *pixels, const uint16_t *list, int count);

#endif
