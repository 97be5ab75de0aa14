/* paths.h - bounds of samples of light along paths: emitters_tmpl.h, look_tmpl.h, ends_tmpl.h, glass_tmpl.h,
 * walk_paths_tmpl.h. P is the lit point, N a surface's normal, L the direction to the light, and b the distance from
 * the surface at which new rays start. */
#ifndef TIA_SIMD_RAYS_BOUNDS_PATHS_H
#define TIA_SIMD_RAYS_BOUNDS_PATHS_H

/* ---- densities of places on emitters, see emitters_tmpl.h ---- */

/* The factor of x = ed/d in the relative error of a plane's density. With y = ecosine/|c|, both at most 1/8, this error
 * is (2.125 x + y)/(1 - y) <= 2.43 x + 1.15 y. The rest covers the roundings of the bound itself. Unseen: hidden. */
#define BOUND_PLANE_DENSITY_DISTANCE 2.5

/* The factor of y = ecosine/|c| in the relative error of a plane's density, derived with PLANE_DENSITY_DISTANCE.
 * Unseen: hidden. */
#define BOUND_PLANE_DENSITY_COSINE 1.25

/* The least d and |c| by which a density is computed, in multiples of their errors. Chosen together with
 * PLANE_DENSITY_DISTANCE. Unseen: choice. */
#define BOUND_PLANE_DENSITY_KNOWN 8

/* The relative rounding of a plane's density pi d^2/(A c). In doubles: pi, A, two quotients and two products, 6 u. In
 * fixed point: four products and quotients, within 2^-61 and 2^-59. Needed: 6.1 of 32 u. Unseen: small. */
#define BOUND_PLANE_DENSITY_ROUNDING P2M(48)

/* The error of a plane's density: the density, times the sum of the relative errors of d^2 and c and
 * PLANE_DENSITY_ROUNDING, see plane_density(). Unseen: hidden. */
FORMULA(PLANE_DENSITY);

/* The factor of x = ed/d in the relative error of s^2, s = r/d: 1/(1 - x)^2 - 1 <= 2.1 x for x <= 1/32. The rest covers
 * the roundings of the bound itself. Unseen: hidden. */
#define BOUND_CONE_SINE 2.25

/* The least d by which s^2 is computed, in multiples of its error. Chosen together with CONE_SINE. Unseen: choice. */
#define BOUND_CONE_SINE_KNOWN 32

/* The relative rounding of s^2 = (r/d)^2. In doubles: u for r, 2.5 u for d, which is a root, and u for the quotient,
 * all doubled by the square, and u for the square: 10 u. In fixed point: 2^-58. Needed: 10.1 of 16 u. Unseen: small. */
#define BOUND_CONE_SINE_ROUNDING P2M(49)

/* The rounding of s^2 in fixed point: half of 2^-62 each for the sine and its square, and 2^-62 for the division of the
 * square by 2. Needed: 3.5 of 4 units of 2^-62. Unseen: small. */
#define BOUND_CONE_SINE_UNITS P2M(60)

/* The least 1 - s^2 of a cone, so that its root is at least 2^-8. A choice. Unseen: choice. */
#define BOUND_CONE_WIDE P2M(16)

/* The least s^2 of a cone, so that 2^-62 is at most 2^-32 of it. Chosen together with CONE_WIDE. Unseen: choice. */
#define BOUND_CONE_NARROW P2M(30)

/* The factor of the relative errors of s^2 and 1 + root in that of their quotient: 8/7, as the errors are together less
 * than 1/8, see cone_open(). Unseen: hidden. */
#define BOUND_CONE_QUOTIENT 1.15

/* The relative rounding of 1 + root and the quotient. In doubles: 3 of 32 u. In fixed point: 2^-59, and half of 2^-62
 * in the root, which is at least 2^-8. Unseen: small. */
#define BOUND_CONE_QUOTIENT_ROUNDING P2M(48)

/* The relative error of s^2: CONE_SINE times ed/d, and CONE_SINE_ROUNDING. Unseen: hidden. */
FORMULA(CONE_SINE_PART);

/* The relative error of s^2/(1 + root): CONE_QUOTIENT times the sum of p, the relative error of s^2, and s^2 p/root,
 * the error of the root. Unseen: hidden. */
FORMULA(CONE_PART);

/* The factor of `part`, the relative error of x, in that of 1/(2 x), a ball's density: 8/7, as `part` is below 1/8. The
 * rest covers 2 u in doubles and 2^-59 in fixed point, as `part` is at least 2^-48. Unseen: hidden. */
#define BOUND_BALL_DENSITY 1.25

/* The rounding of a ball's distance |C - P| in doubles, relative to |C - P|1 and |P|1: 2 u for the difference and 2.5 u
 * for a root. Needed: 5 of 8 u. Unseen: small. */
