/* rays.h - error bounds of exact shadow rays: rays_tmpl.h. rays/bounds.h explains the notation. */
#ifndef TIA_SIMD_SHADOW_BOUNDS_RAYS_H
#define TIA_SIMD_SHADOW_BOUNDS_RAYS_H

#include "simd/bound.h"
#include "simd/rays/sure_numbers.h"

/* The rounding of M.D - m s, see shadow/occluder.h, relative to |M|.|D| + |m| S. S is the largest sum of sizes of the
 * terms of s = a x + b y + c in a block. Each of these is a quotient of two numbers of 128 bits, converted with 2 u
 * each: 5 u. A product and two sums: 3 u. With m, converted with u from a mantissa of 62 bits, and the product: 10 u S.
 * M.D: a conversion, a product and two sums, 4 u; the difference: u of both. Needed: 11 of 32 u. */
#define BOUND_RAY_SIDE (32 * SURE_EPS)

/* The rounding of the coefficients of M, less than a unit each, where they have one: (i + j + 1) units. Unseen: small.
 */
FORMULA(RAY_CUT);

/* The least s, in multiples of its error 16 u S; smaller ones are undecided. A choice. Unseen: choice. */
#define BOUND_RAY_NEAR (256 * SURE_EPS)

/* The relative rounding of a point D/s: that of s, below 8 u S/s, and 4 u of a quotient and products. In orthographic
 * views the third coordinate is s, in units of the vertices. Needed: 12 of 32 u S/s. Unseen: choice. */
#define BOUND_RAY_POINT (32 * SURE_EPS)

/* The largest error of a point, in units of the vertices; boxes are enlarged for 8, see shadow/casters.c. Unseen:
 * choice. */
#define BOUND_RAY_OFF 4

#endif
