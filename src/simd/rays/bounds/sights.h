/* sights.h - bounds of the points that the rasteriser has found: plain_tmpl.h. */
#ifndef TIA_SIMD_RAYS_BOUNDS_SIGHTS_H
#define TIA_SIMD_RAYS_BOUNDS_SIGHTS_H

/* The rounding of i = a x + b y + c, the inverse of a face's distance along the line of sight, or in orthographic views
 * of the distance, relative to |a| x + |b| y + |c|. Each coefficient is a quotient of two numbers of 128 bits,
 * converted with 2 u each, times the quotient of a power of two and an integer: 7 u. A product and two sums: 3 u. In
 * fixed point: 2^-58 of the distance. Needed: 10.1 of 16 u. */
#define BOUND_SIGHT_SUM (16 * SURE_EPS)

/* The least i and the least slope, in multiples of their errors; smaller ones are undecided. A choice, and the reason
 * for SIGHT_QUOTIENT. Unseen: choice. */
#define BOUND_SIGHT_KNOWN 16

/* The factor of 1/i and of 1/s that bounds the inverse of a fixed-point divisor, which is off by at most 1/16 of
 * itself: 16/15. Needed: 1.067 of 1.125. */
#define BOUND_SIGHT_QUOTIENT 1.125

/* The rounding of the distance along the line of sight in fixed point: half a unit, see tia_raster_distance(). Needed:
 * .5 of 1 U. */
#define BOUND_SIGHT_UNIT SURE_UNIT

/* The error of the distance z = 1/i: SIGHT_QUOTIENT e/i^2. QUOTIENT covers the roundings of the quotient, 2^-58 in
 * fixed point, and SIGHT_UNIT is added. */
FORMULA(SIGHT_INVERSE);

/* The error of t = z/s, with the slope s = D.-n, as PLANE_DISTANCE: the error of z, and t times that of the slope, over
 * the least slope. QUOTIENT covers the roundings of z (1/s), 2 u, and of the fixed-point quotient. */
FORMULA(SIGHT_DISTANCE);

#endif