#define BOUND_BALL_DISTANCE_ROUNDING P2M(50)

/* The error of a ball's distance |C - P|: the error of P, BALL_DISTANCE_ROUNDING, and a unit in fixed point, to which
 * the norm is truncated. Unseen: hidden. */
FORMULA(BALL_DISTANCE);

/* The relative rounding of |way| in doubles: the root of a sum of squares. Needed: 2.5 of 8 u. Unseen: small. */
#define BOUND_SEEN_DISTANCE_ROUNDING P2M(50)

/* The error of |way|: the error of the vector `way`, SEEN_DISTANCE_ROUNDING, and a unit in fixed point, to which the
 * norm is truncated. Unseen: hidden. */
FORMULA(SEEN_DISTANCE);

/* The error of the cosine between the direction and the emitter's normal: the errors of both, as in FACING, and COSINE.
 * Unseen: hidden. */
FORMULA(SEEN_COSINE);

/* The rounding of a place on a rectangle or disc in doubles. Relative to the radius: a disc's coordinates are within
 * 2^-50 each, 11.3 u together; a rectangle's are exact. Relative to the parts across and along: 3 u for two products
 * and the axis. Relative to the place: 2 u for two sums. Needed: 11.3 of 16 u. Unseen: small. */
#define BOUND_EMITTER_PLACE_ROUNDING P2M(49)

/* The rounding of a place on a rectangle or disc in fixed point: half a unit each for a disc's two products, .71 U, and
 * .87 U for each of two points along axes. Needed: 2.45 of 6 U. Unseen: small. */
#define BOUND_EMITTER_PLACE_UNITS (6 * SURE_UNIT)

/* The error of a place on a rectangle or disc: EMITTER_PLACE_ROUNDING and EMITTER_PLACE_UNITS. Unseen: hidden. */
FORMULA(EMITTER_PLACE);

/* The rounding in doubles of the point's height over an emitter's plane: u for the difference and 4 u for a dot
 * product. Needed: 5 of 8 u. The vector to the place plus b N needs 3 u. Unseen: small. */
#define BOUND_EMITTER_SIDE_ROUNDING P2M(50)

/* The rounding in fixed point of the point's height over an emitter's plane, half a unit of the dot product, and of the
 * vector to the point off the plane, .87 U. Needed: .87 of 2 U. Unseen: small. */
#define BOUND_EMITTER_SIDE_UNITS (2 * SURE_UNIT)

/* The error of the point's height over an emitter's plane, and of the vector to the place: the errors of the point and
 * the place, EMITTER_SIDE_ROUNDING and EMITTER_SIDE_UNITS. Unseen: hidden. */
FORMULA(EMITTER_SIDE);

/* The rounding of the vector C - P to a ball's centre in doubles, relative to |C - P|1 and |P|1: u for the conversion
 * of C and u for the difference. In fixed point it is exact. ball_place() adds it to the error of the origin in the
 * formulas of sphere_tmpl.h. Needed: 2 of 4 u. Unseen: small. */
#define BOUND_BALL_WAY_ROUNDING P2M(51)

/* The error of a place on a ball, at t along a direction: as SPHERE_POINT, but the parts across and along are added,
 * with BALL_PLACE_UNITS and BALL_PLACE_ROUNDING. Unseen: hidden. */
FORMULA(BALL_PLACE);

/* The rounding of a place on a ball in fixed point: .87 U of the point, and 1.5 U of t, of which SPHERE_ROOT_UNIT has
 * 1. Needed: 2.4 of 4 U. Unseen: small. */
#define BOUND_BALL_PLACE_UNITS (4 * SURE_UNIT)

/* The rounding of a place on a ball, O + t D, in doubles: 3.5 u, as in SURFACE_POINT. Needed: 3.5 of 8 u. Unseen:
 * small. */
#define BOUND_BALL_PLACE_ROUNDING P2M(50)

/* The error of the vector C - P to a ball's centre: the error of P, BALL_WAY_ROUNDING, and a unit. Unseen: hidden. */
FORMULA(BALL_WAY);

/* The relative rounding in doubles of the height h, the product of `open` and a random number. BALL_HEIGHT_UNITS has
 * the rounding in fixed point, BALL_HEIGHT the error of `open`. Needed: 1 of 8 u. Unseen: small. */
#define BOUND_BALL_HEIGHT_ROUNDING P2M(50)

/* The rounding of h in fixed point: halves of 2^-62 for h and for h (1 - h/2), and 2^-62 for the root, which is
 * truncated. Needed: 2 of 4 units of 2^-62. Unseen: small. */
#define BOUND_BALL_HEIGHT_UNITS P2M(60)

