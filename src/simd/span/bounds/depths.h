/* depths.h - bounds for distances t, which row.c and seen.c use. */
#ifndef TIA_SIMD_SPAN_BOUNDS_DEPTHS_H
#define TIA_SIMD_SPAN_BOUNDS_DEPTHS_H

/* ---- arithmetics ---- */

/* The rounding unit u of the kernels' floats: half an ulp of 1. */
#define BOUND_SPAN_FLOAT_UNIT 0x1p-24

/* The rounding unit u of doubles: half an ulp of 1. */
#define BOUND_SPAN_DOUBLE_UNIT 0x1p-53

/* The share of D's size below which a pixel is undecided in floats. A choice: the bound of S grows with 1/sqrt(D), and
 * SPAN_CELL_TURN is proved for this share. Unseen: choice. */
#define BOUND_SPAN_FLOAT_CUT 0x1p-11

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

/* The share of the cut by which the exact D may be below the cut where the computed D is not: 8 u of D's size, which is
 * 2^-10 of the cut. 1 of 20. Unseen: small. */
#define BOUND_SPAN_FLOOR .02

/* The relative rounding of S = b + sqrt(D), without the errors of b and D: that of the root, which is computed from an
 * estimate and at most half of the sum, and that of the sum. Proved: simd_forms.g (sum), 8 of 10 u. */
#define BOUND_SPAN_SUM SIMD_SUM

/* e_s, the relative error of 1/t in the kernels: the bounds of b and sqrt(D) over the least S, plus SPAN_SUM. */
FORMULA(SPAN_KERNELS_T);

/* ---- K ---- */

/* The relative error of K in 64 bits: a unit of the last bit, 2^-63, and the radius of the ball that K is taken from. 1
 * of 2. Unseen: small. */
#define BOUND_SPAN_AXIS_K 0x1p-62

/* The roundings of K - K0 and of what it adds to b, D and v.v, relative to K - K0: products of up to four factors and
 * sums, in doubles. 6 of 8 u. Unseen: small. */
#define BOUND_SPAN_AXIS_ADDED 0x1p-50

/* The relative error of K: SPAN_AXIS_K and SPAN_AXIS_ADDED. With v scaled to depth 1, the component of v along the axis
 * is off by as much, and the others are exact. Unseen: small. */
FORMULA(SPAN_AXIS);

/* The error of b = L.v that the error of K causes: |L.z| times SPAN_AXIS. Unseen: small. */
FORMULA(SPAN_AXIS_B);

/* The error of D = b^2 - c v.v that the error of K causes: 2 b times that of b, and c times that of v.v, which is twice
 * that of v's component along the axis. Unseen: small. */
FORMULA(SPAN_AXIS_D);

/* e_t, the error of P that the error of K causes, as a share of |P|. Along v, t is off by the errors of b and sqrt(D)
 * over S = b + sqrt(D). The error of sqrt(D) is that of D over the sum of the exact and the computed root, of which the
 * computed one is at least the floor. Across v, P is off by the error of v, whose length is at least 1. Unseen:
 * small. */
FORMULA(SPAN_AXIS_P);

/* The second-order errors of b^2, v.v and 1/S, as e_t is below .01: .01 of .02. Unseen: small. */
#define BOUND_SPAN_AXIS_SECOND .02

/* The limit of e_s + e_t below which a run is drawn, and of the relative error of t below which a single pixel is. The
 * rows for second-order errors rely on it, and the cells' bounds are proved with 1/S within .01. A smaller limit leaves
 * more runs to single pixels. Unseen: choice. */
#define BOUND_SPAN_KNOWN .01

/* ---- the nearer of two ---- */

/* The relative error of a sphere's 1/t at a pixel where two spheres are compared: the sphere's e_s and e_t, and
 * SPAN_NEARER_ROUNDING. */
FORMULA(SPAN_NEARER);

/* The second-order error in SPAN_NEARER: e_s is relative to the exact 1/t, but multiplies the computed one. .01 of .05.
 * Unseen: small. */
#define BOUND_SPAN_NEARER_SECOND .05

/* The rounding of the comparison: 1/c as a float, its product with S, and the difference: 3 of 4 u. */
#define BOUND_SPAN_NEARER_ROUNDING (4 * BOUND_SPAN_FLOAT_UNIT)

/* The error of the difference of two distances in doubles: the sum of their errors. */
FORMULA(SPAN_WINS);

/* The second-order error in SPAN_WINS, whose errors are relative to the exact distances but multiply the computed ones,
 * and the rounding of the difference: .01 of .02. Unseen: small. */
#define BOUND_SPAN_WINS_SECOND .02

#endif
