/* shadows.h - bounds for shadows at a pixel, which bounds.c, pair.c, prepare.c and kernel_tmpl.h use. */
#ifndef TIA_SIMD_SPAN_BOUNDS_SHADOWS_H
#define TIA_SIMD_SPAN_BOUNDS_SHADOWS_H

/* ---- A'.w ---- */

/* The rounding of a coefficient in doubles, relative to the sizes of its terms, which may cancel: conversions, 1/K, B =
 * bias/r, products and sums. 11 of 16 u. Unseen: small. */
#define BOUND_SPAN_PARTS 0x1p-49

/* The rounding of D.G + r |D + G| + r^2, which is negative for a caster behind a sphere: SPAN_PARTS of its terms.
 * Unseen: small. */
FORMULA(SPAN_BACK);

/* The rounding of the comparisons of lengths by which a caster is a light's shade: SPAN_PARTS of the sum of the
 * lengths. Unseen: small. */
FORMULA(SPAN_SHADE);

/* The error of A'.w: the kernels' error; the error of P times the derivative of A.w, which is at most |C| + |Q| + 2
 * |P|; and the rounding of the coefficients, SPAN_PARTS of C.Q, (C + Q).P, B K and B G.P. */
FORMULA(SPAN_TOWARD);

/* The error of bias N.w, the difference of A.w and A'.w: the bias times |w|, at most |Q| + |P|, times the error of the
 * cosine. Unseen: small. */
FORMULA(SPAN_TOWARD_BIAS);

/* The second-order error in SPAN_TOWARD_BIAS: |w| may exceed its computed maximum by e_w/2. .01 of .05. Unseen:
 * small. */
#define BOUND_SPAN_TOWARD_BIAS_SECOND .05

/* ---- k, with the constant that the bias adds ---- */

/* The error of k: the kernels' error; the error of P times the derivative of k, which is at most 2 |C| + 2 |P|; and
 * SPAN_POWER_PARTS. */
FORMULA(SPAN_POWER);

/* The rounding of k's constant: SPAN_PARTS of c, and of the terms of |L - C|^2 - r^2 - R^2 - bias r times bias/(r +
 * bias). Unseen: small. */
FORMULA(SPAN_POWER_PARTS);

/* ---- |w|^2 and the comparisons ---- */

/* The relative roundings of (A'.w)^2 and of |w|^2 k (1 + B), each. Proved: simd_forms.g (delta0, delta1), 4 of 10 u. */
#define BOUND_SPAN_DELTA SIMD_DELTA

/* The relative error of |w|^2 in comparisons: e_w and SPAN_DELTA. */
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
 * the bound must grow by a factor of up to 1.04. The counts of the kernels' roundings have a tenth to spare; the rest
 * is .01 of .01. Unseen: small. */
#define BOUND_SPAN_VERDICT_A .01

/* The second-order error in the bound of |w|^2. The bound is relative to the exact |w|^2, and the bound of the verdict
 * may be too small by the factor 1 - e_w, as in SPAN_VERDICT_A: .02 of .1. Unseen: small. */
#define BOUND_SPAN_VERDICT_W .1

/* The second-order error in the bound of k, which is multiplied by the computed s^2 and |w|^2, as in SPAN_VERDICT_A.
 * Unseen: small. */
#define BOUND_SPAN_RUN_K .01

/* The second-order error in the factor 1 + B of that bound, counted as in SPAN_VERDICT_A. Unseen: small. */
#define BOUND_SPAN_RUN_SWELL .01

#endif
