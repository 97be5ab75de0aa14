/* levels.h - bounds of lights, colours and levels: bounds.c, bound_cache.c. */
#ifndef TIA_SIMD_SPAN_BOUNDS_LEVELS_H
#define TIA_SIMD_SPAN_BOUNDS_LEVELS_H

/* ---- |w|^2 = |Q - P|^2 ---- */

/* The rounding of ||G| - r|, the light's distance from the sphere: lengths of 5 roundings of a double, and a
 * difference. 6 of 32. Unseen: small. */
#define BOUND_SPAN_GAP 0x1p-48

/* The relative rounding of the least |w|, from ranges: |w| >= ||G| - r|, |P| - |Q| and |Q| - |P|. The ranges include
 * SPAN_RANGE already: a few of 2^23 u. Unseen: small. */
#define BOUND_SPAN_DISTANCE 0x1p-30

/* The rounding of a term of a s^2 + h s + v.v, of the term's size, but for the error of s. Proved: simd_forms.g (term2,
 * term1, term0), 7 of 8 u. */
#define BOUND_SPAN_TERM SIMD_TERM

/* The error of a quadratic a s^2 + h s + v.v by the kernels, over s^2: a s^2 moves by twice e_s, h s by e_s; and each
 * term has SPAN_TERM. */
FORMULA(SPAN_FORM);

/* The second order of SPAN_FORM: e_s^2 of 2 e_s, e_s being below .01: .005 of .01. Unseen: small. */
#define BOUND_SPAN_FORM_SECOND .01

/* The rounding of reach = t v.v there, times T, the mantissa of t, as |P|^2 is t reach: half of the last bit of reach.
 * T may be e_t above its largest: .505 of .52. */
#define BOUND_SPAN_REACH_T .52

/* The rounding of v.v in |P|^2 there, times t^2, which e_t moves as well: half of v.v's last bit and 2^-18 of it: .51
 * of .51. */
#define BOUND_SPAN_REACH_SQUARE .51

/* The error of |P|^2 there but for t's own: t times that of reach, SPAN_REACH_T and SPAN_REACH_SQUARE. */
FORMULA(SPAN_REACH);

/* The second order of a form's move by t's own error. In first order the form moves by its derivative, t d/dt of |w|^2
 * being 2 |Q| |P| + 2 |P|^2 at most; the second is e_t/2 of that, .005 of .02. Unseen: small. */
#define BOUND_SPAN_MOVED .02

/* The roundings of Q.Q and of the shift of |P|^2 there: half a bit each; SPAN_SQUARE_T, which is multiplied by T, is
 * far larger. 1 of 1. Unseen: small. */
#define BOUND_SPAN_SQUARE_UNITS 1

/* The rounding of 2 t Q.v there: Q.v is off by half a bit and 2^-18 of it, times 2 T, which may be e_t above its
 * largest: 1.01 of 1.02. */
#define BOUND_SPAN_SQUARE_T 1.02

/* e_w, the relative error of |w|^2: its bounds by the kernels and there, over the least |w|^2. */
FORMULA(SPAN_SQUARE);

/* ---- the cosine r N.w/(r |w|) ---- */

/* The rounding of K s in K s + G.v. Proved: simd_forms.g (facing), 3 of 6 u. */
#define BOUND_SPAN_FACING SIMD_FACING

/* The rounding of G.v in K s + G.v. Proved: simd_forms.g (turn), 5 of 7 u. */
#define BOUND_SPAN_TURN SIMD_TURN

/* The second order of K s in e_s, which is none, as K s is linear in s: 0 of .01. Unseen: small. */
#define BOUND_SPAN_FACING_SECOND .01

/* The rounding of r N.w's constant there: half a bit. .5 of .5. Unseen: small. */
#define BOUND_SPAN_FACING_UNITS .5

/* The rounding of t G.v there: half a bit of G.v and 2^-18 of it, times T, which may be e_t above its largest: .505 of
 * .51. */
#define BOUND_SPAN_FACING_T .51

