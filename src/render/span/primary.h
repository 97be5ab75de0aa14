/* primary.h - the directions of an image's pixels, and what is linear in them.
 *
 * Pixel (x, y) looks along v = (2x+1-width, height-2y-1, -height/tan(fov/2)), not normalised: integers
 * but for the last, which all pixels share. The exponent is chosen so that |v| < 2^30.
 */
#ifndef TIA_LATTICE_H
#define TIA_LATTICE_H

#include "num/num.h"

struct lattice {
    int width, height;
    int exponent;              /* f, of lattice numbers */
    num_wide x_reach, y_reach; /* beyond every |X| and |Y| of the image */
    num_wide depth;            /* height/tan(fov/2) */
    int square_shift;          /* v.v * 2^square_shift fills an accumulator */
};

void lattice_prepare(struct lattice *lattice, unsigned width, unsigned height, tia_q16 fov);

/* A product a.v along a row as an accumulator: start at the first pixel, then add step. */
struct row_form {
    num_wide start, step;
};

/* v.v along a row: start at pixel x, then add step, then add twice to step. */
struct row_square {
    num_wide start, step, twice;
};

/* The largest |a.v| that a pixel of the image can have: it is met in a corner. */
num_wide lattice_reach(const struct lattice *lattice, struct num_vec a);

/* a.v * 2^shift from pixel (x, y) on, as num_top takes it. */
struct row_form lattice_form(const struct lattice *lattice, struct num_vec a, int x, int y, int shift);

/* v.v * 2^square_shift from pixel (x, y) on. */
struct row_square lattice_square(const struct lattice *lattice, int x, int y);

/* height - 2y - 1, as a lattice number. */
num_wide lattice_y(const struct lattice *lattice, int y);

#endif
