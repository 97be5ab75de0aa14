/* rounds.h - bounds of cones and cylinders: round_tmpl.h, cylinder_tmpl.h. */
#ifndef TIA_SIMD_RAYS_BOUNDS_ROUNDS_H
#define TIA_SIMD_RAYS_BOUNDS_ROUNDS_H

/* ---- cones, see round_tmpl.h and geometry/round.c ---- */

/* The rounding of start = -(O - A).D, of |O - A|1. Proved, like SPHERE_ALONG: rays_forms.g (tca), 5 of 8 u. Unseen:
 * small. */
#define BOUND_CONE_START_ROUNDING (8 * SURE_EPS)

/* The error of start: eo, |O - A| ed as D turns, CONE_START_ROUNDING, and half a unit there. */
FORMULA(CONE_START);

/* The rounding of near = O - A + start D, of |O - A|1. Proved, like SPHERE_ASIDE: rays_forms.g (aside + along). Unseen:
 * small. */
#define BOUND_CONE_NEAR_ROUNDING (16 * SURE_EPS)

/* The error of near: eo, |start| ed across the ray and |O - A| ed along it, CONE_NEAR_ROUNDING and CONE_NEAR_UNITS. */
FORMULA(CONE_NEAR);

/* The rounding of near there: half a unit of start, and half a unit in each of the point's three coordinates: 1.37 of
 * 2. Unseen: small. */
#define BOUND_CONE_NEAR_UNITS (2 * SURE_UNIT)

/* The rounding of the place where the ray passes the shape, of |O - A|1: CONE_NEAR_ROUNDING, 16 u. Unseen: small. */
#define BOUND_CONE_PASS_ROUNDING P2M(49)

/* The largest distance between the certified ray and the fixed-point ray, anywhere near the shape: eo, (|start| +
 * reach) ed, and CONE_PASS_ROUNDING. */
FORMULA(CONE_PASS);

/* The squares that are compared, each with 2 to 6 roundings: 6 u; and the bound's own roundings. Less than 2^-10 of the
 * value. Unseen: small. */
#define BOUND_CONE_SQUARE P2M(40)

/* The length that is added to the larger radius. A line passes a fixed-point cone where |P x Q| > (widest + 2^-13) |Q|
 * + 2^-32 there, see passes_by(); and the radius is rounded to a double by 2^-38. 1 of 2. Unseen: small. */
#define BOUND_CONE_THICKNESS P2M(12)

/* The constant of the comparison in CONE_THICKNESS, 2^-32, and the roundings of both sides there, 4 units: P by half of
 * one, both products by another, |Q| by 2^-62 of a thickness below 2^17. 1 of 2. Unseen: small. */
#define BOUND_CONE_PASSED P2M(31)

/* The error of |P x Q| against thickness |Q|: P x Q moves by CONE_PASS across the ray; by as much again, since Q moves
 * by ed, which is reach ed at a point that near; and thickness |Q| by as much. And CONE_PASSED. Unseen: small. */
FORMULA(CONE_BESIDE);

/* The rounding of P x Q = (near.a0) y1 - (near.a1) y0, of |O - A|1, which near is no longer than: near 16 u, its dot
 * products and y 5 u each, the products and the difference 2 u: 28 of 32 u. Unseen: small. */
#define BOUND_CONE_ASIDE P2M(48)

/* The rounding of D along an axis. By doubles: 4 u; there: half of v. The rest keeps `flat` above 2^-39, where
 * normalising it there loses nothing: v is 2^-23 of that. 4 of 512 u. Unseen: small. */
#define BOUND_CONE_DIRECTION P2M(44)

/* The error of D along an axis: ed and CONE_DIRECTION. */
FORMULA(CONE_TURN);

/* The rounding of near along an axis by doubles, of |near|1: the axis, a product and two sums, 4 of 8 u. Unseen: small.
 */
#define BOUND_CONE_PLACE_ROUNDING (8 * SURE_EPS)

/* The error of near along an axis: that of near, CONE_PLACE_ROUNDING, and half a unit there. */
FORMULA(CONE_PLACE);

/* The largest error of v/|v| in e/|v|, where v is a vector of two components that is known within e, and e is below
 * 1/32 of its length: 1 + 2^-10. Proved: rays_forms.g (turned); the rest of the factor is for the bound's own
 * roundings. Unseen: small. */
#define BOUND_CONE_CHORD 1.0625

/* The number of times that a vector's length must exceed its error, so that CONE_CHORD holds. Chosen together with
 * CONE_CHORD. Unseen: choice. */
#define BOUND_CONE_KNOWN 32

/* The rounding of v/|v|. By doubles: 5 u; there: 2^-58. 5 of 32 u. Unseen: small. */
#define BOUND_CONE_UNIT P2M(48)

