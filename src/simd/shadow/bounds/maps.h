/* maps.h - error bounds of shadow maps: keep_tmpl.h and spots_tmpl.h. rays/bounds.h explains the notation. Positions in
 * fixed point have TIA_WORLD_BITS fraction bits; V is 2^-28, their unit. */
#ifndef TIA_SIMD_SHADOW_BOUNDS_MAPS_H
#define TIA_SIMD_SHADOW_BOUNDS_MAPS_H

#include "simd/bound.h"
#include "simd/rays/sure_numbers.h"

/* ---- distances at texels ---- */

/* The rounding of a texel's distance v = factor/f 2^-places, or factor f 2^-places for parallel rays, below 2^32.
 * factor is converted, and the quotient and a half less: 3 u. For parallel rays, whose runs have f between two such
 * values: the scale, f and its step are converted and multiplied, 4 u, and added: 6 u. Needed: 6 2^-21 of 2^-18. */
#define BOUND_MAP_DISTANCE P2M(18)

/* ---- points ---- */

/* The rounding of a point in doubles, relative to |O|1 + (1 + z) L, where z is the distance from the eye and L is the
 * largest sum of sizes of a pixel's row in struct tia_world. The three terms of first + x right + y down: 5 u L. Its
 * product with z: u L z. The light's position and the difference: 2 u. Turned into the view's axes, three products and
 * two sums of numbers below this size, times components with u: 4 u sqrt 3. Needed: 15 of 32 u. Unseen: small. */
#define BOUND_MAP_ROUNDING (32 * SURE_EPS)

/* The roundings of a position in fixed point: half a unit of a product, in orthographic views of a second one. Needed:
 * 1 of 1 V. */
#define BOUND_MAP_UNIT P2M(28)

/* The error of a point: that of its distance from the eye times L, and the roundings. Unseen: small. */
FORMULA(MAP_POINT);

/* The error of a point's coordinate along an axis of a view, which is a unit vector, so sqrt 3 times that of each
 * coordinate, rounded to half a unit. Unseen: small. */
FORMULA(MAP_ALONG);

/* The least distance of a point from the light along the view's axis, in multiples of its error; nearer points are
 * undecided. A choice, and the reason for MAP_QUOTIENT. Unseen: choice. */
#define BOUND_MAP_FRONT 16

/* The factor of 1/w that bounds the inverse of a divisor that is off by at most 1/16 of itself: 16/15. Needed: 1.067 of
 * 1.125. */
#define BOUND_MAP_QUOTIENT 1.125

/* The rounding of a column or row: half a unit of 2^-16 texels. Needed: 2^-17 of 2^-15. */
#define BOUND_MAP_COLUMN P2M(15)

/* The error of t = a/w: (1 + |t|) times that of a and w over the least w, and a unit of 2^-28 in fixed point. In
 * texels, it is multiplied by their density; MAP_TEXELS and MAP_COLUMN are added. */
FORMULA(MAP_TANGENT);

/* The relative rounding of a column or row: a quotient and its factor, 2 u; the density and its product, 2 u. Needed: 4
 * of 4 u. Unseen: small. */
#define BOUND_MAP_TEXELS (4 * SURE_EPS)

/* ---- limits ---- */

/* The rounding of h, relative to |W|1. N is converted, three products and two sums: 4 u; |W|^2: 2 u; in fixed point
 * 2^-57 for the normalised W. Needed: 6.1 of 16 u. Unseen: small. */
#define BOUND_MAP_COSINE (16 * SURE_EPS)

/* The error of h = N.W, where W is the way to the light, for the tangent sqrt(|W|^2/h^2 - 1): sqrt 3 times that of a
 * coordinate of W, and as much again, since in fixed point |W| has that error, too. Needed: 3.47 of 4. Unseen: small.
 */
FORMULA(MAP_TURN);

/* The error of |W|^2/h^2 = t^2 + 1, where h is off by the part p < 1/32 of itself: (1 - p)^-2 - 1 <= 2.13 p.
 * Needed: 2.13 of 2.2. Unseen: small. */
FORMULA(MAP_SECANT);

/* The rounding of a tangent in fixed point, 2^-16; in doubles less than 2^-40. Needed: 2^-16 of 2^-15. */
#define BOUND_MAP_SLOPE P2M(15)

/* The error of a bias: amount times that of a texel's size, which is rounded to V, and V. Unseen: small. */
FORMULA(MAP_BIAS);

/* The error of a limit: those of the distance and the bias are taken at their ends; two roundings of half a unit.
 * Unseen: small. */
FORMULA(MAP_LIMIT);

#endif
