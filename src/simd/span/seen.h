/* seen.h - finds the visible objects of a row, as runs. One comparison decides many pixels. */
#ifndef TIA_SIMD_SPAN_SEEN_H
#define TIA_SIMD_SPAN_SEEN_H

#include "render/renderer.h"
#include "row.h"

struct simd_span {
    uint16_t first, end;
    uint32_t object; /* number of a sphere; sphere_count plus that of a light; or TIA_NO_OBJECT */
};

#define SIMD_GUESSES 300 /* for TIA_SPAN_SPHERES spheres, and some lights */

/* Largest number of pixels of a row that are drawn at a time, as a thread's stack may be small. */
#define SIMD_STRIP 2048

/* The runs of a row from the tile's left to its right, at most SIMD_STRIP pixels. They are in one of two lists,
 * `which`. */
struct simd_line {
    struct simd_span spans[2][SIMD_STRIP];
    int which, count;
};

/* Fills the line for a row of the tile. `guess` has an entry for each sphere and light: the object's pixels in the
 * previous row. */
void tia_simd_find(const struct tia_view *view, const struct simd_row *row, struct tia_tile tile, struct span *guess,
                   struct simd_line *line);

#endif
