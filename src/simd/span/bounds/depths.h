/* depths.h - bounds of distances: row.c, seen.c. */
#ifndef TIA_SIMD_SPAN_BOUNDS_DEPTHS_H
#define TIA_SIMD_SPAN_BOUNDS_DEPTHS_H

/* ---- arithmetics ---- */

/* A float of 1 is rounded by half an ulp. */
#define BOUND_SPAN_FLOAT_UNIT 0x1p-24

/* A double of 1 is rounded by 2^-53, and its coefficients by as much up to 6 times: conversions, 1/depth, its square
 * and products with them. Each number of u has one of these; so 6 of 32. */
#define BOUND_SPAN_DOUBLE_UNIT 0x1p-48

/* The shares of D's size below which a pixel is undecided. A choice: S's bound grows with 1/sqrt(D), and SPAN_CELL_TURN
 * is proved for this share. Unseen: choice. */
#define BOUND_SPAN_FLOAT_CUT 0x1p-8
#define BOUND_SPAN_DOUBLE_CUT 0x1p-16 /* for doubles, as SPAN_FLOAT_CUT. Unseen: choice. */

/* The least D is above the cut by this share of it if no pixel is to be cut. A choice: a floor is as good with a cut.
 * Unseen: choice. */
#define BOUND_SPAN_CUT_CLEAR .1

/* Ranges of doubles, from coefficients of 6 u of a double, sums of 3 and roots: 12 of 2^13 u. Unseen: small. */
#define BOUND_SPAN_RANGE 0x1p-40

/* ---- 1/t by the kernels ---- */

/* b: c0 + c1 x, of |c0| + |c1| X. Proved: simd_forms.g (linear), 3 of 4 u. */
#define BOUND_SPAN_LINEAR SIMD_LINEAR

/* D: d0 + x (d1 + x d2), of |d0| + |d1| X + |d2| X^2. Proved: simd_forms.g (quadratic), 5 of 8 u. */
#define BOUND_SPAN_QUADRATIC SIMD_QUADRATIC

/* sqrt(D): the bound of D over the sum of both roots, each at least the floor. */
FORMULA(SPAN_ROOT);

/* The computed D is at least the cut, and so the exact D at least the cut less 8 u of the size, 2^-13 of the cut for
 * floats. 1 of 160. Unseen: small. */
#define BOUND_SPAN_FLOOR .02

/* b + sqrt(D) apart from the errors of its parts, of itself: a root by an estimate, at most half of the sum, and the
 * sum. Proved: simd_forms.g (sum), 8 of 10 u. */
#define BOUND_SPAN_SUM SIMD_SUM

/* e_s: the bounds of b, sqrt(D) and the sum, over the least sum. */
FORMULA(SPAN_KERNELS_T);

/* ---- 1/t there ---- */

/* D = b^2 - c v.v: upper halves of b and v.v and c_disc, each rounded to half of its last bit and 2^-18 of it: .5 of
 * .51. */
#define BOUND_SPAN_D_UNITS .51

/* b's half bit, as SPAN_D_UNITS, and one bit for the root, which is rounded down. 1.5 of 1.51. */
#define BOUND_SPAN_SUM_UNITS 1.51

/* The reciprocal of S and c's 32 bits. Proved: simd_integer.g (quotient), 3 of 8. */
#define BOUND_SPAN_QUOTIENT 0x1p-29

/* t is rounded to nearest. .5 of .51. */
#define BOUND_SPAN_T_UNIT .51

/* e_t: the bound of D over the floor, which the root of the exact D is not below, and with those of b and the root,
 * over the least sum; SPAN_QUOTIENT and SPAN_T_UNIT. */
FORMULA(SPAN_INTEGER_T);

/* The largest sum of e_s and e_t. Their second orders, e^2 of 2 e, and other rows assume that they are small: cells are
 * proved with 1/S within .01. A smaller value leaves more to plain C. Unseen: choice. */
#define BOUND_SPAN_KNOWN .01

/* ---- the nearer of two ---- */

/* The least sum of a whole line there: b is off by .51 of its last bit, whatever the root; 1 of 2. Unseen: small. */
FORMULA(SPAN_BETWEEN_B);

/* The reciprocal and c, as SPAN_QUOTIENT: 3 of 16. Unseen: small. */
#define BOUND_SPAN_BETWEEN_QUOTIENT 0x1p-28

/* t is rounded to nearest, 1 of 2. */
FORMULA(SPAN_BETWEEN_UNIT);

/* A pixel's two 1/t are off by e_s and e_t each. */
FORMULA(SPAN_NEARER);

/* e_s is of the exact 1/t, and multiplies the computed one: .01 of .05. Unseen: small. */
#define BOUND_SPAN_NEARER_SECOND .05

/* 1/c as a float, its product with S, and the difference: 3 of 4 u. */
#define BOUND_SPAN_NEARER_ROUNDING (4 * BOUND_SPAN_FLOAT_UNIT)

#endif
