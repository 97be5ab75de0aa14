/* levels.h - bounds of lights, colours and levels: bounds.c, bound_cache.c. */
#ifndef TIA_SIMD_SPAN_BOUNDS_LEVELS_H
#define TIA_SIMD_SPAN_BOUNDS_LEVELS_H

/* ---- |w|^2 = |Q - P|^2 ---- */

/* The light's distance from the sphere: lengths of 5 roundings of a double, and a difference. 6 of 32. Unseen: small.
 */
#define BOUND_SPAN_GAP 0x1p-48

/* |w| at least, from ranges: |w| >= ||G| - r|, |P| - |Q| and |Q| - |P|. The ranges include SPAN_RANGE already: a few of
 * 2^23 u. Unseen: small. */
#define BOUND_SPAN_DISTANCE 0x1p-30

/* A term of a s^2 + h s + v.v but for the error of s, of its size. Proved: simd_forms.g (term2, term1, term0), 7 of 8
 * u.
 */
#define BOUND_SPAN_TERM SIMD_TERM

/* A quadratic in s by the kernels, over s^2: a s^2 moves by twice e_s, h s by e_s; and each has its roundings. */
FORMULA(SPAN_FORM);

/* e_s^2 of 2 e_s, e_s being below .01: .005 of .01. Unseen: small. */
#define BOUND_SPAN_FORM_SECOND .01

/* |P|^2 there is t reach, reach = t v.v rounded to half of its last bit. T may be e_t above its largest: .505 of .52.
 */
#define BOUND_SPAN_REACH_T .52

/* Its v.v is off by half of its last bit and 2^-18 of it, times t^2, which e_t moves as well: .51 of .51. */
#define BOUND_SPAN_REACH_SQUARE .51

/* The error of |P|^2 there but for t's own: t times that of reach. */
FORMULA(SPAN_REACH);

/* t's own error moves a form by its derivative, t d/dt of |w|^2 being 2 |Q| |P| + 2 |P|^2 at most. The second order is
 * e_t/2 of that, .005 of .02. Unseen: small. */
#define BOUND_SPAN_MOVED .02

/* Q.Q and the shift of |P|^2 there: half a bit each; SPAN_SQUARE_T, which is multiplied by T, is far larger. 1 of 1.
 * Unseen: small. */
#define BOUND_SPAN_SQUARE_UNITS 1

/* 2 t Q.v there: Q.v is off by half a bit and 2^-18 of it, times 2 T, which may be e_t above its largest: 1.01 of 1.02.
 */
#define BOUND_SPAN_SQUARE_T 1.02

/* e_w: the bounds of |w|^2 by the kernels and there, over the least |w|^2. */
FORMULA(SPAN_SQUARE);

/* ---- the cosine r N.w/(r |w|) ---- */

/* K s of K s + G.v. Proved: simd_forms.g (facing), 3 of 6 u. */
#define BOUND_SPAN_FACING SIMD_FACING

/* G.v of K s + G.v. Proved: simd_forms.g (turn), 5 of 7 u. */
#define BOUND_SPAN_TURN SIMD_TURN

/* K s is linear in s, so that e_s has no second order: 0 of .01. Unseen: small. */
#define BOUND_SPAN_FACING_SECOND .01

/* The constant there is rounded to half a bit. .5 of .5. Unseen: small. */
#define BOUND_SPAN_FACING_UNITS .5

/* t G.v there: half a bit of G.v and 2^-18 of it, times T, which may be e_t above its largest: .505 of .51. */
#define BOUND_SPAN_FACING_T .51

/* r N.w: the kernels' bound; there, the error of t and the roundings. */
FORMULA(SPAN_FACING_OFF);

/* 1/r, 1/sqrt and two products. Proved: simd_forms.g (lambert), 15 of 24 u. */
#define BOUND_SPAN_LAMBERT SIMD_LAMBERT

/* The error of r N.w over the exact r |w|: the error of 1/|w| is in SPAN_COSINE_SQUARE. 0 of .01. Unseen: small. */
#define BOUND_SPAN_COSINE_FACING .01

/* 1/|w| is off by 1 - sqrt(1 - e_w) at most, .5051 e_w where e_w is below .04, of the cosine as computed, which is at
 * most 1.01: .511 of .53. */
#define BOUND_SPAN_COSINE_SQUARE .53

/* The shift of r N.w there (2^-30), the inverse root (2^-30) and its product (2^-30), 1/r (2^-31) and the cosine
 * (2^-31). Proved: simd_integer.g (cosine), 4 of 16. */
#define BOUND_SPAN_COSINE_UNITS 0x1p-26

/* e_c: the error of r N.w over r |w|, that of 1/|w|, and the roundings of both. */
FORMULA(SPAN_COSINE);

/* The largest e_w with which a cosine is bounded: SPAN_COSINE_SQUARE is derived for it. Unseen: choice. */
#define BOUND_SPAN_SQUARE_KNOWN .04

/* The largest e_c with which a run is drawn, so that e_w is below .019: SPAN_CELL_FAR and the verdicts of shadows are
 * derived for it. Unseen: choice. */
#define BOUND_SPAN_COSINE_KNOWN .01

/* ---- colours and levels ---- */

/* Lambert times tint and colour, and the sum: for a light; as much for a caster. Proved: simd_forms.g (colour,
 * colour_sum, caster), 4 of 6 u. */
#define BOUND_SPAN_COLOUR SIMD_COLOUR

/* There the product of two colours and its product with lambert have half of 2^-30 each; a caster's as many. 1 of 1. */
#define BOUND_SPAN_COLOUR_UNITS 0x1p-30

/* Two lines between three samples, of 1.01. Proved: simd_forms.g (line), 11 of 15 u. */
#define BOUND_SPAN_LINE SIMD_LINE

/* A light's share of a colour: its colour times the bounds of the cosine and of lines, and SPAN_COLOUR and
 * SPAN_COLOUR_UNITS. Minima, maxima and clamps only bring values nearer. */
FORMULA(SPAN_COLOURS);

/* The levels of a colour, 31 or 63 of them, are off by as many times the colour's error, and by SPAN_LEVEL_ROUNDING. */
FORMULA(SPAN_LEVELS);

/* The emission as a float, the product with the levels and the sum with the threshold, each of 63 or 64 at most: 3 of 6
 * u. */
#define BOUND_SPAN_LEVEL_ROUNDING 6

/* The bound is computed in doubles, and cells subtract theirs in floats, 3 u of .5 at most: 2^-22 of .01. Unseen:
 * small. */
#define BOUND_SPAN_LEVEL_SECOND .01

/* The threshold less 1/2, the bound and the distance from a level as floats, each of 1/2 at most: 2 of 6 u. Unseen:
 * small.
 */
#define BOUND_SPAN_LEVEL_NEAR 6

/* The least value of half a level less its bounds. A choice: with less nearly all of a run would be undecided. Unseen:
 * choice. */
#define BOUND_SPAN_LEVEL_LEAST .1

/* The share by which the limits of cached bounds are worse than those of their run. A choice: for a single run 0 is as
 * good. Unseen: choice. */
#define BOUND_SPAN_KEPT .1

#endif
