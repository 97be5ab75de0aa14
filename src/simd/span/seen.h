/* seen.h - visible objects of a row, as runs: one comparison decides many pixels. */
#ifndef TIA_SIMD_SPAN_SEEN_H
#define TIA_SIMD_SPAN_SEEN_H

#include "render/renderer.h"
#include "row.h"

struct simd_span {
    uint16_t first, end;
    uint32_t object; /* a sphere, then a light; or TIA_NO_OBJECT */
};

#define SIMD_GUESSES 300 /* more than the spheres that spans draw, and some lights */

/* Pixels of a row that are drawn at a time: a thread may have little stack. */
#define SIMD_STRIP 2048

/* A row of runs from the tile's left to its right, at most SIMD_STRIP pixels, in one of two lists. */
struct simd_line {
    struct simd_span spans[2][SIMD_STRIP];
    int which, count;
};

/* Fills the line for a row of the tile. `guess` has an entry for each sphere and light: its pixels in the row
 * before. */
void tia_simd_find(const struct tia_view *view, const struct simd_row *row, struct tia_tile tile, struct span *guess,
                   struct simd_line *line);

#endif
