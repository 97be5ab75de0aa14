/* cells.h - bounds of what lies between a cell's samples: cells_tmpl.h, prepare.c. */
#ifndef TIA_SIMD_SPAN_BOUNDS_CELLS_H
#define TIA_SIMD_SPAN_BOUNDS_CELLS_H

/* ---- samples ---- */

/* The error of S' = b1 + D'/(2 sqrt(D)), of each of its two parts, which may cancel. D is at least 2^-8 of its size,
 * SPAN_FLOAT_CUT. Proved: simd_cells.g (part, first), .7 of 1. */
#define BOUND_SPAN_CELL_TURN (1. / (1 << CELL_TURN))

/* The rounding of D'/2 = (2 d2 x + d1)/2, where x may be a pixel outside of the run. Proved: simd_cells.g (slope), 1.7
 * of 2 u. */
#define BOUND_SPAN_CELL_SLOPE CELL_SLOPE

/* The amount by which |S'| may exceed the computed one: the bounds of its two parts, b1 and D'/(2 sqrt(D)), and that of
 * D' over sqrt(D). */
FORMULA(SPAN_CELL_TURN_OFF);

/* The relative error of |w|, computed as |w| s/S c: |w|^2 is within .019, 1/S within .01. Proved: simd_cells.g
 * (nearest, farthest), 20 of 30. Unseen: small. */
#define BOUND_SPAN_CELL_FAR (CELL_FAR * .001f)

/* ---- motion ---- */

/* The amount by which D may sag between two samples below the smaller of theirs: d2 8^2 at most where d2 > 0, as D is
 * convex then. 0 of this value: b > 0 and D > 0 make a convex cone, so that D > 0 between two pixels that see the
 * sphere. Nor is the minimum of D there: otherwise all of a plane through the eye would see the sphere, even in the
 * directions across L. Unseen: choice. */
FORMULA(SPAN_CELL_SAG);

/* The rounding of D at samples, of its size: SPAN_QUADRATIC, 8 of 16 u. */
#define BOUND_SPAN_CELL_SAG_ROUNDING 0x1p-20

/* The relative error of S'' = -bend/D^1.5: sqrt(D) by an estimate, three times. Proved: simd_cells.g (bend), 1 of 1.
 * Unseen: hidden. */
#define BOUND_SPAN_CELL_CURVE .01

/* The relative errors of the largest v' and |v| as floats, 2 u, and of 1/S and the products with them. .0001 of .001.
 * Unseen: hidden. */
#define BOUND_SPAN_CELL_WIDER .001

/* The relative error of |P'| and |P''| by that of 1/S: they have up to the fourth power of 1/S, each off by e_s.
 * Unseen: hidden. */
FORMULA(SPAN_CELL_WIDER_S);

/* The factor for the roundings of |P'| and |P''|: 1/S up to three times, and products. Proved: simd_cells.g (motion), 1
 * of 1. */
#define BOUND_SPAN_CELL_MOTION (CELL_MOTION * .001f)

/* The largest |P'| over a cell: P = t v and t = c/S, so with a = |S'|/S, |t'| = t a and |P'| <= t (|v'| + |v| a). S is
 * concave, since the half of a sphere that is seen bounds a convex set in every plane through the eye, and stays so
 * when the plane is mapped to (x, 1/t): so 1/S and |S'| are largest at an end of the cell. */
FORMULA(SPAN_CELL_FIRST);

/* The largest |P''| over a cell: with b = |S''|/S, |t''| <= t (2 a^2 + b), and |P''| <= t (|v| (2 a^2 + b) + 2 |v'| a).
 * S'' = -bend/D^1.5 is largest where D is least. */
FORMULA(SPAN_CELL_SECOND);

/* ---- a line between samples ---- */

/* The largest error of a line between two samples that are 8 pixels apart: 8^2/8 of the second derivative of the cosine
 * N.w/|w|. With N' = P'/r and w' = -P', (N.w/|w|)'' is at most |P''| (1/r + 1/d) + |P'|^2 (2/(r d) + 1.16/d^2): the
 * unit vector w/|w| has a second derivative of at most |w''|/d and |w'|^2/d^2 times max a sqrt(4 - 3 a^2) = 1.155, a
 * being the share of w' across w. */
