/* rounds.h - bounds of cones and cylinders: round_tmpl.h, cylinder_tmpl.h. O and D are a ray's origin and direction, eo
 * and ed their errors; a prime marks a fixed-point value. */
#ifndef TIA_SIMD_RAYS_BOUNDS_ROUNDS_H
#define TIA_SIMD_RAYS_BOUNDS_ROUNDS_H

/* ---- cones, see round_tmpl.h and geometry/round.c ---- */

/* The rounding of start = -(O - A).D, relative to |O - A|1. Proved, like SPHERE_ALONG: rays_forms.g (tca), 4.1 of 8 u.
 * Unseen: small. */
#define BOUND_CONE_START_ROUNDING (8 * SURE_EPS)

/* The error of start: eo, |O - A| ed for the error of D, CONE_START_ROUNDING, and half a unit in fixed point. */
FORMULA(CONE_START);

/* The rounding of near = O - A + start D, relative to |O - A|1. Proved, like SPHERE_ASIDE: rays_forms.g (aside +
 * along). Unseen: small. */
#define BOUND_CONE_NEAR_ROUNDING (16 * SURE_EPS)

/* The error of near: eo, |start| ed across the ray and |O - A| ed along it, CONE_NEAR_ROUNDING and CONE_NEAR_UNITS. */
FORMULA(CONE_NEAR);

/* The rounding of near in fixed point: half a unit of start, and half a unit in each of the point's three coordinates.
 * Needed: 1.37 of 2 U. Unseen: small. */
#define BOUND_CONE_NEAR_UNITS (2 * SURE_UNIT)

/* The rounding of the point where the ray passes the shape, relative to |O - A|1: that of near, CONE_NEAR_ROUNDING.
 * Needed: 16 of 16 u. Unseen: small. */
#define BOUND_CONE_PASS_ROUNDING P2M(49)

/* The largest distance between the certified ray and the fixed-point ray near the shape: eo, (|start| + reach) ed, and
 * CONE_PASS_ROUNDING. */
FORMULA(CONE_PASS);

/* The relative rounding of the squares that are compared, each with 2 to 6 roundings, and of their bounds: 16 u at
 * most. Needed: 2^-9 of the value. Unseen: small. */
#define BOUND_CONE_SQUARE P2M(40)

/* The length that is added to the larger radius. passes_by() of geometry/round.c finds a miss where |P x Q| > (widest +
 * 2^-13) |Q| + 2^-32, widest being the larger radius; in doubles the sum is rounded within 2^-38. Needed: 2^-13 of
 * 2^-12. Unseen: small. */
#define BOUND_CONE_THICKNESS P2M(12)

/* The 2^-32 of the comparison in CONE_THICKNESS, and 4 units for the fixed-point roundings of both sides: half a unit
 * each of P's coordinates and of the products. passes_by() may take |Q| up to 2^-28 too large and find no miss; the
 * intersection after it then finds that the line passes the cone by 2^-12. Needed: 2^-32 of 2^-31. Unseen: small. */
#define BOUND_CONE_PASSED P2M(31)

/* The error of |P x Q| - thickness |Q|: CONE_PASS for the error of P; as much for that of Q in P x Q, as |P| ed is at
 * most reach ed for a point so near; and as much for that of Q in thickness |Q|. CONE_PASSED is added. Unseen: small.
 */
FORMULA(CONE_BESIDE);

/* The rounding of P x Q = (near.a0) y1 - (near.a1) y0, relative to |O - A|1, which is at least |near|: 16 u for near, 5
 * u each for its dot products and for y, 2 u for the products and the difference. Needed: 28 of 32 u. Unseen: small. */
#define BOUND_CONE_ASIDE P2M(48)

/* The rounding of D along an axis. In doubles: 4 u. In fixed point: half of 2^-62. The rest keeps `flat` above
 * CONE_KNOWN 2^-44 = 2^-39. num_dir_normalised() truncates 2^-62, which is then 2^-23 of `flat` and 2^-18 of this
 * bound. Needed: 4.1 of 512 u. Unseen: small. */
#define BOUND_CONE_DIRECTION P2M(44)

/* The error of D along an axis: ed and CONE_DIRECTION. */
FORMULA(CONE_TURN);

/* The rounding of near along an axis in doubles, relative to |near|1: the axis, a product and two sums. Needed: 4 of 8
 * u. Unseen: small. */
#define BOUND_CONE_PLACE_ROUNDING (8 * SURE_EPS)

/* The error of near along an axis: the error of near, CONE_PLACE_ROUNDING, and half a unit in fixed point. */
FORMULA(CONE_PLACE);

/* The factor of e/|v| in the error of v/|v|, v being a vector of two components with the error e < |v|/32: 1 + 2^-10.
 * Proved: rays_forms.g (turned). The rest of the factor covers the roundings of the bound itself. Unseen: small. */
#define BOUND_CONE_CHORD 1.0625

/* The least length of a vector in CONE_CHORD, in multiples of its error. Chosen together with CONE_CHORD. Unseen:
 * choice. */
#define BOUND_CONE_KNOWN 32

/* The rounding of v/|v|. In doubles: 5 u. In fixed point: 2^-58. Needed: 5.1 of 32 u. Unseen: small. */
#define BOUND_CONE_UNIT P2M(48)