/* The error of the height h: h times the sum of `part`, the relative error of `open`, and BALL_HEIGHT_ROUNDING; and
 * BALL_HEIGHT_UNITS. Unseen: hidden. */
FORMULA(BALL_HEIGHT);

/* The factor of eh/r in the error of r = sqrt(2 h - h^2): |a - b|/(sqrt a + sqrt b), where |a - b| <= 2 eh, and sqrt b
 * >= .93 sqrt a if the relative error of h is below 1/8, so 1.04. A smaller h is off by 2^-63, only an eighth of
 * BALL_HEIGHT_UNITS, so that 1.04 holds for it too. Unseen: hidden. */
#define BOUND_BALL_RADIUS_ROOT 1.125

/* The relative rounding of r = sqrt(h (2 - h)) in doubles: a difference, a product and a root. In fixed point r is
 * truncated to 2^-62, which BALL_HEIGHT_UNITS covers. Needed: 2 of 16 u. Unseen: small. */
#define BOUND_BALL_RADIUS_ROUNDING P2M(49)

/* The error of r: BALL_RADIUS_ROOT times eh/r, and BALL_RADIUS_ROUNDING. Unseen: hidden. */
FORMULA(BALL_RADIUS);

/* The error of the direction in the cone around z: the errors of r and h, and LOCAL for the cosine and the sine that r
 * multiplies. Unseen: hidden. */
FORMULA(BALL_LOCAL);

/* The rounding of the vector from a ball's centre to the place: u for the conversion of the centre and u for the
 * difference. The roundings of the place are in its own bound. Needed: 2 of 4 u. Unseen: small. */
#define BOUND_BALL_NORMAL_ROUNDING P2M(51)

/* The error of the vector from a ball's centre to the place: the error of the place, and BALL_NORMAL_ROUNDING.
 * v3_unit() divides it by the radius for the normal. Unseen: hidden. */
FORMULA(BALL_NORMAL);

/* The rounding of the vector to the shadow ray's end in doubles, relative to the vector and the place: a product, a sum
 * and a difference. Needed: 3 of 8 u. Unseen: small. */
#define BOUND_BALL_END_ROUNDING P2M(50)

/* The error of the vector to the shadow ray's end: the errors of the place and the point, b times that of the normal,
 * POINT_UNITS and BALL_END_ROUNDING. Unseen: hidden. */
FORMULA(BALL_END);

/* The error of the vector C - P to a point light at C: the error of P, and POINT_ROUNDING. In fixed point the
 * difference is exact. Unseen: hidden. */
FORMULA(POINT_WAY);

/* ---- sampled emitters and throughputs, see look_tmpl.h and walk_paths_tmpl.h ---- */

/* The error of the radiance times the falloff's factor: the error of the factor, times the radiance. Unseen: hidden. */
FORMULA(SEEN_LIGHT);

/* The rounding of the radiance times the falloff's factor in fixed point: half a unit. Derived with SEEN_LIGHT. Needed:
 * .5 of 1 U. Unseen: small. */
#define BOUND_SEEN_LIGHT_UNIT SURE_UNIT

/* The error of reflectance over density, times SEEN_LIGHT's light: the error of either, times the other. */
FORMULA(SEEN_PART);

/* The rounding of reflectance over density, times SEEN_LIGHT's light, in fixed point: half a unit. Needed: .5 of 2 U.
 * Unseen: small. */
#define BOUND_SEEN_PART_UNITS (2 * SURE_UNIT)

/* The relative rounding of reflectance over density, times SEEN_LIGHT's light, in doubles: three products. Derived with
 * SEEN_PART_UNITS. Needed: 3 of 8 u. Unseen: small. */
#define BOUND_SEEN_PART_ROUNDING P2M(50)

/* The error of a throughput after scattering: the error of the throughput before times the factor, and the error of the
 * factor times the throughput. */
FORMULA(SCATTERED_WEIGHT);

/* The rounding of a throughput's product or quotient in fixed point: half a unit. Needed: .5 of 1 U. Unseen: small. */
#define BOUND_THROUGHPUT_UNIT SURE_UNIT

/* The relative rounding of a throughput's product or quotient. In doubles: u, or 2 u by an inverse. In fixed point:
 * 2^-59. Needed: 2.1 of 4 u. Unseen: small. */
#define BOUND_THROUGHPUT_ROUNDING P2M(51)

/* The error of a throughput times a material's constants: the error of the throughput, times the largest of them.
 * Unseen: hidden. */
FORMULA(MULTIPLIED_WEIGHT);

/* The least chance c by which a throughput is divided, in multiples of its error e. Chosen together with
 * DIVIDED_QUOTIENT. Unseen: choice. */
#define BOUND_DIVIDED_KNOWN 16

