/* depths.h - bounds for distances t, which row.c and seen.c use. */
#ifndef TIA_SIMD_SPAN_BOUNDS_DEPTHS_H
#define TIA_SIMD_SPAN_BOUNDS_DEPTHS_H

/* ---- arithmetics ---- */

/* The rounding unit u of the kernels' floats: half an ulp of 1. */
#define BOUND_SPAN_FLOAT_UNIT 0x1p-24

/* The rounding unit u of exact.c. An operation of doubles rounds by 2^-53. A coefficient has up to 6 such roundings:
 * conversions, 1/depth, its square, and products with these. The other rows count a coefficient as one rounding u,
 * which must therefore cover 6: 6 of 32. */
#define BOUND_SPAN_DOUBLE_UNIT 0x1p-48

/* The share of D's size below which a pixel is undecided in floats. A choice: the bound of S grows with 1/sqrt(D), and
 * SPAN_CELL_TURN is proved for this share. Unseen: choice. */
#define BOUND_SPAN_FLOAT_CUT 0x1p-8

/* The share of D's size below which a pixel is undecided in doubles, chosen like SPAN_FLOAT_CUT. Unseen: choice. */
#define BOUND_SPAN_DOUBLE_CUT 0x1p-16

/* The share of the cut by which the least D of a run must exceed the cut for the run to be drawn without a cut. A
 * choice: the floor that a cut gives is as good. Unseen: choice. */
#define BOUND_SPAN_CUT_CLEAR .1

/* The relative rounding of the ends of a range, in doubles: 6 roundings for coefficients, 3 for sums, and those of
 * roots. 12 of 2^13. Unseen: small. */
#define BOUND_SPAN_RANGE 0x1p-40

/* ---- 1/t in the kernels ---- */

/* The rounding of b = c0 + c1 x, relative to |c0| + |c1| X. Proved: simd_forms.g (linear), 3 of 4 u. */
#define BOUND_SPAN_LINEAR SIMD_LINEAR

/* The rounding of D = d0 + x (d1 + x d2), relative to D's size |d0| + |d1| X + |d2| X^2. Proved: simd_forms.g
 * (quadratic), 5 of 8 u. */
#define BOUND_SPAN_QUADRATIC SIMD_QUADRATIC

/* The error of sqrt(D): the error of D over the sum of the exact and the computed root, each at least the floor. */
FORMULA(SPAN_ROOT);

/* The share of the cut by which the exact D may be below the cut where the computed D is not: 8 u of D's size, which
 * for floats is 2^-13 of the cut. 1 of 160. Unseen: small. */
#define BOUND_SPAN_FLOOR .02

/* The relative rounding of S = b + sqrt(D), without the errors of b and D: that of the root, which is computed from an
 * estimate and at most half of the sum, and that of the sum. Proved: simd_forms.g (sum), 8 of 10 u. */
#define BOUND_SPAN_SUM SIMD_SUM

/* e_s, the relative error of 1/t in the kernels: the bounds of b and sqrt(D) over the least S, plus SPAN_SUM. */
FORMULA(SPAN_KERNELS_T);

/* ---- t in the integer code ---- */

/* The integer code's rounding of D = b^2 - c v.v, in last bits of b, v.v and c_disc. b and v.v are upper halves of
 * accumulators. Each of the three is off by at most half of its last bit and 2^-18 of it: .5 of .51. */
#define BOUND_SPAN_D_UNITS .51

/* The integer code's rounding of S = b + sqrt(D), in last bits of b: half a bit for b, as in SPAN_D_UNITS, and one bit
 * for the root, which is rounded down. 1.5 of 1.51. */
#define BOUND_SPAN_SUM_UNITS 1.51

/* The relative errors, in the integer code, of the reciprocal of S and of c, which is rounded to 32 bits. Proved:
 * simd_integer.g (quotient), 3 of 8. */
#define BOUND_SPAN_QUOTIENT 0x1p-29

/* The integer code's rounding of t, in last bits of t. t is rounded to nearest: .5 of .51. */
#define BOUND_SPAN_T_UNIT .51

/* e_t, the relative error of t in the integer code: SPAN_SUM_UNITS and D's bound over the floor, both over the least S;
 * SPAN_QUOTIENT; and SPAN_T_UNIT over the least t. The root of the exact D is at least the floor. */
FORMULA(SPAN_INTEGER_T);

/* The limit of e_s + e_t below which a run is drawn. The rows for second-order errors rely on it, and the cells' bounds
 * are proved with 1/S within .01. A smaller limit leaves more runs to plain C. Unseen: choice. */
#define BOUND_SPAN_KNOWN .01

/* ---- the nearer of two ---- */

/* The integer code's error of b, for the least and the largest S of a whole part of a row. It is .51 of b's last bit;
 * tia_simd_between() bounds the root by itself. 1 of 2. Unseen: small. */
FORMULA(SPAN_BETWEEN_B);

/* The integer code's relative errors of the reciprocal and of c, as in SPAN_QUOTIENT: 3 of 16. Unseen: small. */
#define BOUND_SPAN_BETWEEN_QUOTIENT 0x1p-28

/* The integer code's rounding of t, to nearest. 1 of 2. */
FORMULA(SPAN_BETWEEN_UNIT);

/* The relative error of a sphere's 1/t at a pixel where two spheres are compared: the sphere's e_s and e_t, and
 * SPAN_NEARER_ROUNDING. */
FORMULA(SPAN_NEARER);

/* The second-order error in SPAN_NEARER: e_s is relative to the exact 1/t, but multiplies the computed one. .01 of .05.
 * Unseen: small. */
#define BOUND_SPAN_NEARER_SECOND .05

/* The rounding of the comparison: 1/c as a float, its product with S, and the difference: 3 of 4 u. */
#define BOUND_SPAN_NEARER_ROUNDING (4 * BOUND_SPAN_FLOAT_UNIT)

#endif