/* The error of r N.w: the kernels' bound; there, the error of t and the roundings. */
FORMULA(SPAN_FACING_OFF);

/* The rounding of r N.w/(r |w|): 1/r, 1/sqrt and two products. Proved: simd_forms.g (lambert), 15 of 24 u. */
#define BOUND_SPAN_LAMBERT SIMD_LAMBERT

/* The second order of r N.w's error over r |w|, which is none: |w| is the exact one, and the error of 1/|w| is in
 * SPAN_COSINE_SQUARE. 0 of .01. Unseen: small. */
#define BOUND_SPAN_COSINE_FACING .01

/* The error of the cosine by that of 1/|w|, in e_w: 1/|w| is off by 1 - sqrt(1 - e_w) at most, .5051 e_w where e_w is
 * below .04, of the cosine as computed, which is at most 1.01: .511 of .53. */
#define BOUND_SPAN_COSINE_SQUARE .53

/* The roundings of the cosine there: the shift of r N.w (2^-30), the inverse root (2^-30) and its product (2^-30), 1/r
 * (2^-31) and the cosine (2^-31). Proved: simd_integer.g (cosine), 4 of 16. */
#define BOUND_SPAN_COSINE_UNITS 0x1p-26

/* e_c, the error of the cosine: that of r N.w over r |w|, that of 1/|w|, and the roundings by the kernels and there. */
FORMULA(SPAN_COSINE);

/* The largest e_w with which a cosine is bounded: SPAN_COSINE_SQUARE is derived for it. Unseen: choice. */
#define BOUND_SPAN_SQUARE_KNOWN .04

/* The largest e_c with which a run is drawn, so that e_w is below .019: SPAN_CELL_FAR and the verdicts of shadows are
 * derived for it. Unseen: choice. */
#define BOUND_SPAN_COSINE_KNOWN .01

/* ---- colours and levels ---- */

/* The rounding of a light's part of a colour: lambert times tint and colour, and the sum; as much for each caster.
 * Proved: simd_forms.g (colour, colour_sum, caster), 4 of 6 u. */
#define BOUND_SPAN_COLOUR SIMD_COLOUR

/* The rounding of a light's part of a colour there: the product of two colours and its product with lambert, half of
 * 2^-30 each; as much for each caster. 1 of 1. */
#define BOUND_SPAN_COLOUR_UNITS 0x1p-30

/* The rounding of two lines between three samples, of 1.01. Proved: simd_forms.g (line), 11 of 15 u. */
#define BOUND_SPAN_LINE SIMD_LINE

/* The error of a light's part of a colour: the light's colour times the bounds of the cosine and of lines, and
 * SPAN_COLOUR and SPAN_COLOUR_UNITS. Minima, maxima and clamps only bring values nearer. */
FORMULA(SPAN_COLOURS);

/* The error of the levels of a colour, 31 or 63 of them: as many times the colour's error, and SPAN_LEVEL_ROUNDING. */
FORMULA(SPAN_LEVELS);

/* The rounding of a level, of 63 or 64 at most: the emission as a float, the product with the levels and the sum with
 * the threshold: 3 of 6 u. */
#define BOUND_SPAN_LEVEL_ROUNDING 6

/* The rounding of the bound itself: it is computed in doubles, and cells subtract theirs in floats, 3 u of .5 at most:
 * 2^-22 of .01. Unseen: small. */
#define BOUND_SPAN_LEVEL_SECOND .01

/* The rounding of the comparison with half a level: the threshold less 1/2, the bound and the distance from a level as
 * floats, each of 1/2 at most: 2 of 6 u. Unseen: small. */
#define BOUND_SPAN_LEVEL_NEAR 6

/* The least value of half a level less its bounds. A choice: with less nearly all of a run would be undecided. Unseen:
 * choice. */
#define BOUND_SPAN_LEVEL_LEAST .1

/* The share by which the limits of cached bounds are worse than those of their run. A choice: for a single run 0 is as
 * good. Unseen: choice. */
#define BOUND_SPAN_KEPT .1

#endif
