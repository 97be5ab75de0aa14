/* words.h - the cosines of a light that nothing blocks, along a row, in words of 32 bits.
 *
 * For a light at Q and a ball L, r, seen from outside, with G = Q - L, P = t v and w = Q - P,
 *
 *     f = r N.w = c - L.Q + t G.v,   |w|^2 = Q.Q - 2 t Q.v + t^2 v.v,
 *
 * and the cosine is f / (r |w|). 1/|w| changes little from pixel to pixel: the line through the last two is improved by
 * one Newton step, and 1 - |w|^2 y^2, which the step needs, says how accurate it is. */
#ifndef TIA_RENDER_SPAN_WORDS_WORDS_H
#define TIA_RENDER_SPAN_WORDS_WORDS_H

#include "math/integer.h"
#include "render/span/span_error.h"

/* Returns a b/2^32, cut off; processors without such products have it once. */
uint32_t words_high_apart(uint32_t a, uint32_t b);

static inline uint32_t words_high(uint32_t a, uint32_t b)
{
    return TIA_HALF_PRODUCTS ? words_high_apart(a, b) : (uint32_t)(tia_mul_u32(a, b) >> 32);
}

/* A point P = t v of a row, in words. */
struct word_point {
    int32_t t;
    int32_t across; /* t times its number, counted from the middle, over 2^spread; not where products are slow */
    int32_t reach;  /* |P|^2 */
};

/* The points of a run of pixels, for all lights. */
struct word_points {
    int up;       /* words of t have the exponent of t and this */
    int exponent; /* that of |P|^2 */
    int middle, spread;
    struct word_point point[CHUNK];
};

/* What a light does to a run of pixels that no ball shades. */
struct word_light {
    num_u *lambert;  /* receives the cosines, as the kernel `lambert` computes them */
    num_u doubt;     /* receives the bound of their errors, except for the open pixels */
    pixel_set open;  /* receives the pixels that may or may not face the light */
    int first, last; /* receives the first and the last pixel that faces the light; first > last: none does */
};

/* Prepares `count` pixels from (x, y) on, which show a ball seen from outside. */
void words_points(const struct primary_rays *primary, const struct span_sphere *sphere, int x, int y, const num_u *t,
                  int count, struct word_points *points);

/* Computes the cosines of a light whose line is prepared, with its doubt; false if they would not be accurate. Only
 * where NUM_CERTIFIED. */
bool words_light(const struct word_points *points, const struct light_source *source, const struct light_line *line,
                 const struct span_error *error, struct word_light *light);

#endif
