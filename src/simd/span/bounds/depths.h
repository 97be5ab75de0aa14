/* depths.h - bounds of distances: row.c, seen.c. */
#ifndef TIA_SIMD_SPAN_BOUNDS_DEPTHS_H
#define TIA_SIMD_SPAN_BOUNDS_DEPTHS_H

/* ---- arithmetics ---- */

/* The rounding of a float of 1: half an ulp. */
#define BOUND_SPAN_FLOAT_UNIT 0x1p-24

/* The rounding of a double of 1, 2^-53, and of its coefficients, as much up to 6 times: conversions, 1/depth, its
 * square and products with them. Each number of u has one of these; so 6 of 32. */
#define BOUND_SPAN_DOUBLE_UNIT 0x1p-48

/* The share of D's size below which a pixel is undecided in floats. A choice: S's bound grows with 1/sqrt(D), and
 * SPAN_CELL_TURN is proved for this share. Unseen: choice. */
#define BOUND_SPAN_FLOAT_CUT 0x1p-8

/* The share of D's size below which a pixel is undecided in doubles, chosen like SPAN_FLOAT_CUT. Unseen: choice. */
#define BOUND_SPAN_DOUBLE_CUT 0x1p-16

/* The share of the cut by which the least D must be above the cut if no pixel is to be cut. A choice: a floor is as
 * good with a cut. Unseen: choice. */
#define BOUND_SPAN_CUT_CLEAR .1

/* The relative rounding of a range of doubles: coefficients of 6 u of a double, sums of 3, and roots: 12 of 2^13 u.
 * Unseen: small. */
#define BOUND_SPAN_RANGE 0x1p-40

/* ---- 1/t by the kernels ---- */

/* The rounding of b = c0 + c1 x, of |c0| + |c1| X. Proved: simd_forms.g (linear), 3 of 4 u. */
#define BOUND_SPAN_LINEAR SIMD_LINEAR

/* The rounding of D = d0 + x (d1 + x d2), of |d0| + |d1| X + |d2| X^2. Proved: simd_forms.g (quadratic), 5 of 8 u. */
#define BOUND_SPAN_QUADRATIC SIMD_QUADRATIC

/* The error of sqrt(D): that of D over the sum of both roots, each at least the floor. */
FORMULA(SPAN_ROOT);

/* The share of the cut by which the exact D may be below the cut, while the computed D is not: 8 u of the size, 2^-13
 * of the cut for floats. 1 of 160. Unseen: small. */
#define BOUND_SPAN_FLOOR .02

/* The rounding of S = b + sqrt(D), of itself, apart from the errors of its parts: a root by an estimate, at most half
 * of the sum, and the sum. Proved: simd_forms.g (sum), 8 of 10 u. */
#define BOUND_SPAN_SUM SIMD_SUM

/* e_s, the relative error of 1/t by the kernels: the bounds of b, sqrt(D) and the sum, over the least sum. */
FORMULA(SPAN_KERNELS_T);

/* ---- 1/t there ---- */

/* The rounding of D = b^2 - c v.v there, in last bits of its parts: upper halves of b and v.v and c_disc, each rounded
 * to half of its last bit and 2^-18 of it: .5 of .51. */
#define BOUND_SPAN_D_UNITS .51

/* The rounding of S = b + sqrt(D) there, in last bits of b: b's half bit, as in SPAN_D_UNITS, and one bit for the root,
 * which is rounded down. 1.5 of 1.51. */
#define BOUND_SPAN_SUM_UNITS 1.51

/* The relative errors of the reciprocal of S and of c's 32 bits there. Proved: simd_integer.g (quotient), 3 of 8. */
#define BOUND_SPAN_QUOTIENT 0x1p-29

/* The rounding of t there, in last bits of t: t is rounded to nearest. .5 of .51. */
#define BOUND_SPAN_T_UNIT .51

/* e_t, the relative error of t there: the bound of D over the floor, which the root of the exact D is not below, with
 * those of b and the root, over the least sum; SPAN_QUOTIENT and SPAN_T_UNIT. */
FORMULA(SPAN_INTEGER_T);

/* The largest sum of e_s and e_t. Their second orders, e^2 of 2 e, and other rows assume that they are small: cells are
 * proved with 1/S within .01. A smaller value leaves more to plain C. Unseen: choice. */
#define BOUND_SPAN_KNOWN .01

/* ---- the nearer of two ---- */

/* The error of b there, by which the least and the largest sum of a whole line are off: .51 of b's last bit, whatever
 * the root; 1 of 2. Unseen: small. */
FORMULA(SPAN_BETWEEN_B);

/* The relative errors of the reciprocal and of c there, as SPAN_QUOTIENT: 3 of 16. Unseen: small. */
#define BOUND_SPAN_BETWEEN_QUOTIENT 0x1p-28

/* The rounding of t there: t is rounded to nearest, 1 of 2. */
FORMULA(SPAN_BETWEEN_UNIT);

/* The relative error of 1/t at a pixel where two are compared: e_s and e_t for each of the two, and the roundings. */
FORMULA(SPAN_NEARER);

/* The second order of e_s and e_t: e_s is a part of the exact 1/t, and multiplies the computed one: .01 of .05. Unseen:
 * small. */
#define BOUND_SPAN_NEARER_SECOND .05

/* The rounding of the comparison: 1/c as a float, its product with S, and the difference: 3 of 4 u. */
#define BOUND_SPAN_NEARER_ROUNDING (4 * BOUND_SPAN_FLOAT_UNIT)

#endif
