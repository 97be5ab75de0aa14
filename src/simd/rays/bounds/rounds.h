/* rounds.h - bounds of cones and cylinders: round_tmpl.h, cylinder_tmpl.h. */
#ifndef TIA_SIMD_RAYS_BOUNDS_ROUNDS_H
#define TIA_SIMD_RAYS_BOUNDS_ROUNDS_H

/* ---- cones, see round_tmpl.h and geometry/round.c ---- */

/* start = -(O - A).D: |O - A|1. As SPHERE_ALONG, proved: rays_forms.g (tca), 5 of 8 u. Unseen: small. */
#define BOUND_CONE_START_ROUNDING (8 * SURE_EPS)

/* It moves by eo and, D turning, by |O - A| ed. */
FORMULA(CONE_START);

/* O - A + start D: |O - A|1. As SPHERE_ASIDE, proved: rays_forms.g (aside + along). Unseen: small. */
#define BOUND_CONE_NEAR_ROUNDING (16 * SURE_EPS)

/* It moves by eo, by |start| ed across and |O - A| ed along. */
FORMULA(CONE_NEAR);

/* CONE_START and CONE_NEAR there: half a unit of start, and with the point's three halves 1.37 of 2. Unseen: small. */
#define BOUND_CONE_NEAR_UNITS (2 * SURE_UNIT)

/* CONE_NEAR_ROUNDING, as the ray passes the shape: 16 u. Unseen: small. */
#define BOUND_CONE_PASS_ROUNDING P2M(49)

/* The distance of the rays anywhere near the shape. */
FORMULA(CONE_PASS);

/* Squares of 2 to 6 roundings, 6 u; and the bound's own. 2^-10 of it. Unseen: small. */
#define BOUND_CONE_SQUARE P2M(40)

/* A line passes a fixed-point cone where |P x Q| > (widest + 2^-13) |Q| + 2^-32 there, see passes_by(). The radius is
 * rounded to a double by 2^-38. 1 of 2. Unseen: small. */
#define BOUND_CONE_THICKNESS P2M(12)

/* 2^-32 of that comparison, and 4 units: P by half of one, both products by another, |Q| by 2^-62 of a thickness below
 * 2^17. 1 of 2. Unseen: small. */
#define BOUND_CONE_PASSED P2M(31)

/* P x Q moves by CONE_PASS across, and Q by ed, so by reach ed at a point that near: as much again; and so does
 * thickness |Q|. Unseen: small. */
FORMULA(CONE_BESIDE);

/* (near.a0) y1 - (near.a1) y0: near 16 u, its dot products and y 5 u each, products and difference 2 u: 28 of 32 u of
 * |O - A|1, which near is no longer than. Unseen: small. */
#define BOUND_CONE_ASIDE P2M(48)

/* D along an axis: 4 u of its roundings, and half of v. The rest keeps `flat` above 2^-39, where normalising it there
 * loses nothing: v is 2^-23 of that. 4 of 512 u. Unseen: small. */
#define BOUND_CONE_DIRECTION P2M(44)

/* D along an axis: ed and CONE_DIRECTION. */
FORMULA(CONE_TURN);

/* near along an axis by doubles: the axis, a product and two sums, 4 of 8 u of |near|1. Unseen: small. */
#define BOUND_CONE_PLACE_ROUNDING (8 * SURE_EPS)

/* near along an axis: CONE_NEAR and CONE_PLACE_ROUNDING; there half a unit. */
FORMULA(CONE_PLACE);

/* A vector of two components that is known within 1/32 of its length. v/|v| is then off by (1 + 2^-10) e/|v|, proved:
 * rays_forms.g (turned); the rest of the factor is for the bound's own roundings. Unseen: small. */
#define BOUND_CONE_CHORD 1.0625
#define BOUND_CONE_KNOWN 32 /* chosen together with CONE_CHORD. Unseen: choice. */