/* The rounding of |v| <= 1. In doubles: two products, a sum and a root, 2.5 u. In fixed point |v| is v.(v/|v|): two
 * halves of 2^-62, and 2^-58. Needed: 2.6 of 512 u. Unseen: small. */
#define BOUND_CONE_LENGTH P2M(44)

/* The rounding of t in fixed point, which needs nothing here: the sum is exact, QUOTIENT_UNIT covers the quotient, and
 * CONE_START covers start. Needed: 0 of 2 U. Unseen: small. */
#define BOUND_CONE_UNITS (2 * SURE_UNIT)

/* The error of the point O + t D: eo, the error of t, t ed, and POINT_UNITS. */
FORMULA(CONE_POINT);

/* ---- cylinders, derived in cylinder_tmpl.h ---- */

/* The rounding of a ray in the cylinder's axes: 16 u of |O - B|1 for its origin, B being the base, and 16 u for its
 * direction. Proved: rays_forms.g (tube, tubed). Unseen: small. */
#define BOUND_TUBE (SURE_TUBE * SURE_EPS)

/* The other roundings in lambda, relative to the reach. In fixed point, direction components are rounded by half of
 * 2^-62, quotients by 2^-59 and unit vectors by 2^-57 or less, together below 2^-55, a fourth of u. The rest of 8 u
 * covers the error of t itself in lambda(t), which is taken at the farther end. Unseen: small. */
#define BOUND_TUBE_REACH (8 * SURE_EPS)

/* The roundings in lambda in fixed point: 2.6 units of the origin, 1 of the point nearest to the axis and 1.5 of the
 * root. Needed: 5.1 of 5.25 U. */
#define BOUND_TUBE_UNITS (5.25 * SURE_UNIT)

/* The constant `off` of lambda(t) = off + |t| turn, which bounds the distance between the certified ray and the
 * fixed-point ray at t: eo, and the roundings TUBE, TUBE_REACH and TUBE_UNITS, which do not grow with t. */
FORMULA(TUBE_OFF);

/* The slope `turn` of lambda(t) = off + |t| turn: ed, and the 16 u of TUBE for the direction. */
FORMULA(TUBE_TURN);

/* eta = (r + lambda)^2 - r^2, the largest change of the squared distance from the axis at the side. */
FORMULA(TUBE_ETA);

/* The factor for the roundings of the bounds themselves: 16 u at most, 2^-29 of the 2^-20 that it adds. */
#define BOUND_TUBE_BOUND (1 + P2M(20))

/* The factor of g^2 for its roundings, a few u. */
#define BOUND_TUBE_LEAST (1 - P2M(40))

/* The factor of turn in f'^2, the square of the fixed-point ray's part across the axis: f'^2 <= (f + turn)^2 = f^2 +
 * turn (2 f + turn) <= f^2 + 3 turn. Unseen: small. */
#define BOUND_TUBE_SQUARE 3

/* The least f^2 that is used as a divisor. For a ray along the axis 1/f^2 would be infinite; such lanes are undecided.
 * A choice. Unseen: choice. */
#define BOUND_TUBE_SLANTED P2M(60)

/* The rounding of (D x A).(O - B) and |D x A|, relative to pad: 32 u of the distance to the shape, and pad is at least
 * 2^-21 of that distance, so 2^-27 of pad. Needed: 2^-27 of 2^-24. Unseen: small. */
#define BOUND_TUBE_ASIDE P2M(24)

/* The rounding of a height in fixed point: 1 unit of the point, half a unit of its dot product, and half a unit of the
 * end's height. Needed: 2 of 3 U. Unseen: small. */
#define BOUND_TUBE_HEIGHT_UNITS (3 * SURE_UNIT)

/* The rounding of a distance in fixed point that lambda does not cover: half a unit each of the quotient and of the
 * sum. Needed: 1 of 2 U. Unseen: small. */
#define BOUND_TUBE_DISTANCE_UNITS (2 * SURE_UNIT)

/* The error of `start`, the distance along the ray to the point nearest to B: off, and turn times |O - B|1. */
FORMULA(TUBE_START);

/* The largest height beyond the shape's ends at which hits are possible: lambda and TUBE_HEIGHT_UNITS. */
FORMULA(TUBE_MARGIN);

/* The error of t where the ray meets the side: lambda (r + lambda)/T, see cylinder_tmpl.h, and TUBE_DISTANCE_UNITS. */
FORMULA(TUBE_DISTANCE);

/* The error of the height at which the ray meets the side: the error of t, and TUBE_HEIGHT_UNITS. */
FORMULA(TUBE_END);

/* The error of t where the ray meets a plane across the axis: lambda/(|d| - turn), d being the part of D along the
 * axis, and TUBE_DISTANCE_UNITS. */
FORMULA(TUBE_CAP);

/* The factor of lambda in TUBE_DISTANCE: (r + lambda)/T, T = sqrt(g^2 - f'^2 eta). */
FORMULA(TUBE_STRETCH);

/* The error of the point: at most that of t, see cylinder_tmpl.h. */
FORMULA(TUBE_POINT);

/* The distance from the axis within which a line may meet the side: the radius and pad, the largest distance between
 * the certified ray and the fixed-point ray. */
FORMULA(TUBE_WIDEST);

#endif