FORMULA(SPAN_CELL_LINE);

/* The largest a sqrt(4 - 3 a^2), a being the share of w' across w. Proved: simd_cells.g (over), 1.155 of 1.16. */
#define BOUND_SPAN_CELL_BEND (CELL_BEND * .001f)

/* The factor for the roundings of a line's error: 1/|w| twice, and products. Proved: simd_cells.g (off), 1 of 1. */
#define BOUND_SPAN_CELL_OFF (CELL_OFF * .001f)

/* The least d, the light's distance less half a cell's path, as a share of that half: 0 is needed, so that d is
 * positive. Unseen: choice. */
#define BOUND_SPAN_CELL_NEAR .01

/* The largest share of a level that a line may cost. A choice: above it single pixels are faster. Unseen: choice. */
#define BOUND_SPAN_CELL_FAINT .12

/* The largest error that a light's line adds to a colour: the line's, times the light's largest colour component. */
FORMULA(SPAN_CELL_LOST);

/* ---- shadows between samples ---- */

/* The roundings of R, |C - Q| + bias, bias/r and |A'| as floats: 2 u of 2^14. Unseen: small. */
#define BOUND_SPAN_EDGE_SIZES .001

/* The largest bias in |A'| <= |C| + |P| + bias: 2^-13 of 1. Unseen: small. */
#define BOUND_SPAN_EDGE_BIAS 1

/* The part of A'.w in the bound of h^2 = |A'|^2 - (A'.w)^2/|w|^2, times |w|, as the kernel divides it by |w|: the bound
 * of A'.w times 2 |A'.w|/|w|, |A'.w| <= |A'| |w|. Unseen: small. */
FORMULA(SPAN_EDGE_A);

/* The second order of SPAN_EDGE_A: (e/(|A'| |w|))^2, e being the bound of A'.w, as a share of twice e/(|A'| |w|).
 * Unseen: small. */
#define BOUND_SPAN_EDGE_A_SECOND .01

/* The parts of k and |w|^2 in the bound of h^2: the bound of k, and |A'|^2 times the relative one of |w|^2. Unseen:
 * small. */
FORMULA(SPAN_EDGE_K);

/* The second order of SPAN_EDGE_K: e_w makes (A'.w)^2/|w|^2 larger by 1/(1 - e_w), below 1.02: .01 of that is here, the
 * rest in what each part of e_w has to spare, as SPAN_VERDICT_A counts. Unseen: small. */
#define BOUND_SPAN_EDGE_K_SECOND .01

/* m, the largest change of the shadow ray's distance h from C as P moves by p: p (|C - Q| + bias)/d, as the ray turns
 * around Q, and p bias/r, as N, along which the bias points, turns by p/r. */
FORMULA(SPAN_EDGE_MOVE);

/* The least |h^2 - R^2| at the sample with which no edge crosses the half cell: h stays above R when h^2 - R^2 > 2 R m
 * + 2 m^2 + 2 e, e being h^2's bound, as (sqrt(R^2 + e) + m)^2 <= R^2 + e + m^2 + 2 R m + 2 m sqrt(e); h stays below R
 * when h^2 - R^2 is below the same, negated. At the sample h^2 is off by e as well: 3 e. */
FORMULA(SPAN_EDGE);

/* The largest change of A'.w - |w|^2 as P moves by p: A'.w changes by up to p (|A'| + |w|), |w|^2 by up to p (2 |w| +
 * p); the sum of both. */
FORMULA(SPAN_EDGE_ASIDE);

/* The largest |w|^2 of the cell, by which the relative bound of |w|^2 is multiplied. Unseen: small. */
FORMULA(SPAN_EDGE_FAR);

/* The factor for the roundings of the distances from a shadow's edge: sums of what is not negative, 1/|w| once, and s^2
 * and |w|^2 as computed. Proved: simd_cells.g (clear), 1.04 of 1.2. */
#define BOUND_SPAN_EDGE_UNIT (CELL_UNIT * .001f)

#endif
