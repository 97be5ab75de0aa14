/* proved.h - bounds of the sums of kernel_tmpl.h and exact.c in units of half an ulp, and the factors of cells_tmpl.h
 * for roundings, as tests/proofs/simd_*.g prove: they read the numbers here. */
#ifndef TIA_SIMD_SPAN_PROVED_H
#define TIA_SIMD_SPAN_PROVED_H

#define SIMD_LINEAR 4    /* rounding of c0 + c1 x, of |c0| + |c1| X */
#define SIMD_QUADRATIC 8 /* rounding of d0 + x (d1 + x d2), of |d0| + |d1| X + |d2| X^2 */
#define SIMD_SUM 10      /* rounding of b + sqrt(D), of itself, but for the errors of its parts */
#define SIMD_ROOT 12     /* rounding of 1/sqrt(x), of itself */
#define SIMD_INVERSE 6   /* rounding of 1/x, of itself, from an estimate */
#define SIMD_TERM 8      /* rounding of each term of a s^2 + h s + v.v, but for the error of s */
#define SIMD_FACING 6    /* rounding of K s in K s + G.v */
#define SIMD_TURN 7      /* rounding of G.v in K s + G.v */
#define SIMD_LAMBERT 24  /* rounding of r N.w/(r |w|), but for the errors of both */
#define SIMD_COLOUR 6    /* rounding of lambert times tint and colour, and the sum, for a light; as much for a caster */
#define SIMD_LINE 15     /* rounding of two lines between three samples */
#define SIMD_DELTA 10    /* rounding of (A'.w)^2 and of |w|^2 k (1 + B), each */

/* The factors of cells_tmpl.h. CELL_TURN assumes that D is at least 2^-8 of its size. */
#define CELL_TURN 13     /* error of S': 2^-13 of each of its two parts */
#define CELL_SLOPE 2     /* rounding of (2 d2 x + d1)/2 in units, where x may be a pixel outside of the run */
#define CELL_MOTION 1001 /* factor for roundings of |P'| and |P''|, in 1/1000; S's error is in v_most and v_step */
#define CELL_FAR 30      /* relative error of |w|, in 1/1000: S within .01 and |w|^2 within .019 */
#define CELL_UNIT 1200   /* factor for the roundings of the distance that a shadow's edge must keep, in 1/1000 */
#define CELL_BEND 1160   /* largest a sqrt(4 - 3 a^2), in 1/1000 */
#define CELL_OFF 1010    /* factor for the roundings of a line's error, in 1/1000 */

#endif
