/* cells.h - bounds for values between a cell's samples, which cells_tmpl.h and prepare.c use. */
#ifndef TIA_SIMD_SPAN_BOUNDS_CELLS_H
#define TIA_SIMD_SPAN_BOUNDS_CELLS_H

/* ---- samples ---- */

/* The relative error of each of the two terms of S' = b1 + D'/(2 sqrt(D)), which may cancel. D is at least
 * SPAN_FLOAT_CUT, 2^-11, of its size. Proved: simd_cells.g (part, first), .7 of 1. */
#define BOUND_SPAN_CELL_TURN (1. / (1 << CELL_TURN))

/* The rounding of D'/2 = (2 d2 x + d1)/2, relative to |d1| + 2 |d2| X. x may lie outside of the run. Proved:
 * simd_cells.g (slope), 1.7 of 2 u. */
#define BOUND_SPAN_CELL_SLOPE CELL_SLOPE

/* The error of |S'|: SPAN_CELL_TURN of each of the two terms of S', and the bound of D'/2 over sqrt(D). */
FORMULA(SPAN_CELL_TURN_OFF);

/* The relative error of |w|, computed as |w| s times c/S: that of |w|^2 is below .019, that of 1/S below .01. Proved:
 * simd_cells.g (nearest, farthest), 20 of 30. Unseen: small. */
#define BOUND_SPAN_CELL_FAR (CELL_FAR * .001f)

/* ---- motion ---- */

/* The amount by which D between two samples may be below the smaller of the two samples' D: at most d2 8^2 where d2 >
 * 0, since D is convex then. In fact 0 is needed. The directions with b > 0 and D > 0 form a convex cone, so D > 0
 * between two pixels that see the sphere. If D had its minimum between them, D would be positive in the whole plane of
 * the row, even in its directions perpendicular to L, where D = -c v.v < 0. Unseen: choice. */
FORMULA(SPAN_CELL_SAG);

/* The rounding of D at samples, relative to D's size: SPAN_QUADRATIC, 8 of 16 u. */
#define BOUND_SPAN_CELL_SAG_ROUNDING 0x1p-20

/* The relative error of S'' = -bend/D^1.5: three factors 1/sqrt(D), which is computed from an estimate. Proved:
 * simd_cells.g (bend), 1 of 1. Unseen: hidden. */
#define BOUND_SPAN_CELL_CURVE .01

/* The relative roundings of the largest |v'| and |v| as floats, 2 u, and of 1/S and the products with it. .0001 of
 * .001. Unseen: hidden. */
#define BOUND_SPAN_CELL_WIDER .001

/* The relative error of |P'| and |P''| that the error of 1/S causes. They contain 1/S up to the third power, and each
 * factor is off by e_s: 3 of 4. Unseen: hidden. */
FORMULA(SPAN_CELL_WIDER_S);

/* The factor for the roundings of |P'| and |P''|: 1/S up to three times, and products. Proved: simd_cells.g (motion), 1
 * of 1. */
#define BOUND_SPAN_CELL_MOTION (CELL_MOTION * .001f)

/* An upper limit of |P'| over a cell. With P = t v, t = c/S and a = |S'|/S, |t'| = t a and |P'| <= t (|v'| + |v| a).
 * 1/S and |S'| are largest at an end of the cell, since S is concave: in every plane through the eye, the visible half
 * of a sphere bounds a convex set, which stays convex when the plane is mapped to (x, 1/t). */
FORMULA(SPAN_CELL_FIRST);

/* An upper limit of |P''| over a cell. With a as in SPAN_CELL_FIRST and b = |S''|/S, |t''| <= t (2 a^2 + b) and |P''|
 * <= t (|v| (2 a^2 + b) + 2 |v'| a). |S''| = bend/D^1.5 is largest where D is least. */
FORMULA(SPAN_CELL_SECOND);

/* ---- a line between samples ---- */

/* The largest error of a line between two samples that are 8 pixels apart: 8^2/8 times the second derivative of the
 * cosine N.w/|w|. With N' = P'/r, w' = -P' and d for the least |w|, that derivative is at most |P''| (1/r + 1/d) +
 * |P'|^2 (2/(r d) + 1.16/d^2). The second derivative of the unit vector w/|w| is at most |w''|/d + 1.155 |w'|^2/d^2,
 * where 1.155 is the largest a sqrt(4 - 3 a^2) and a the share of w' perpendicular to w. */
FORMULA(SPAN_CELL_LINE);

