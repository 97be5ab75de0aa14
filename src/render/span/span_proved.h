/* span_proved.h - the error bounds of the integers at a pixel by name, each with its derivation.
 *
 * A row is the binary logarithm of a factor, in 256ths, rounded up; tests/proofs/span_error.g proves the factors.
 * span_error.c adds logarithms of products, and takes for a sum of two terms log(2^a + 2^b) <= max + log(1 + 2^-|a -
 * b|), which it computes by an upper limit. "Unseen" and "1 of 2" mean what simd/bound.h says.
 *
 * T is the mantissa of t, below 2^31. An accumulator's upper half is off by .51 of its last bit: products of T with a
 * form by .51 T of theirs, constants and shifts by half a bit. K = height cot(fov/2), a component of all directions, is
 * an integer and off by .51 of its last bit: that turns the rays.
 *
 * The point at which the integer code computes the light is P + d, |d| < 2^t |P|. That moves |Q - P|^2 by up to 2.1 |w|
 * |d|, r N.w, as computed c - L.Q + G.P, by |G| |d|, A.w by 1.1 (|A| + |w|) |d| and |A|^2 by 2.1 |A| |d|.
 *
 * A build that defines BOUND_SCALES scales a bound by its name, see simd/bound.h; in any other build a bound is
 * unscaled. */
#ifndef TIA_RENDER_SPAN_SPAN_PROVED_H
#define TIA_RENDER_SPAN_SPAN_PROVED_H

#ifdef BOUND_SCALES
#include BOUND_SCALES
#define SPAN_LOG(name) ((name) + bound_log_of(#name))
#else
#define SPAN_LOG(name) (name)
#endif

/* ---- t from outside ---- */

/* The error of S = b + sqrt(D), of itself, by that of D over 2 sqrt(D) S. The mantissas of b, v.v and c are below 2^31,
 * 2^31 and 2^32: D, in units of b's last bit squared, is off by .51 (2^32 + 2^32 + 2^31 + 2) < 1.28 2^32. D is least at
 * an end of the run, where it was computed, as span_shade.c makes sure; a computed root of 2^19 or more is within 1/32
 * of the exact one, and S within .02. So .64 2^32 32/31 1.02 of sqrt(D) S: 2^31.433. */
#define SPAN_ERROR_ROOT 8047

/* The error of S, of itself, by the rounding of b, .51, and of the root, which is rounded down: 1.51 1.02 of S, 2^.624.
 */
#define SPAN_ERROR_SUM 160

/* The error of S, of itself, by K in D. Where b^2 is c v.v, L without its part along v is r long, elsewhere shorter; so
 * D is off by 2 (.51 b r + .51/K D), b at most S. That over 2 sqrt(D) S, the first part: .51 32/31 of r over sqrt(D), r
 * in b's last bits: 2^-.925. */
#define SPAN_ERROR_TURNED_ROOT (-236)

/* The error of S, of itself, by K in b: .51 1.02 of L.z, in b's last bits, over S: 2^-.943. */
#define SPAN_ERROR_TURNED_SUM (-241)

/* The errors that are .51/K of t: D's second part in SPAN_ERROR_TURNED_ROOT, as the root is at most S; and P across the
 * ray: 1.02/K, 2^.029. */
#define SPAN_ERROR_TURNED 8

/* The rounding of T, of itself: 1/2 of T, which is at least half of its value at an end: S is at most 2 b, and b is
 * largest at an end. 1 of 1. */
#define SPAN_ERROR_ROUNDED 0

/* The relative errors of the reciprocal of S, 1.02 2^-31, of c, 2^-32, and from inside of T, whose half is 2^-32 of
 * 2^31: 2.02 2^-31, 2^-29.98. Proved: span_error.g (inverse). */
#define SPAN_ERROR_INVERSE (-7674)

/* The error of t S, which is c everywhere, at an end: less than 1/32, 2^.045. */
#define SPAN_ERROR_MANTISSA 12

/* ---- t from inside, as a part of 2^31 ---- */

/* The error of t by D, whose root is at least that of |c| K^2: 1.28 2^32 over 2 sqrt(D), 32/31, times 2^(63 - t_shift)
 * over v.v, of 2^31: 2^63.41 over sqrt(D) v.v 2^t_shift. */
#define SPAN_ERROR_INSIDE_ROOT 16233

/* The error of t by K in D and in b, and by the roundings of b and the root: by r over sqrt(D), .51 1.04 b r, b below
 * 2^31, as SPAN_ERROR_TURNED_ROOT has it: 2^62.09 r over sqrt(D) v.v 2^t_shift, r in b's last bits. Unseen: small. */
#define SPAN_ERROR_INSIDE_TURNED 15895