/* v/|v| by doubles, 5 u, and 2^-58 there: 5 of 32 u. Unseen: small. */
#define BOUND_CONE_UNIT P2M(48)

/* |v| by doubles, two products, a sum and a root: 2.5 of 512 u. There v.(v/|v|): two halves of v and 2^-58. Unseen:
 * small. */
#define BOUND_CONE_LENGTH P2M(44)

/* t there: the sum is exact, the quotient's half unit is the interval's. 2 units of it are not needed: start's half is
 * CONE_START's. 0 of 2. Unseen: small. */
#define BOUND_CONE_UNITS (2 * SURE_UNIT)

/* O + t D: eo, the error of t, and t ed. */
FORMULA(CONE_POINT);

/* ---- cylinders, see cylinder_tmpl.h, which derives all of it ---- */

/* A ray in the axes. Proved: rays_forms.g (tube, tubed): 16 u of |O|1, and of 1. Unseen: small. */
#define BOUND_TUBE (SURE_TUBE * SURE_EPS)

/* Errors within 2^-55 of the reach: fixed-point lengths of v/2 and quotients of 2^-59, 2^-57 and less; and what t adds
 * to lambda where the farther end counts. 8 u. Unseen: small. */
#define BOUND_TUBE_REACH (8 * SURE_EPS)

/* There: 2.6 units of the origin, 1 of the nearest place and 1.5 of the root: 5.1, of 5.25. */
#define BOUND_TUBE_UNITS (5.25 * SURE_UNIT)

/* lambda(t) = off + |t| turn: eo, and the roundings that do not grow with t. */
FORMULA(TUBE_OFF);

/* lambda's growth with t: ed, and 16 u. */
FORMULA(TUBE_TURN);

/* (r + lambda)^2 - r^2. */
FORMULA(TUBE_ETA);

/* The bound's own roundings, a few u. 2^-29 of it. */
#define BOUND_TUBE_BOUND (1 + P2M(20))

/* The roundings of g, by which g^2 may be smaller. */
#define BOUND_TUBE_LEAST (1 - P2M(40))

/* f'^2 <= (f + ed)^2 = f^2 + ed (2 f + ed) <= f^2 + 3 ed. Unseen: small. */
#define BOUND_TUBE_SQUARE 3

/* Below this f^2 is no divisor: it would be infinite along the axis, and every lane is undecided then. A choice.
 * Unseen: choice. */
#define BOUND_TUBE_SLANTED P2M(60)

/* (D x A).(O - B) and |D x A|: 32 u of the way to the shape, and pad is 2^-21 of it or more: 2^-27 of pad. 1 of 8.
 * Unseen: small. */
#define BOUND_TUBE_ASIDE P2M(24)

/* Heights there: the point 1 unit, its product half of one, the end's half: 2 of 3. Unseen: small. */
#define BOUND_TUBE_HEIGHT_UNITS (3 * SURE_UNIT)

/* A distance there, besides the errors so far: the quotient's and the sum's halves. 1 of 2. Unseen: small. */
#define BOUND_TUBE_DISTANCE_UNITS (2 * SURE_UNIT)

/* The error along the ray of the point nearest to the shape. */
FORMULA(TUBE_START);

/* Possible hits lie at heights up to this far beyond the shape's ends. */
FORMULA(TUBE_MARGIN);

/* lambda (r + lambda)/T, see cylinder_tmpl.h. */
FORMULA(TUBE_DISTANCE);

/* The errors of heights at an end. */
FORMULA(TUBE_END);

/* A plane across the axis: lambda/(|d| - ed). */
FORMULA(TUBE_CAP);

/* r + lambda over T = sqrt(g^2 - f'^2 eta). */
FORMULA(TUBE_STRETCH);

/* The point is off by no more than t, see cylinder_tmpl.h. */
FORMULA(TUBE_POINT);

/* The distance from the axis below which a ray must come: the radius, and the distance of the rays. */
FORMULA(TUBE_WIDEST);

#endif
