/* shadows.h - bounds of shadows at a pixel: bounds.c, pair.c, prepare.c, exact.c, kernel_tmpl.h. */
#ifndef TIA_SIMD_SPAN_BOUNDS_SHADOWS_H
#define TIA_SIMD_SPAN_BOUNDS_SHADOWS_H

/* ---- A'.w ---- */

/* A.w there: the constant, the shift of |P|^2 and that of the bias: half a bit each. 1.5 of 2.5. Unseen: small. */
#define BOUND_SPAN_TOWARD_UNITS 2.5

/* t (C + Q).v there: as SPAN_FACING_T counts, .505 of .52. */
#define BOUND_SPAN_TOWARD_T .52

/* A.w, by the kernels and there, whose derivative t d/dt is (|C| + |Q|) |P| + 2 |P|^2 at most. */
FORMULA(SPAN_TOWARD);

/* A'.w = A.w - bias N.w: bias times |w| times the cosine's error, |w| <= |Q| + |P|. */
FORMULA(SPAN_TOWARD_BIAS);

/* |w| there may be e_w/2 above its largest: .01 of .05. Unseen: small. */
#define BOUND_SPAN_TOWARD_BIAS_SECOND .05

/* The factors there: r N.w has half of a last bit that is at most 2^-29 of r |w|, 1/r is within 1.02 2^-31. 3 of 16.
 * Unseen: small. */
#define BOUND_SPAN_TOWARD_BIAS_UNITS 0x1p-27

/* ---- k; the part that the bias adds is a constant ---- */

/* k there: the constant, the bias's part and the shift of |P|^2: half a bit each. 1.5 of 2.5. Unseen: small. */
#define BOUND_SPAN_POWER_UNITS 2.5

/* 2 t C.v there: as SPAN_SQUARE_T counts, 1.01 of 1.04. */
#define BOUND_SPAN_POWER_T 1.04

/* k, by the kernels and there, whose derivative t d/dt is 2 |C| |P| + 2 |P|^2 at most; SPAN_SWELL and
 * SPAN_SWELL_UNITS. */
FORMULA(SPAN_POWER);

/* |L - C|^2 - r^2 - R^2 - bias r there is normalised to 30 bits, 2^-30, and multiplied by 1/(r + bias) of 1.02 2^-31; 3
 * of 8 of its size. */
#define BOUND_SPAN_SWELL 0x1p-28

/* The part that the bias adds has exponent 30: squares are cut to a unit, the others rounded to half a unit. 3 of
 * 16. */
#define BOUND_SPAN_SWELL_UNITS 0x1p-27

/* ---- |w|^2 and the comparisons ---- */

/* |w|^2 k (1 + B) and (A'.w)^2 there: the factors are cut to 30 bits, 2^-30 for k, as much for |w|^2, 2^-31 twice for
 * A'.w and 2^-31 for the product with B: 3.5 of 16. */
#define BOUND_SPAN_COVERED_CUT 0x1p-26

/* (A'.w)^2 and |w|^2 k (1 + B), each. Proved: simd_forms.g (delta0, delta1), 4 of 10 u. */
#define BOUND_SPAN_DELTA SIMD_DELTA

/* |w|^2 <= A'.w there: the finer of both is shifted to the last bit of the other, half of which is at most half of the
 * sum of both. 1 of 2. Unseen: small. */
FORMULA(SPAN_COVERED_UNITS);

/* |w|^2's relative bound for comparisons: e_w, SPAN_COVERED_CUT, SPAN_DELTA and SPAN_COVERED_UNITS. */
FORMULA(SPAN_COVERED);

/* The largest error of (A'.w)^2 - |w|^2 k (1 + B), a being A'.w and e its bound: e (2 |a| + e); |w|^2 (1 + B) times
 * that of k; and |w|^2's relative one of what is compared with a^2. */
FORMULA(SPAN_VERDICT);

/* A pixel is lit for certain where A'.w is below 0 by its bound. */
FORMULA(SPAN_BEHIND);

/* A pixel is lit for certain, too, where A'.w is above |w|^2 by the bounds of both. Where they are equal the ray passes
 * the light itself, which is outside of the caster, so that k gives the same verdict. Unseen: hidden. */
FORMULA(SPAN_BEYOND);

/* A'.w's bound takes s^2 as computed, 2 e_s of it, and |w|^2's error makes all of the verdict's bound too small by 1/(1
 * - e_w), together below 1.04. Of the kernels' roundings in it a tenth is to spare, of those there 3 of 100: so .01 of
 * .01. Unseen: small. */
#define BOUND_SPAN_VERDICT_A .01

/* The bound of |w|^2 is relative to the exact |w|^2, and where in doubt too small by 1/(1 - e_w), as SPAN_VERDICT_A has
 * it: .02 of .1. Unseen: small. */
#define BOUND_SPAN_VERDICT_W .1

/* k's bound takes s^2 and |w|^2 as computed, as SPAN_VERDICT_A counts; this for pixels in doubles. Unseen: small. */
#define BOUND_SPAN_VERDICT_K .02

/* As SPAN_VERDICT_K, for runs in floats. Unseen: small. */
#define BOUND_SPAN_RUN_K .01
#define BOUND_SPAN_RUN_SWELL .01 /* as SPAN_VERDICT_K, for the factor 1 + B in floats. Unseen: small. */

#endif
