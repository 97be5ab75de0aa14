/* pixel.h - pixels as docs/definition.md defines them, for scenes that the span renderer draws. They are computed with
 * balls of 64 bits, then of 128, 256 and 512, until all comparisons are decided. */
#ifndef TIA_EXACT_PIXEL_H
#define TIA_EXACT_PIXEL_H

#include "picture.h"

/* What pixels took, over all calls so far: `words`, the largest number of words of the balls that decided one; `tie`,
 * whether the sides of a comparison were equal, or counted as equal because the most words left it open. */
struct exact_cost {
    int words;
    bool tie;
};

/* Returns pixel (x, y), counted from the upper left. `threshold`, d of the definition, is Q2.30. `cost` may be NULL. */
tia_rgb565 tia_exact_pixel(const struct exact_picture *picture, int x, int y, tia_q30 threshold,
                           struct exact_cost *cost);

/* Returns pixel (x, y), where sphere `object` of the scene is visible. Also gives its 16-bit colours (tia/render.h) and
 * its path hash (tia/debug.h), unless these are NULL. */
tia_rgb565 tia_exact_shade(const struct exact_picture *picture, int x, int y, uint32_t object, tia_q30 threshold,
                           uint16_t *colours, uint32_t *path_hash);

/* True if the ray of pixel (x, y) meets ball `object`: a sphere of the scene or, counted after these, a light. */
bool tia_exact_meets(const struct exact_picture *picture, int x, int y, uint32_t object);

/* True if the distance of ball i is smaller than that of ball j, where the ray of pixel (x, y) meets both. */
bool tia_exact_nearer(const struct exact_picture *picture, int x, int y, uint32_t i, uint32_t j);

#endif