/* The rounding of |v|. By doubles: two products, a sum and a root, 2.5 of 512 u; there |v| is v.(v/|v|): two halves of
 * v and 2^-58. Unseen: small. */
#define BOUND_CONE_LENGTH P2M(44)

/* The rounding of t there, which needs no units of its own: the sum is exact, the quotient's half unit is the
 * interval's, and the half unit of start is in CONE_START. 0 of 2. Unseen: small. */
#define BOUND_CONE_UNITS (2 * SURE_UNIT)

/* The error of the point O + t D: eo, the error of t, t ed, and POINT_UNITS. */
FORMULA(CONE_POINT);

/* ---- cylinders, see cylinder_tmpl.h, which derives all of it ---- */

/* The rounding of a ray in the cylinder's axes: of its origin, 16 u of |O|1, and of its direction, 16 u of 1. Proved:
 * rays_forms.g (tube, tubed). Unseen: small. */
#define BOUND_TUBE (SURE_TUBE * SURE_EPS)

/* The other roundings in lambda, within 2^-55 of the reach: fixed-point lengths of v/2 and quotients of 2^-59, 2^-57
 * and less; and what t adds to lambda where the farther end counts. 8 u. Unseen: small. */
#define BOUND_TUBE_REACH (8 * SURE_EPS)

/* The roundings in lambda there: 2.6 units of the origin, 1 of the nearest place and 1.5 of the root: 5.1, of 5.25. */
#define BOUND_TUBE_UNITS (5.25 * SURE_UNIT)

/* `off` of lambda(t) = off + |t| turn, the largest distance between the certified ray and the fixed-point ray at t: eo,
 * and the roundings that do not grow with t. */
FORMULA(TUBE_OFF);

/* `turn` of lambda(t), its growth with t: ed, and 16 u. */
FORMULA(TUBE_TURN);

/* eta = (r + lambda)^2 - r^2, the largest change of the squared distance from the axis at the side. */
FORMULA(TUBE_ETA);

/* The factor for the roundings of the bounds themselves, a few u. 2^-29 of what the factor adds. */
#define BOUND_TUBE_BOUND (1 + P2M(20))

/* The factor for the roundings of g, by which g^2 may be smaller. */
#define BOUND_TUBE_LEAST (1 - P2M(40))

/* The factor of ed in f'^2, the square of the fixed-point ray's part across the axis: f'^2 <= (f + ed)^2 = f^2 + ed (2
 * f + ed) <= f^2 + 3 ed. Unseen: small. */
#define BOUND_TUBE_SQUARE 3

/* The least f^2 that is taken as a divisor: along the axis 1/f^2 would be infinite, and every lane is undecided then. A
 * choice. Unseen: choice. */
#define BOUND_TUBE_SLANTED P2M(60)

/* The roundings of (D x A).(O - B) and |D x A|, as a part of pad: 32 u of the way to the shape, and pad is 2^-21 of
 * that way or more: 2^-27 of pad. 1 of 8. Unseen: small. */
#define BOUND_TUBE_ASIDE P2M(24)

/* The rounding of a height there: the point 1 unit, its product half of one, the end's half: 2 of 3. Unseen: small. */
#define BOUND_TUBE_HEIGHT_UNITS (3 * SURE_UNIT)

/* The rounding of a distance there, besides the errors so far: the quotient's half unit and the sum's. 1 of 2. Unseen:
 * small. */
#define BOUND_TUBE_DISTANCE_UNITS (2 * SURE_UNIT)

/* The error of `start`, the distance along the ray to the point nearest to the shape: off, and turn times |O - B|1. */
FORMULA(TUBE_START);

/* The largest height beyond the shape's ends at which hits are possible: lambda and TUBE_HEIGHT_UNITS. */
FORMULA(TUBE_MARGIN);

/* The error of t where the ray meets the side: lambda (r + lambda)/T, see cylinder_tmpl.h; and TUBE_DISTANCE_UNITS. */
FORMULA(TUBE_DISTANCE);

/* The error of the height at which the ray meets the side: the error of t, and TUBE_HEIGHT_UNITS. */
FORMULA(TUBE_END);

/* The error of t where the ray meets a plane across the axis: lambda/(|d| - turn), and TUBE_DISTANCE_UNITS. */
FORMULA(TUBE_CAP);

/* The factor of lambda in TUBE_DISTANCE: r + lambda over T = sqrt(g^2 - f'^2 eta). */
FORMULA(TUBE_STRETCH);

/* The error of the point: no more than that of t, see cylinder_tmpl.h. */
FORMULA(TUBE_POINT);

/* The distance from the axis below which a ray must come to meet the side: the radius, and pad, the largest distance
 * between the certified ray and the fixed-point ray. */
FORMULA(TUBE_WIDEST);

#endif
