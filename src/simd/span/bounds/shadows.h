/* shadows.h - bounds for shadows at a pixel, which bounds.c, pair.c, prepare.c, exact.c and kernel_tmpl.h use. */
#ifndef TIA_SIMD_SPAN_BOUNDS_SHADOWS_H
#define TIA_SIMD_SPAN_BOUNDS_SHADOWS_H

/* ---- A'.w ---- */

/* The integer code's roundings of A.w that are not multiplied by T: half a bit each for the constant, the shift of
 * |P|^2 and the shift of the bias. 1.5 of 2.5. Unseen: small. */
#define BOUND_SPAN_TOWARD_UNITS 2.5

/* The integer code's rounding of t (C + Q).v, to be multiplied by T. Counted as in SPAN_FACING_T: .505 of .52. */
#define BOUND_SPAN_TOWARD_T .52

/* The error of A.w: the bound of the kernels' error; the error of the integer code's t, where t d/dt of A.w is at most
 * (|C| + |Q|) |P| + 2 |P|^2; and the integer code's roundings. */
FORMULA(SPAN_TOWARD);

/* The error of bias N.w, the difference of A.w and A'.w: the bias times |w|, at most |Q| + |P|, times the error of the
 * cosine. */
FORMULA(SPAN_TOWARD_BIAS);

/* The second-order error in SPAN_TOWARD_BIAS: in the integer code |w| may exceed its exact maximum by e_w/2. .01 of
 * .05. Unseen: small. */
#define BOUND_SPAN_TOWARD_BIAS_SECOND .05

/* The integer code's roundings of the factors of bias N.w: for r N.w half of its last bit, which is at most 2^-29 of r
 * |w|; for 1/r 1.02 2^-31. 3 of 16. Unseen: small. */
#define BOUND_SPAN_TOWARD_BIAS_UNITS 0x1p-27

/* ---- k, with the constant that the bias adds ---- */

/* The integer code's roundings of k that are not multiplied by T: half a bit each for the constant, the part that the
 * bias adds, and the shift of |P|^2. 1.5 of 2.5. Unseen: small. */
#define BOUND_SPAN_POWER_UNITS 2.5

/* The integer code's rounding of 2 t C.v, to be multiplied by T. Counted as in SPAN_SQUARE_T: 1.01 of 1.04. */
#define BOUND_SPAN_POWER_T 1.04

/* The error of k: the bound of the kernels' error; the error of the integer code's t, where t d/dt of k is at most 2
 * |C| |P| + 2 |P|^2; the integer code's roundings; and SPAN_SWELL and SPAN_SWELL_UNITS. */
FORMULA(SPAN_POWER);

/* The integer code's rounding of (|L - C|^2 - r^2 - R^2 - bias r)/(r + bias), relative to the size of the numerator's
 * terms: 2^-30 for the numerator, which is normalised to 30 bits, and 1.02 2^-31 for the reciprocal. 3 of 8. */
#define BOUND_SPAN_SWELL 0x1p-28

/* The integer code's rounding of the numerator in SPAN_SWELL, which has the exponent 30: a unit for |L - C|^2, which is
 * rounded down, and half a unit for the other terms. 3 of 16. */
#define BOUND_SPAN_SWELL_UNITS 0x1p-27

/* ---- |w|^2 and the comparisons ---- */

/* The integer code's relative roundings of |w|^2 k (1 + B) and (A'.w)^2, whose factors are cut to 31 or 32 bits: 2^-30
 * each for k and |w|^2, 2^-31 twice for A'.w, and 2^-31 for the product with B. 3.5 of 16. */
#define BOUND_SPAN_COVERED_CUT 0x1p-26

/* The relative roundings of (A'.w)^2 and of |w|^2 k (1 + B), each. Proved: simd_forms.g (delta0, delta1), 4 of 10 u. */
#define BOUND_SPAN_DELTA SIMD_DELTA

/* The integer code's rounding in the comparison |w|^2 <= A'.w, relative to |w|^2. The finer of the two values is
 * rounded to the last bit of the coarser: an error of at most half the sum of both last bits. 1 of 2. Unseen: small. */
FORMULA(SPAN_COVERED_UNITS);

/* The relative error of |w|^2 in comparisons: e_w, SPAN_COVERED_CUT, SPAN_DELTA and SPAN_COVERED_UNITS. */
FORMULA(SPAN_COVERED);

/* The error of (A'.w)^2 - |w|^2 k (1 + B), with a for A'.w and e for the bound of A'.w: e (2 |a| + e), plus |w|^2 (1 +
 * B) times the bound of k, plus a^2 times the relative bound of |w|^2. Where the sign is in doubt, a^2 and |w|^2 k (1 +
 * B) are nearly equal. */
FORMULA(SPAN_VERDICT);

/* The bound of A'.w. A pixel is certainly lit where A'.w is negative by more than this. */
FORMULA(SPAN_BEHIND);

/* The bounds of A'.w and |w|^2 together. A pixel is certainly lit where A'.w exceeds |w|^2 by more than this. Where the
 * two are equal, the light is the ray's nearest point to C. As the light is outside of the caster, k gives the same
 * verdict there. Unseen: hidden. */
FORMULA(SPAN_BEYOND);

/* The second-order error in the bound of A'.w. The bound is multiplied by the computed s^2, which may be too small by 2
 * e_s of itself. The error of |w|^2 may make the whole bound of the verdict too small by the factor 1 - e_w. Together
 * the bound must grow by a factor of up to 1.04. The counts of the kernels' roundings have a tenth to spare, those of
 * the integer code's 3 of 100; the rest is .01 of .01. Unseen: small. */
#define BOUND_SPAN_VERDICT_A .01

/* The second-order error in the bound of |w|^2. The bound is relative to the exact |w|^2, and the bound of the verdict
 * may be too small by the factor 1 - e_w, as in SPAN_VERDICT_A: .02 of .1. Unseen: small. */
#define BOUND_SPAN_VERDICT_W .1

/* The second-order error in the bound of k for pixels in doubles. The bound is multiplied by the computed s^2 and
 * |w|^2, as in SPAN_VERDICT_A. Unseen: small. */
#define BOUND_SPAN_VERDICT_K .02

/* The second-order error in the bound of k for runs in floats, counted as in SPAN_VERDICT_K. Unseen: small. */
#define BOUND_SPAN_RUN_K .01

/* The second-order error in the factor 1 + B of that bound, for runs in floats, counted as in SPAN_VERDICT_K. Unseen:
 * small. */
#define BOUND_SPAN_RUN_SWELL .01

#endif