/* The same by .51 of L.z in b's last bits: 2^31.04 over v.v 2^t_shift. */
#define SPAN_ERROR_INSIDE_SUM 7946

/* The same by 1.51: 2^32.6. */
#define SPAN_ERROR_INSIDE_UNITS 8346

/* The rounding of v.v, .51, of itself: 2^-.97. */
#define SPAN_ERROR_INSIDE_SQUARE (-248)

/* ---- light ---- */

/* The error of |P|^2 = t reach by the rounding of reach = t v.v: T/2. */
#define SPAN_ERROR_REACH (-256)

/* The error of |P|^2 by v.v: .51 T^2 of its last bits, 2^-.97. */
#define SPAN_ERROR_REACH_SQUARE (-248)

/* The error of |Q - P|^2 by t Q.v, .51 T twice, and by half a bit each of the constant and a shift, as T is at least
 * 2^13: 2^.03. */
#define SPAN_ERROR_SQUARE 9

/* The error of |Q - P|^2 by that of t: 2.1 |w| |d|, 2^1.07. */
#define SPAN_ERROR_MOVED 275

/* The error of r N.(Q - P) by t G.v, .51 T, and half a bit of the constant: 2^-.97. */
#define SPAN_ERROR_FACING (-248)

/* |Q - P|^2 as computed, of which it is accurate to 1/32, over its least value: 2^.045. */
#define SPAN_ERROR_DISTANCE 12

/* The largest relative error of |Q - P|^2, 1/32, as the other rows assume. With a smaller one, fewer pixels have a
 * bound. Unseen: choice. */
#define SPAN_ERROR_CLOSE (-1280)

/* The second order of the cosine's error by r N.w and by |w|: 1.03, 2^.043. */
#define SPAN_ERROR_COSINE 11

/* The roundings of the products for a cosine: 2^-27.9. Proved: simd_integer.g (cosine). Unseen: small. */
#define SPAN_ERROR_KERNELS (-7142)

/* The error of a cosine of 2^28 in words.h by a point that is off by d, of 2^(e/2) d: 1/|w| is off by half of
 * SPAN_ERROR_MOVED, 1.05 |d|/|w|, of itself, and |w|^2 2^e is at least 2^28 there: 1.05 2^14, 2^14.071. Proved: words.g
 * (moved). Unseen: small. */
#define SPAN_ERROR_WORDS 3603

/* ---- shadows ---- */

/* The error of A.w by t (C + Q).v, .51 T, and half a bit of the constant and of two shifts, T being at least 2^13:
 * 2^-.97. */
#define SPAN_ERROR_TOWARD (-248)

/* The error of A.w by that of t: 1.1 (|A| + |w|) |d|, 2^.14. */
#define SPAN_ERROR_TOWARD_MOVED 36

/* The error of bias N.w, bias |w| times the cosine's, with its products' roundings: 1.05 2^-13, 2^-12.929. */
#define SPAN_ERROR_BIAS (-3309)

/* The error of |A'|^2 - R^2 by t C.v, .51 T twice, and half a bit each of the constant and a shift: 2^.03. */
#define SPAN_ERROR_POWER 9

/* The error of |A'|^2 - R^2 by that of t, 2.1 |A| |d|, and by N, 2 bias |A| |d|/r, which is less than a quarter of |A|
 * |d|, as r is at least 2^-10: 2.35, 2^1.233. */
#define SPAN_ERROR_POWER_MOVED 316

/* The error of |L - C|^2 - r^2 - R^2 times bias/(r + bias), of the size of the terms times bias/r: 1.5 2^-30 1.15 of a
 * quotient by r - bias, 2^-29.2, and 2^-13 for the bias. */
#define SPAN_ERROR_APART (-10800)

/* The rounding of the first factor of SPAN_ERROR_APART, which has the exponent 30: 1.5 2^-30 times bias/(r + bias), at
 * most 1/7: 2^-32.2. */
#define SPAN_ERROR_APART_UNITS (-8243)

/* The largest bound, 2^this in last bits, with which a pixel's shadow is decided: NUM_CLEAR times it must not overflow.
 * Unseen: choice. */
#define SPAN_ERROR_DOUBT_MOST (45 * 256)

/* The largest relative error of |w|^2 that num_cover_order's margin of 14 includes, 2^-17, see NUM_CLEAR. With a
 * smaller one, more pixels are decided by intervals. Unseen: choice. */
#define SPAN_ERROR_COVER (-17 * 256)

/* The smallest number of bits of a root with a bound, as SPAN_ERROR_ROOT assumes. With a larger number, fewer pixels
 * have one. Unseen: choice. */
#define SPAN_ERROR_ROOT_BITS 20

#endif
