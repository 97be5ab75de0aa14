/* cone_row.h - the exact intersection of a line of pixels and a cone of rays.
 *
 * Seen from the eye a sphere with centre L and radius r fills the cone of all directions v with
 *
 *     L.v >= 0   and   (L.v)^2 >= c v.v,   c = L.L - r^2.
 *
 * Along a line of pixels v = (X, ...), X = 2i + 1 - n for pixel i of n, the product is linear and the square quadratic:
 * L.v = slope X + base and v.v = X^2 + square. A cone is convex, so its pixels on the line form one span. Exact
 * comparisons find both ends, from a guess in a few steps.
 */
#ifndef TIA_RENDER_SPAN_CONE_ROW_H
#define TIA_RENDER_SPAN_CONE_ROW_H

#include "num/num.h"

struct tia_view;

struct cone_row {
    num_wide slope, base; /* slope: exponent 16; base: exponent 16 + f */
    num_wide square;      /* exponent 2 f */
    num_wide c;           /* exponent 32 */
    int exponent;         /* the exponent f of pixel coordinates */
    int count;            /* pixels on the line */
    num_wide doubt;       /* num_cone()'s: base and square contain K, which is rounded */

    /* Returns true if pixel (x, y) of the view shows the ball `object`. It decides pixels in doubt; NULL: they count as
     * inside. */
    bool (*shows)(const struct tia_view *view, int x, int y, uint32_t object);
    const struct tia_view *view;
    uint32_t object;
    int y;
};

/* Pixels first..end-1; none when first >= end. */
struct span {
    int first, end;
};

static inline struct span span_within(struct span span, int first, int end)
{
    struct span r = {span.first > first ? span.first : first, span.end < end ? span.end : end};
    return r;
}

/* Returns the span of pixels inside the cone. `guess`, such as the span of the row above, affects only the speed;
 * without pixels, the roots of the quadratic are computed. */
struct span cone_row_span(const struct cone_row *cone_row, struct span guess);

/* Returns about the span, from the roots of (L.v)^2 = c v.v, a quadratic in X; no pixels where it has none, or where
 * the cone reaches 90 degrees from the line's middle. With a = c - slope^2 they are
 *
 *     base / a (slope +- sqrt(c (1 - a square / base^2))).
 */
struct span cone_row_estimate(const struct cone_row *cone_row);

#endif
