/* exact.h - draws single pixels: those that the kernels leave undecided, and those of runs whose errors have no small
 * bound. */
#ifndef TIA_SIMD_SPAN_EXACT_H
#define TIA_SIMD_SPAN_EXACT_H

#include "crowd.h"
#include "row.h"

/* Pixels of a row, from x = `first` on, that all see one sphere. `out` points to the first. */
struct simd_pixels {
    const struct tia_view *view;
    const struct simd_row *row;
    uint32_t sphere;
    struct simd_crowd *crowd; /* finds the casters; NULL: those of the sphere's lamps */
    int first;
    const num_u *threshold;
    tia_rgb565 *out;
};

/* Draws the `count` pixels whose indices from the first are in `list`, or the first `count` pixels if `list` is NULL:
 * in double precision and, where that leaves one undecided, with balls (exact/pixel.h). */
void tia_simd_decide(const struct simd_pixels *pixels, const uint16_t *list, int count);

/* Adds a lamp to the sums of the listed pixels, where the kernels leave it undecided. `faint` is the bound of the error
 * of its cosines. What is undecided in doubles, too, becomes NaN. */
void tia_simd_decide_lamp(const struct simd_pixels *pixels, const struct simd_lamp *lamp, double faint,
                          const uint16_t *list, int count, struct simd_sums *sums);

#endif