/* The factor of x = e/c in 1/(1 - x) - 1 = x/(1 - x), which is at most 16/15 x for x < 1/16. Unseen: hidden. */
#define BOUND_DIVIDED_QUOTIENT 2

/* The error of a throughput w divided by a chance c within e: (ew + w/c e)/(c - e), see divide_by(). Unseen: hidden. */
FORMULA(DIVIDED_WEIGHT);

/* The rounding of the chance to survive in fixed point: the throughput within 2^-59, before it is truncated to 32 bits.
 * Needed: 2^-14 of 1 U. Unseen: small. */
#define BOUND_SURVIVAL_UNIT SURE_UNIT

/* The error of the chance to survive: the error of the throughput, and SURVIVAL_UNIT. Unseen: hidden. */
FORMULA(SURVIVAL);

/* The rounding of Fresnel's part in units of 2^-32, to which it is truncated in fixed point. Needed: 1 of 2 units.
 * Unseen: hidden. */
#define BOUND_REFLECTED_CHANCE 2

/* ---- light added to paths, see ends_tmpl.h ---- */

/* The error of the radiance, times the largest value of the throughput within its error. */
FORMULA(ADDED);

/* The error of the throughput, times the radiance. */
FORMULA(ADDED_THROUGHPUT);

/* The rounding of the radiance times the throughput in fixed point: half a unit each for two products. Needed: 1 of 2
 * U. Unseen: small. */
#define BOUND_ADDED_UNITS (2 * SURE_UNIT)

/* The relative rounding of the radiance times the throughput in doubles. Derived with ADDED_UNITS. Needed: 1 of 4 u.
 * Unseen: small. */
#define BOUND_ADDED_ROUNDING P2M(51)

/* The factor of the numerator over s^2 in BALANCE: s/(s - es), and s > 4 es, so 4/3. The rest covers the roundings of
 * the bound itself. */
#define BOUND_BALANCE_QUOTIENT 1.5

/* The least sum s of a weight q/s, in multiples of its error es. Chosen together with BALANCE_QUOTIENT. Unseen: choice.
 */
#define BOUND_BALANCE_KNOWN 4

/* The rounding of a weight q/s. In doubles: u each for 1/n, two products, a sum and an inverse. In fixed point: 2^-59,
 * and a weight within 2^-62 of 1 is 1. Needed: 5.1 of 8 u. Unseen: small. */
#define BOUND_BALANCE_ROUNDING P2M(50)

/* The error of the balance heuristic's weight q/s, s = q + b: q/s - q'/s' = (b (q - q') - q (b - b'))/(s s'). */
FORMULA(BALANCE);

/* The relative rounding of the radiance times the weight in doubles. Needed: 1 of 2 u. Unseen: small. */
#define BOUND_WEIGHTED_ROUNDING P2M(52)

/* The rounding of the radiance times the weight in fixed point, which ADDED_UNITS covers. Needed: 0 of 2 U. Unseen:
 * small. */
#define BOUND_WEIGHTED_UNITS (2 * SURE_UNIT)

/* The error of the radiance times the weight: the radiance, times the error of the weight and WEIGHTED_ROUNDING.
 * Unseen: hidden. */
FORMULA(WEIGHTED);

/* The rounding in fixed point of the radiance times the throughput, before the weight, where it is compared with the
 * limit 2^17 of such products: half a unit. Needed: .5 of 1 U. Unseen: hidden. */
#define BOUND_WEIGHTED_CUT SURE_UNIT

/* The rounding of the distance to a light that is met, in fixed point. |t D| is the norm of a difference of points, .87
 * U, truncated to a unit. Needed: 1.87 of 4 U. Unseen: small. */
#define BOUND_MET_UNITS (4 * SURE_UNIT)

/* The rounding of the distance to a light that is met, relative to t. In doubles: none. In fixed point: 2^-57, as D is
 * not exactly 1 long. Needed: .07 of 16 u. Unseen: small. */
#define BOUND_MET_ROUNDING P2M(49)

/* The error of the distance to a light that is met: the error of t, MET_UNITS and MET_ROUNDING. It also includes eo,
 * which is not needed, as both points are on the same ray. Unseen: hidden. */
FORMULA(MET_DISTANCE);

/* The error of the cosine between the direction and the normal of a light that is met: the error of the direction, and
 * COSINE. Unseen: hidden. */
FORMULA(MET_COSINE);

/* The error of facing light: its largest component, times the error of the cosine to the viewer. Unseen: hidden. */
FORMULA(FACING_LIGHT);

/* The rounding of facing light in fixed point: half a unit. Derived with FACING_LIGHT. Needed: .5 of 2 U. Unseen:
 * small. */
#define BOUND_FACING_UNITS (2 * SURE_UNIT)

#endif
