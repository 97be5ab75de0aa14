/* shadows.h - bounds of shadows at a pixel: bounds.c, pair.c, prepare.c, exact.c, kernel_tmpl.h. */
#ifndef TIA_SIMD_SPAN_BOUNDS_SHADOWS_H
#define TIA_SIMD_SPAN_BOUNDS_SHADOWS_H

/* ---- A'.w ---- */

/* The roundings of A.w there that are not multiplied by T: the constant, the shift of |P|^2 and that of the bias: half
 * a bit each. 1.5 of 2.5. Unseen: small. */
#define BOUND_SPAN_TOWARD_UNITS 2.5

/* The rounding of t (C + Q).v there, times T: .505 of .52, as SPAN_FACING_T counts. */
#define BOUND_SPAN_TOWARD_T .52

/* The error of A.w: that by the kernels; that of t, the derivative t d/dt of A.w being (|C| + |Q|) |P| + 2 |P|^2 at
 * most; and the roundings there. */
FORMULA(SPAN_TOWARD);

/* The error of bias N.w, by which A'.w = A.w - bias N.w differs from A.w: bias times |w| times the cosine's error, |w|
 * <= |Q| + |P|. */
FORMULA(SPAN_TOWARD_BIAS);

/* The second order of SPAN_TOWARD_BIAS: |w| there may be e_w/2 above its largest: .01 of .05. Unseen: small. */
#define BOUND_SPAN_TOWARD_BIAS_SECOND .05

/* The roundings of the factors of bias N.w there: r N.w has half of a last bit that is at most 2^-29 of r |w|, 1/r is
 * within 1.02 2^-31. 3 of 16. Unseen: small. */
#define BOUND_SPAN_TOWARD_BIAS_UNITS 0x1p-27

/* ---- k; the part that the bias adds is a constant ---- */

/* The roundings of k there that are not multiplied by T: the constant, the bias's part and the shift of |P|^2: half a
 * bit each. 1.5 of 2.5. Unseen: small. */
#define BOUND_SPAN_POWER_UNITS 2.5

/* The rounding of 2 t C.v there, times T: 1.01 of 1.04, as SPAN_SQUARE_T counts. */
#define BOUND_SPAN_POWER_T 1.04

/* The error of k: that by the kernels; that of t, the derivative t d/dt of k being 2 |C| |P| + 2 |P|^2 at most; the
 * roundings there; and SPAN_SWELL and SPAN_SWELL_UNITS. */
FORMULA(SPAN_POWER);

/* The relative rounding there of |L - C|^2 - r^2 - R^2 - bias r, of the size of its terms: it is normalised to 30 bits,
 * 2^-30, and multiplied by 1/(r + bias) of 1.02 2^-31; 3 of 8. */
#define BOUND_SPAN_SWELL 0x1p-28

/* The rounding there of the part of k that the bias adds, before it is multiplied by bias/(r + bias): it has exponent
 * 30: squares are cut to a unit, the others rounded to half a unit. 3 of 16. */
#define BOUND_SPAN_SWELL_UNITS 0x1p-27

/* ---- |w|^2 and the comparisons ---- */

/* The relative roundings of |w|^2 k (1 + B) and (A'.w)^2 there, whose factors are cut to 30 bits: 2^-30 for k, as much
 * for |w|^2, 2^-31 twice for A'.w and 2^-31 for the product with B: 3.5 of 16. */
#define BOUND_SPAN_COVERED_CUT 0x1p-26

/* The roundings of (A'.w)^2 and of |w|^2 k (1 + B), each of itself. Proved: simd_forms.g (delta0, delta1), 4 of 10 u.
 */
#define BOUND_SPAN_DELTA SIMD_DELTA

/* The rounding of the comparison |w|^2 <= A'.w there, relative to |w|^2: the finer of both is shifted to the last bit
 * of the other, half of which is at most half of the sum of both. 1 of 2. Unseen: small. */
FORMULA(SPAN_COVERED_UNITS);

/* The relative error of |w|^2 for comparisons: e_w, SPAN_COVERED_CUT, SPAN_DELTA and SPAN_COVERED_UNITS. */
FORMULA(SPAN_COVERED);

/* The largest error of (A'.w)^2 - |w|^2 k (1 + B), a being A'.w and e its bound: e (2 |a| + e); |w|^2 (1 + B) times the
 * bound of k; and |w|^2's relative one of what is compared with a^2. */
FORMULA(SPAN_VERDICT);

/* The bound of A'.w: a pixel is lit for certain where A'.w is below 0 by more. */
FORMULA(SPAN_BEHIND);

/* The bounds of A'.w and |w|^2 together: a pixel is lit for certain, too, where A'.w is above |w|^2 by more. Where they
 * are equal the ray passes the light itself, which is outside of the caster, so that k gives the same verdict. Unseen:
 * hidden. */
FORMULA(SPAN_BEYOND);

/* The second order of A'.w's bound, which takes s^2 as computed, 2 e_s of it; and |w|^2's error makes all of the
 * verdict's bound too small by 1/(1 - e_w), together below 1.04. Of the kernels' roundings in the bound a tenth is to
 * spare, of those there 3 of 100: so .01 of .01. Unseen: small. */
#define BOUND_SPAN_VERDICT_A .01

/* The second order of |w|^2's bound, which is relative to the exact |w|^2 and, where in doubt, too small by 1/(1 -
 * e_w), as SPAN_VERDICT_A has it: .02 of .1. Unseen: small. */
#define BOUND_SPAN_VERDICT_W .1

/* The second order of k's bound for pixels in doubles, which takes s^2 and |w|^2 as computed, as SPAN_VERDICT_A counts.
 * Unseen: small. */
#define BOUND_SPAN_VERDICT_K .02

/* The second order of k's bound for runs in floats, as SPAN_VERDICT_K counts. Unseen: small. */
#define BOUND_SPAN_RUN_K .01

/* The second order of the bound's factor 1 + B for runs in floats, as SPAN_VERDICT_K counts. Unseen: small. */
#define BOUND_SPAN_RUN_SWELL .01

#endif
