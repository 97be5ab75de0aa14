/* distance.h - the distance of a sphere at a pixel in double precision, with its bound. */
#ifndef TIA_SIMD_SPAN_DISTANCE_H
#define TIA_SIMD_SPAN_DISTANCE_H

#include <math.h>

#include "bound_table.h"
#include "sums.h"

/* t and the bound of its relative error. v is in units of pixel coordinates, lengths are in units of 2^-16. */
struct simd_distance {
    double t, off;
};

/* Gives the distance at pixel x, which sees the sphere; false when its error cannot be bounded. */
static inline bool simd_distance_at(const struct primary_rays *primary, const struct simd_row *row, int x,
                                    const struct span_sphere *sphere, struct simd_distance *at)
{
    num_wide across = simd_across(primary, x), whole = simd_product(primary, row, sphere->centre, across);
    double z = (double)sphere->centre.z, c = (double)sphere->c, b = (double)whole - z * row->lacks, size = fabs(b);
    double d = simd_discriminant(primary, row, sphere, whole, across), turn = row->turn * row->depth;
    double b_off = BOUND_OF(SPAN_AXIS_B, fabs(z) * turn);
    double d_off = BOUND_OF(SPAN_AXIS_D, 2 * turn * (size * fabs(z) + fabs(c) * row->depth));

    if (!(d > 2 * d_off)) /* NaN, too */
        return false;
    double root = sqrt(d), sum = size + root, per_both = 1 / (root * sum);
    if (c > 0 || b < 0)
        at->t = fabs(c) * root * per_both;
    else
        at->t = sum / ((double)(across * across + row->square) + row->lacks2);
    at->off =
        BOUND_OF(SPAN_DISTANCE_T, ((b_off * root + d_off) * per_both + 2 * row->turn) * (1 + BOUND(SPAN_AXIS_SECOND)) +
                                      BOUND(SPAN_DISTANCE_UNITS) * BOUND(SPAN_DOUBLE_UNIT));
    return (c > 0 ? b > b_off : c < 0) && at->off < BOUND(SPAN_KNOWN);
}

#endif