/* The largest a sqrt(4 - 3 a^2), where a is the share of w' perpendicular to w, 0 to 1. Proved: simd_cells.g (over),
 * 1.155 of 1.16. */
#define BOUND_SPAN_CELL_BEND (CELL_BEND * .001f)

/* The factor for the roundings of a line's error: 1/|w| twice, and products. Proved: simd_cells.g (off), 1 of 1. */
#define BOUND_SPAN_CELL_OFF (CELL_OFF * .001f)

/* A cell is interpolated only where d, the light's distance less the path of half a cell, exceeds this share of that
 * path. 0 is needed, so that d is positive. Unseen: choice. */
#define BOUND_SPAN_CELL_NEAR .01

/* The largest error of a cell's interpolation, in 63rds of white. A choice: above it drawing pixels one by one is
 * faster. Unseen: choice. */
#define BOUND_SPAN_CELL_FAINT .12

/* The same for all lights of a run that is drawn light by light, whose undecided pixels are computed in doubles at
 * once. A choice. Unseen: choice. */
#define BOUND_SPAN_TOTAL_FAINT .01

/* The error that the interpolation of one light adds to a colour: the line's error times the largest component of the
 * light's colour. SPAN_COLOUR_SUM has the rounding of the sum over lights. */
FORMULA(SPAN_CELL_LOST);

/* ---- shadows between samples ---- */

/* The relative roundings of R, |C - Q| + bias, bias/r and |A'| as floats: 2 of 2^14 u. Unseen: small. */
#define BOUND_SPAN_EDGE_SIZES .001

/* The largest bias in |A'| <= |C| + |P| + bias: 2^-13 of 1. Unseen: small. */
#define BOUND_SPAN_EDGE_BIAS 1

/* The part of A'.w in the bound of h^2 = |A'|^2 - (A'.w)^2/|w|^2: the bound of A'.w times 2 |A'.w|/|w|^2, which is at
 * most 2 |A'|/|w|. The division by |w| is the kernel's. Unseen: small. */
FORMULA(SPAN_EDGE_A);

/* The second-order error in SPAN_EDGE_A: (e/(|A'| |w|))^2 as a share of 2 e/(|A'| |w|), where e is the bound of A'.w.
 * Unseen: small. */
#define BOUND_SPAN_EDGE_A_SECOND .01

/* The parts of k and |w|^2 in the bound of h^2: the bound of k, and |A'|^2 times the relative bound of |w|^2. Unseen:
 * small. */
FORMULA(SPAN_EDGE_K);

/* The second-order error in SPAN_EDGE_K. e_w may enlarge (A'.w)^2/|w|^2 by the factor 1/(1 - e_w), below 1.02: .01 of
 * that is here, and the rest is in the spare parts of e_w that SPAN_VERDICT_A counts. Unseen: small. */
#define BOUND_SPAN_EDGE_K_SECOND .01

/* m, the largest change of h, the distance of the shadow ray from C, as P moves by p: p (|C - Q| + bias)/d, as the ray
 * turns around Q, plus p bias/r, as N, the direction of the bias, turns by p/r. */
FORMULA(SPAN_EDGE_MOVE);

/* The limit of |h^2 - R^2| at a sample above which no shadow's edge crosses the half cell. Let e be the bound of h^2. h
 * stays above R where h^2 - R^2 > 2 R m + 2 m^2 + 2 e, since (sqrt(R^2 + e) + m)^2 <= R^2 + e + m^2 + 2 R m + 2 m
 * sqrt(e) and 2 m sqrt(e) <= m^2 + e. h stays below R where h^2 - R^2 is below minus this sum. As h^2 is off by e at
 * the sample, too, the limit has 3 e. */
FORMULA(SPAN_EDGE);

/* The largest change of A'.w - |w|^2 as P moves by p: A'.w changes by up to p (|A'| + |w|), |w|^2 by up to p (2 |w| +
 * p); the sum of both. */
FORMULA(SPAN_EDGE_ASIDE);

/* An upper limit of |w|^2 over the cell, which makes the relative bound of |w|^2 an absolute one. Unseen: small. */
FORMULA(SPAN_EDGE_FAR);

/* The factor for the roundings of the margins around a shadow's edge: sums of non-negative terms, 1/|w| once, and the
 * computed s^2 and |w|^2. Proved: simd_cells.g (clear), 1.04 of 1.2. */
#define BOUND_SPAN_EDGE_UNIT (CELL_UNIT * .001f)

#endif
