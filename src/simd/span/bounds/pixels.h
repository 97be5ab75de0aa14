/* pixels.h - bounds for single pixels in doubles, which exact.c and distance.h use. Lengths are in units of 2^-16; u is
 * 2^-53. "moved" is the bound of the distance between the computed and the exact P. */
#ifndef TIA_SIMD_SPAN_BOUNDS_PIXELS_H
#define TIA_SIMD_SPAN_BOUNDS_PIXELS_H

/* ---- the point ---- */

/* The relative rounding of t. Proved: simd_pixels.g (outside, inside), 10 of 10 u. */
#define BOUND_SPAN_DISTANCE_UNITS PIXEL_DISTANCE

/* The relative error of t: those that the errors of b, D and v.v cause, SPAN_AXIS_B and SPAN_AXIS_D, and the rounding.
 * D is at least twice its error, so that sqrt(D) is off by less than the error of D over sqrt(D). */
FORMULA(SPAN_DISTANCE_T);

/* The relative rounding of P = t v: K and the product. Proved: simd_pixels.g (point), 2 of 3 u. Unseen: small. */
#define BOUND_SPAN_PIXEL_POINT_UNITS PIXEL_POINT

/* The relative error of P = t v: the error of t, the error of v that K causes, and the rounding. "moved" is the sum of
 * the sizes of P's components times this. */
FORMULA(SPAN_PIXEL_POINT);

/* The second-order errors in the rows of this table. "moved" over r and over |w| is below .005, and the relative error
 * of t below .01: .01 of .02. Unseen: small. */
#define BOUND_SPAN_PIXEL_SECOND .02

/* The limit of "moved" over r and over |w| below which a pixel is decided, as SPAN_PIXEL_SECOND assumes. Unseen:
 * choice. */
#define BOUND_SPAN_PIXEL_NEAR .005

/* The error of the start P + bias N = P + bias/r (P - L): "moved" times 1 + bias/r, and the rounding. */
FORMULA(SPAN_PIXEL_START);

/* The rounding of the start, relative to the start and to 4 times bias N: bias/r, the difference and the product. 1 of
 * 2 u. */
#define BOUND_SPAN_PIXEL_START_UNITS 2

/* ---- a light ---- */

/* The relative rounding of |w|^2, and of its product with h. Proved: simd_pixels.g (square), 7 of 8 u. */
#define BOUND_SPAN_PIXEL_SQUARE_UNITS PIXEL_SQUARE

/* e_w, the relative error of |w|^2, w = Q - P: twice "moved" over |w|, and the rounding. */
FORMULA(SPAN_PIXEL_SQUARE);

/* The rounding of the cosine. Proved: simd_pixels.g (cosine), 10 of 11 u. Unseen: small. */
#define BOUND_SPAN_PIXEL_COSINE_UNITS PIXEL_COSINE

/* e_c, the error of the cosine (r N).w/(r |w|): the error of r N = P - L over r, that of w over |w|, that of 1/|w|,
 * which is e_w/2, and the rounding. */
FORMULA(SPAN_PIXEL_COSINE);

/* ---- a caster ---- */

/* The rounding of A.w, relative to |A| |w|. Proved: simd_pixels.g (toward), 5 of 6 u. */
#define BOUND_SPAN_PIXEL_A_UNITS PIXEL_TOWARD

/* The error of A.w: the error of A, which is that of the start, times |w|; |A| times the error of w; and the
 * rounding. */
FORMULA(SPAN_PIXEL_A);

/* The rounding of h = c + S.(S - 2 C), where S is the start, relative to the sizes of its terms. Proved: simd_pixels.g
 * (power), 5 of 6 u. */
#define BOUND_SPAN_PIXEL_H_UNITS PIXEL_POWER

/* The error of h = |A|^2 - R^2: the error of A times 2 |A|, its square, and the rounding. */
FORMULA(SPAN_PIXEL_H);

/* The rounding of (A.w)^2 and of the difference, relative to (A.w)^2. e_w includes those of h |w|^2. 2 of 4 u. Unseen:
 * small. */
#define BOUND_SPAN_PIXEL_DELTA_UNITS 4

/* The error of (A.w)^2 - h |w|^2: e (2 |A.w| + e), where e is the error of A.w; |w|^2 times the error of h; |h| times
 * that of |w|^2; and the rounding. */
FORMULA(SPAN_PIXEL_DELTA);

/* The errors of A.w and |w|^2 together. Where the two are equal, the light is the ray's nearest point to C, but for the
 * bias. As the light is outside of the caster, h gives the same verdict there. Unseen: hidden. */
FORMULA(SPAN_PIXEL_BEYOND);

/* ---- the colour ---- */

/* The rounding of a light's contribution to a channel, relative to the light's colour: the product of both colours and
 * its product with the cosine. The code adds 2 u for each transmission. 2 of 4 u. Unseen: small. */
#define BOUND_SPAN_PIXEL_COLOUR_UNITS 4

/* The error of a light's contribution to a channel: the light's colour times the error of the cosine and the rounding;
 * and u for the sum, which is at most 1 before and after. */
FORMULA(SPAN_PIXEL_COLOUR);

/* The rounding of a level, which is at most 64: the product with the number of levels, the sum with the threshold, and
 * the bound itself. 192 of 256 u. */
#define BOUND_SPAN_PIXEL_LEVEL_UNITS 256

/* The error of a level: 31 or 63 times the error of the channel, and the rounding. */
FORMULA(SPAN_PIXEL_LEVEL);

#endif
