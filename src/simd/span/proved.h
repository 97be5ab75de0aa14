/* proved.h - the numbers that tests/proofs/simd_*.g read and prove: bounds of the roundings in kernel_tmpl.h, in units
 * u of half an ulp, the factors in cells_tmpl.h that cover roundings, and bounds of the roundings in exact.c and
 * distance.h. */
#ifndef TIA_SIMD_SPAN_PROVED_H
#define TIA_SIMD_SPAN_PROVED_H

#define SIMD_LINEAR 4    /* rounding of c0 + c1 x, relative to |c0| + |c1| X */
#define SIMD_QUADRATIC 8 /* rounding of d0 + x (d1 + x d2), relative to |d0| + |d1| X + |d2| X^2 */
#define SIMD_SUM 10      /* relative rounding of b + sqrt(D), without the errors of b and D */
#define SIMD_ROOT 12     /* relative rounding of 1/sqrt(x) */
#define SIMD_INVERSE 6   /* relative rounding of 1/x, which is computed from an estimate */
#define SIMD_TERM 8      /* relative rounding of each term of a s^2 + h s + v.v, without the error of s */
#define SIMD_FACING 6    /* relative rounding of K s in K s + G.v */
#define SIMD_TURN 7      /* rounding of G.v in K s + G.v, relative to |g0| + |g1| X */
#define SIMD_LAMBERT 24  /* relative rounding of r N.w/(r |w|), without the errors of r N.w and |w| */
#define SIMD_COLOUR 6    /* relative rounding of lambert times tint and colour; as much for each caster */
#define SIMD_LINE 15     /* rounding of two lines between three samples */
#define SIMD_DELTA 10    /* relative rounding of (A'.w)^2 and of |w|^2 k (1 + B), each */

/* The roundings of single pixels in exact.c and distance.h, in units u of doubles, 2^-53: simd_pixels.g. */
#define PIXEL_DISTANCE 10 /* relative rounding of t */
#define PIXEL_POINT 3     /* relative rounding of P */
#define PIXEL_SQUARE 8    /* relative rounding of |w|^2, and of its product with h */
#define PIXEL_COSINE 11   /* rounding of the cosine */
#define PIXEL_TOWARD 6    /* rounding of A.w, relative to |A| |w| */
#define PIXEL_POWER 6     /* rounding of h, relative to the sizes of its terms */

/* The factors of cells_tmpl.h. CELL_TURN assumes that D is at least 2^-11 of its size. */
#define CELL_TURN 10     /* error of S': 2^-10 of each of its two terms */
#define CELL_SLOPE 2     /* rounding of (2 d2 x + d1)/2, in u, relative to |d1| + 2 |d2| X */
#define CELL_MOTION 1001 /* factor for the roundings of |P'| and |P''|, in 1/1000, without the error of S */
#define CELL_FAR 30      /* relative error of |w|, in 1/1000, where that of S is below .01, that of |w|^2 below .019 */
#define CELL_UNIT 1200   /* factor for the roundings of the margins around a shadow's edge, in 1/1000 */
#define CELL_BEND 1160   /* largest a sqrt(4 - 3 a^2), in 1/1000 */
#define CELL_OFF 1010    /* factor for the roundings of a line's error, in 1/1000 */

#endif
