/* levels.h - bounds for lights, colours and levels, which bounds.c and bound_cache.c use. */
#ifndef TIA_SIMD_SPAN_BOUNDS_LEVELS_H
#define TIA_SIMD_SPAN_BOUNDS_LEVELS_H

/* ---- |w|^2 = |Q - P|^2 ---- */

/* The rounding of ||G| - r|, the light's distance from the sphere, as a share of |G| + r: 5 roundings of a double for a
 * length, and one for the difference. 6 of 32. Unseen: small. */
#define BOUND_SPAN_GAP 0x1p-48

/* The relative rounding of the lower limit of |w|, the largest of ||G| - r|, |P| - |Q| and |Q| - |P|. The range of |P|
 * includes SPAN_RANGE already: a few of 2^23 roundings of a double. Unseen: small. */
#define BOUND_SPAN_DISTANCE 0x1p-30

/* The rounding of each term of a s^2 + h s + v.v, relative to the term's size, without the error of s. Proved:
 * simd_forms.g (term2, term1, term0), 7 of 8 u. */
#define BOUND_SPAN_TERM SIMD_TERM

/* The kernels' error in a quadratic a s^2 + h s + v.v, divided by s^2: 2 e_s of the first term, e_s of the second, and
 * SPAN_TERM of each term. */
FORMULA(SPAN_FORM);

/* The second-order error in SPAN_FORM: e_s^2 against 2 e_s, where e_s is below .01. .005 of .01. Unseen: small. */
#define BOUND_SPAN_FORM_SECOND .01

/* The second-order change of a form by the error of P. The first-order change is at most that error times the
 * derivative of the form, which for |w|^2 is at most 2 |Q| + 2 |P|. The second-order change is at most e_t/2 of the
 * first: .005 of .02. Unseen: small. */
#define BOUND_SPAN_MOVED .02

/* e_w, the relative error of |w|^2: the kernels' error, and the change by the error of P, e_t |P|, over the least
 * |w|^2. */
FORMULA(SPAN_SQUARE);

/* ---- the cosine r N.w/(r |w|) ---- */

/* The relative rounding of K s in K s + G.v. Proved: simd_forms.g (facing), 3 of 6 u. */
#define BOUND_SPAN_FACING SIMD_FACING

/* The rounding of G.v in K s + G.v, relative to |g0| + |g1| X. Proved: simd_forms.g (turn), 5 of 7 u. */
#define BOUND_SPAN_TURN SIMD_TURN

/* The rounding of (P - L).G - r^2, by whose sign a light is away from all points P of a ball: SPAN_PARTS of its terms.
 * Unseen: small. */
FORMULA(SPAN_AWAY);

/* The second-order error of K s in e_s. There is none, as K s is linear in s: 0 of .01. Unseen: small. */
#define BOUND_SPAN_FACING_SECOND .01

/* The error of r N.w = K + G.P: the kernels' error, and |G| times the error of P. */
FORMULA(SPAN_FACING_OFF);

/* The rounding of r N.w/(r |w|): 1/r, 1/sqrt and two products. Proved: simd_forms.g (lambert), 15 of 24 u. */
#define BOUND_SPAN_LAMBERT SIMD_LAMBERT

/* The second-order error in r N.w's error over r |w|. There is none, as |w| is exact here and SPAN_COSINE_SQUARE has
 * the error of 1/|w|: 0 of .01. Unseen: small. */
#define BOUND_SPAN_COSINE_FACING .01

/* The error of the cosine that the error of 1/|w| causes, in units of e_w. 1/|w| is off by at most 1 - sqrt(1 - e_w) of
 * its computed value, or .5051 e_w where e_w is below .04. The computed cosine is at most 1.01: .511 of .53. */
#define BOUND_SPAN_COSINE_SQUARE .53

/* e_c, the error of the cosine: the error of r N.w over r |w|, the error of 1/|w|, and SPAN_LAMBERT. */
FORMULA(SPAN_COSINE);

/* The limit of e_w below which a cosine is bounded, as SPAN_COSINE_SQUARE assumes. Unseen: choice. */
#define BOUND_SPAN_SQUARE_KNOWN .04

/* The limit of e_c below which a run is drawn. Then e_w is below .019, as SPAN_CELL_FAR and the bounds of shadow
 * verdicts assume. Unseen: choice. */
#define BOUND_SPAN_COSINE_KNOWN .01

/* ---- colours and levels ---- */

/* The rounding of a light's contribution to a colour, relative to the light's colour: the colour, and lambert times
 * tint and colour. Each caster adds as much. Proved: simd_forms.g (colour, colour_sum, caster), 3 of 6 u. */
#define BOUND_SPAN_COLOUR SIMD_COLOUR

/* The rounding of a sum of colours with a light's contribution: the sum is at most 1 before and after, and a float in
 * between; and that of the sum of lines' errors, which is at most 1/63 of SPAN_CELL_FAINT. 1.002 of 1.1 u. */
#define BOUND_SPAN_COLOUR_SUM 1.1

/* The rounding of a cosine interpolated by two lines between three samples, which are at most 1.01. Proved:
 * simd_forms.g (line), 11 of 15 u. */
#define BOUND_SPAN_LINE SIMD_LINE

/* The error of a light's contribution to a colour: the light's colour times the bounds of the cosine and of the
 * interpolation and SPAN_COLOUR, plus SPAN_COLOUR_SUM. Minima, maxima and clamps never enlarge an error. */
FORMULA(SPAN_COLOURS);

/* The error of a channel in levels, for 31 or 63 levels: the colour's error times their number, plus
 * SPAN_LEVEL_ROUNDING. */
FORMULA(SPAN_LEVELS);

/* The rounding of a channel in levels, as a share of their number: the emission as a float, the product with the number
 * of levels, and the sum with the threshold, at most 64. 3 of 6 u. */
#define BOUND_SPAN_LEVEL_ROUNDING 6

/* The rounding of the bound itself. It is computed in doubles, and cells subtract their interpolation error in floats,
 * with 3 u of at most .5. The bound is at least 31 times 6 u: .008 of .01. Unseen: small. */
#define BOUND_SPAN_LEVEL_SECOND .01

/* The rounding of the comparison of a channel's distance from a level with the bound: the threshold less 1/2, the bound
 * and the distance are floats of at most 1/2. 2 of 6 u. Unseen: small. */
#define BOUND_SPAN_LEVEL_NEAR 6

/* The limit of half a level less its bounds above which a run is drawn. A choice: below it nearly all pixels of the run
 * would be undecided. Unseen: choice. */
#define BOUND_SPAN_LEVEL_LEAST .1

/* The share by which the limits of cached bounds exceed those of their run. A choice: for a single run 0 is as good.
 * Unseen: choice. */
#define BOUND_SPAN_KEPT .1

#endif
