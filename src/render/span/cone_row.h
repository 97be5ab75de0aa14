/* cone_row.h - where a line of pixels meets a cone of rays, exactly.
 *
 * Seen from the eye a sphere with centre L and radius r fills the cone of all directions v with
 *
 *     L.v >= 0   and   (L.v)^2 >= c v.v,   c = L.L - r^2.
 *
 * Along a line of pixels v = (X, ...), X = 2i + 1 - n for pixel i of n, the product is linear and
 * the square quadratic: L.v = slope X + base and v.v = X^2 + square. A cone is convex, so its
 * pixels on the line are one run, and both ends are found by exact comparisons: from a guess in
 * a few steps, or by bisection.
 */
#ifndef TIA_SLICE_H
#define TIA_SLICE_H

#include "num/num.h"

struct slice {
    num_wide slope, base; /* exponents 16 and 16 + f */
    num_wide square;      /* exponent 2 f */
    num_wide c;           /* exponent 32 */
    int exponent;         /* f, the lattice's */
    int count;            /* pixels on the line */
};

/* Pixels first..end-1; none when first == end. */
struct run {
    int first, end;
};

static inline struct run run_within(struct run run, int first, int end)
{
    struct run r = {run.first > first ? run.first : first, run.end < end ? run.end : end};
    return r;
}

/* The run of pixels inside the cone. `guess` is where it may be, for speed only: the answer does
 * not depend on it. */
struct run slice_run(const struct slice *slice, struct run guess);

#endif
