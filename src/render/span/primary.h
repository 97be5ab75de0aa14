/* primary.h - the directions of an image's pixels, and linear forms of them.
 *
 * Pixel (x, y) has the direction v = (2x+1-width, height-2y-1, -height/tan(fov/2)), not normalised: all components are
 * integers except the last, which is the same for all pixels. The exponent is chosen so that |v| < 2^30.
 */
#ifndef TIA_RENDER_SPAN_PRIMARY_H
#define TIA_RENDER_SPAN_PRIMARY_H

#include "num/num.h"

struct primary_rays {
    int width, height;
    int exponent;              /* the exponent f of pixel coordinates */
    num_wide x_reach, y_reach; /* above every |X| and |Y| of the image */
    num_wide depth;            /* K = height/tan(fov/2) */
    bool exact;                /* K is not rounded */
    int square_shift;          /* v.v times 2^square_shift uses all bits of an accumulator */
};

void primary_prepare(struct primary_rays *primary, unsigned width, unsigned height, tia_q16 fov);

/* An accumulator of a.v along a row: `start` is its value at the first pixel; `step` is added for each next one. */
struct row_form {
    num_wide start, step;
};

/* An accumulator of v.v along a row: `start` is its value at the first pixel. For each next pixel, `step` is added to
 * it, and then `twice` to `step`. */
struct row_square {
    num_wide start, step, twice;
};

/* Returns an upper limit of |a.v| for all pixels of the image: the value at a corner, with some headroom. */
num_wide primary_reach(const struct primary_rays *primary, const struct num_vec *a);

/* Returns a.v * 2^shift from pixel (x, y) on, for num_top. */
struct row_form primary_form(const struct primary_rays *primary, const struct num_vec *a, int x, int y, int shift);

/* Returns v.v * 2^square_shift from pixel (x, y) on. */
struct row_square primary_square(const struct primary_rays *primary, int x, int y);

/* Returns height - 2y - 1, as a pixel coordinate. */
num_wide primary_y(const struct primary_rays *primary, int y);

#endif
