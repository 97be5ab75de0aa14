/* paths.h - bounds of samples of light along paths: emitters_tmpl.h, scatter_tmpl.h, look_tmpl.h, ends_tmpl.h,
 * glass_tmpl.h, walk_paths_tmpl.h. */
#ifndef TIA_SIMD_RAYS_BOUNDS_PATHS_H
#define TIA_SIMD_RAYS_BOUNDS_PATHS_H

/* ---- densities of places on emitters, see emitters_tmpl.h ---- */

/* The factor of x = ed/d in the relative error of a plane's density: that is (2.125 x + y)/(1 - y) for x, y =
 * ecosine/|c| <= 1/8: 2.43 x + 1.15 y; the rest is for the bound's own roundings. Unseen: hidden. */
#define BOUND_PLANE_DENSITY_DISTANCE 2.5

/* The factor of y = ecosine/|c| in the relative error of a plane's density, derived with PLANE_DENSITY_DISTANCE.
 * Unseen: hidden. */
#define BOUND_PLANE_DENSITY_COSINE 1.25

/* The least d and |c| of a density, in their errors. Chosen together with PLANE_DENSITY_DISTANCE. Unseen: choice. */
#define BOUND_PLANE_DENSITY_KNOWN 8

/* The rounding of a plane's density, pi d^2/(A c). By doubles: pi and A, two quotients, two products: 6 u; there: four
 * products and quotients of 2^-61 and 2^-59. 6.1 of 32 u. Unseen: small. */
#define BOUND_PLANE_DENSITY_ROUNDING P2M(48)

/* The error of a plane's density: the density times the relative errors of d^2 and c and PLANE_DENSITY_ROUNDING, see
 * plane_density(). Unseen: hidden. */
FORMULA(PLANE_DENSITY);

/* The factor of x = ed/d in the relative error of s^2, s = r/d: 1/(1 - x)^2 - 1 <= 2.1 x for x <= 1/32; the rest is for
 * the bound's own roundings. Unseen: hidden. */
#define BOUND_CONE_SINE 2.25

/* The least d by which s^2 is computed, in its errors. Chosen together with CONE_SINE. Unseen: choice. */
#define BOUND_CONE_SINE_KNOWN 32

/* The rounding of s^2 = (r/d)^2, as a part of it. By doubles: r, a root of 2 u, a quotient, a product: 2 (1 + 2.5 + 1)
 * + 1 = 10 u; there: 2^-58. 10 of 16 u. Unseen: small. */
#define BOUND_CONE_SINE_ROUNDING P2M(49)

/* The rounding of s^2 there: halves of v in the sine and its square, and a unit when the square is halved: 3.5 of 4 v.
 * Unseen: small. */
#define BOUND_CONE_SINE_UNITS P2M(60)

/* The least 1 - s^2 of a cone, 2^-16, so that the root is no less than 2^-8. A choice. Unseen: choice. */
#define BOUND_CONE_WIDE P2M(16)

/* The least s^2 of a cone, 2^-30, so that v is 2^-32 of it. Chosen together with CONE_WIDE. Unseen: choice. */
#define BOUND_CONE_NARROW P2M(30)

/* The factor of the relative errors of s^2 and 1 + root in that of their quotient: both are off by less than an eighth
 * together, so 8/7; see cone_open(). Unseen: hidden. */
#define BOUND_CONE_QUOTIENT 1.15

/* The rounding of 1 + root and the quotient. By doubles: 3 of 32 u; there: 2^-59, and half of v in the root, which is
 * 2^-8 or more. Unseen: small. */
#define BOUND_CONE_QUOTIENT_ROUNDING P2M(48)

/* The error of s^2, as a part of it: CONE_SINE times ed/d, and CONE_SINE_ROUNDING. Unseen: hidden. */
FORMULA(CONE_SINE_PART);

/* The error of s^2/(1 + root), as a part of it: CONE_QUOTIENT times p, the relative error of s^2, and that of the root,
 * s^2 p/root. Unseen: hidden. */
FORMULA(CONE_PART);

/* The factor of `part`, the relative error of x, in that of 1/(2 x), a ball's density: x is within an eighth of itself,
 * so 8/7; the rest is for 2 u by doubles and 2^-59 there, as `part` is 2^-48 or more. Unseen: hidden. */
#define BOUND_BALL_DENSITY 1.25

/* The rounding of a ball's distance |C - P| by doubles: a difference of 2 u, of both, and a root of 2 u: 5 of 8 u.
 * Unseen: small. */
#define BOUND_BALL_DISTANCE_ROUNDING P2M(50)

/* The error of a ball's distance |C - P|: that of the point P, BALL_DISTANCE_ROUNDING, and a unit there, to which the
 * norm is cut. Unseen: hidden. */
FORMULA(BALL_DISTANCE);

/* The rounding of |way| by doubles: a root of a sum of squares, 2.5 of 8 u. Unseen: small. */
#define BOUND_SEEN_DISTANCE_ROUNDING P2M(50)

/* The error of |way|: that of the way, SEEN_DISTANCE_ROUNDING, and a unit there, to which it is cut. Unseen: hidden. */
FORMULA(SEEN_DISTANCE);

/* The error of the cosine of the direction and the emitter's normal: those of both, as FACING, and COSINE. Unseen:
 * hidden. */
FORMULA(SEEN_COSINE);

/* The rounding of a place on a rectangle or disc by doubles: 2 u - 1 is exact, a disc's is within 2^-50 in both
 * coordinates, 11.3 u of the radius; a product and the axis 2 u of the parts across and along, two sums 2 u of the
 * place. 11.3 of 16 u. Unseen: small. */
#define BOUND_EMITTER_PLACE_ROUNDING P2M(49)

/* The rounding of a place on a rectangle or disc there: half a unit each of a disc's two products, .71 U, and .87 U of
 * each of two points along axes: 2.45 of 6. Unseen: small. */
#define BOUND_EMITTER_PLACE_UNITS (6 * SURE_UNIT)

/* The error of a place on a rectangle or disc: EMITTER_PLACE_ROUNDING and EMITTER_PLACE_UNITS. Unseen: hidden. */
FORMULA(EMITTER_PLACE);

/* The rounding, by doubles, of the point's height over an emitter's plane: differences u of both, a dot product 4 u: 5
 * of 8 u. And of the way to the place and b N: 3 u. Unseen: small. */
#define BOUND_EMITTER_SIDE_ROUNDING P2M(50)

/* The rounding, there, of the point's height over an emitter's plane: the dot product's half unit; of the way, the
 * place off the plane .87 U: .87 of 2. Unseen: small. */
#define BOUND_EMITTER_SIDE_UNITS (2 * SURE_UNIT)

/* The error of the point's height over an emitter's plane, and of the way to the place: those of point and place,
 * EMITTER_SIDE_ROUNDING and EMITTER_SIDE_UNITS. Unseen: hidden. */
FORMULA(EMITTER_SIDE);

/* The rounding of the way to a ball's centre, C - P, by doubles: 2 of 4 u of both. It stands for the error of the
 * origin in sphere_tmpl.h, whose L is exact there. Unseen: small. */
#define BOUND_BALL_WAY_ROUNDING P2M(51)

/* The error of a place on a ball, t along a direction: as SPHERE_POINT, but the parts across and along are added, and
 * BALL_PLACE_UNITS and BALL_PLACE_ROUNDING. Unseen: hidden. */
FORMULA(BALL_PLACE);

/* The rounding of a place on a ball there: the point .87 U, and t's 1.5 U, which SPHERE_HALF_CHORD and
 * SPHERE_ALONG_UNIT have: 2.4 of 4. Unseen: small. */
#define BOUND_BALL_PLACE_UNITS (4 * SURE_UNIT)

/* The rounding of a place on a ball, O + t D, by doubles: 3.5 u of both as SURFACE_POINT. 3.5 of 8 u. Unseen: small. */
#define BOUND_BALL_PLACE_ROUNDING P2M(50)

/* The error of the way to a ball's centre, C - P: that of the point P, BALL_WAY_ROUNDING, and a unit. Unseen: hidden.
 */
FORMULA(BALL_WAY);

/* The rounding of the height h = open u, as a part of it. By doubles: a product, 1 of 8 u; there: half of v, 1 of 8.
 * The relative error of `open` is BALL_HEIGHT's. Unseen: small. */
#define BOUND_BALL_HEIGHT_ROUNDING P2M(50)

/* The rounding of h there: the halves of v of h and of h (1 - h/2), and the root's cut: 2 of 4 v. Unseen: small. */
#define BOUND_BALL_HEIGHT_UNITS P2M(60)

/* The error of the height h: h times `part`, the relative error of `open`, and BALL_HEIGHT_ROUNDING; and
 * BALL_HEIGHT_UNITS. Unseen: hidden. */
FORMULA(BALL_HEIGHT);

/* The factor of eh/r in the error of r = sqrt(2 h - h^2): |a - b|/(sqrt a + sqrt b) with |a - b| <= 2 eh, and sqrt b >=
 * .93 sqrt a while h is within an eighth: 1.04. Smaller h are off by v/2 of BALL_HEIGHT_UNITS' 4 v, an eighth, so that
 * 1.04 holds of them too. Unseen: hidden. */
#define BOUND_BALL_RADIUS_ROOT 1.125

/* The rounding of r = sqrt(h (2 - h)) by doubles: a difference, a product and a root: 2 of 16 u. There it is cut to v,
 * which BALL_HEIGHT_UNITS has. Unseen: small. */
#define BOUND_BALL_RADIUS_ROUNDING P2M(49)

/* The error of r: BALL_RADIUS_ROOT times eh/r, and BALL_RADIUS_ROUNDING. Unseen: hidden. */
FORMULA(BALL_RADIUS);

/* The error of the direction in the cone around z: those of r and h, and LOCAL of the turn that r multiplies. Unseen:
 * hidden. */
FORMULA(BALL_LOCAL);

/* The rounding of the way from a ball's centre to the place: 2 u of both, of which the place's own are in its bound. 2
 * of 4 u. Unseen: small. */
#define BOUND_BALL_NORMAL_ROUNDING P2M(51)

/* The error of the way from a ball's centre to the place, which v3_unit() divides by the radius for the normal: that of
 * the place, and BALL_NORMAL_ROUNDING. Unseen: hidden. */
FORMULA(BALL_NORMAL);

/* The rounding of the way to where the shadow ray ends, by doubles: a product, a sum and a difference: 3 of 8 u of
 * both. Unseen: small. */
#define BOUND_BALL_END_ROUNDING P2M(50)

/* The error of the way to where the shadow ray ends: those of the place and the point, and b times that of the normal;
 * POINT_UNITS and BALL_END_ROUNDING. Unseen: hidden. */
FORMULA(BALL_END);

/* The error of the way to a point light, L - P: that of the point, and POINT_ROUNDING of both; there it is exact.
 * Unseen: hidden. */
FORMULA(POINT_WAY);

/* ---- lobes, see scatter_tmpl.h ---- */

/* The factor of e/s in the relative error of a chance a/s, s being off by e: that is (a/s) (e/s) s/(s - e), and s > 16
 * e: 16/15; the rest is for the bound's own roundings. Unseen: hidden. */
#define BOUND_CHANCE_QUOTIENT 1.125

/* The least diffuse part with which chances are known, in its errors e. Chosen together with CHANCE_QUOTIENT. Unseen:
 * choice. */
#define BOUND_CHANCE_KNOWN 16

/* The rounding of a chance a/s. By doubles: three sums and a quotient: 4 of 8 u; there: 2^-59. Unseen: small. */
#define BOUND_CHANCE_ROUNDING P2M(50)

/* The error of a textured colour's largest channel there, besides the texel's: half a unit. 1 of 2. Unseen: small. */
#define BOUND_CHANCE_UNIT SURE_UNIT

/* The error of a chance, a share of the sum: the share times CHANCE_QUOTIENT e/s, as the sum s is off by e and its
 * terms before are exact, and CHANCE_ROUNDING. Unseen: hidden. */
FORMULA(CHANCE);

/* The error of R.L: those of both directions, as FACING, and COSINE. Unseen: hidden. */
FORMULA(LOBE_COSINE);

/* The error of p = x^n, x = R.L: n times LOBE_COSINE; POWER is added. Unseen: hidden. */
FORMULA(LOBE_POWER);

/* The error of (n + 2)/2 p c specular: that of p times the cosine c, and that of c times the height (n + 2)/2 p. By
 * doubles: 4 u of a height of 5001 at most, of which POWER has 170 u to spare. Unseen: hidden. */
FORMULA(LOBE_REFLECTED);

/* The rounding of a glossy lobe's light there: the height's half unit, by specular, and its product with specular and
 * with the cosine, half of one each: (1 + most/2) of 3 (1 + most). Unseen: small. */
#define BOUND_LOBE_UNITS (3 * SURE_UNIT)

/* The error of the density of a glossy lobe: that of p times (n + 1)/2, times the lobe's chance. Unseen: hidden. */
FORMULA(LOBE_DENSITY);

/* The rounding of the density of a glossy lobe there: the height's half unit: 1 of 4. Derived with LOBE_DENSITY.
 * Unseen: small. */
#define BOUND_LOBE_DENSITY_UNITS (2 * SURE_UNIT)

/* The error of the colour times the cosine: that of either times the other, both 1 at most. Unseen: hidden. */
FORMULA(DIFFUSE_REFLECTED);

/* The rounding of the colour times the cosine there: half a unit: 1 of 4. Derived with DIFFUSE_REFLECTED. Unseen:
 * small. */
#define BOUND_DIFFUSE_UNITS (2 * SURE_UNIT)

/* The rounding of the density of a diffuse lobe, its chance times the cosine. By doubles: a product, u; there: 2^-61. 1
 * of 4 u. Unseen: small. */
#define BOUND_DIFFUSE_DENSITY_ROUNDING P2M(51)

/* The error of the density of a diffuse lobe: that of the cosine, as the chance is 1 at most. Unseen: hidden. */
FORMULA(DIFFUSE_DENSITY);

/* ---- light that is looked for, see look_tmpl.h and walk_paths_tmpl.h ---- */

/* The factor of ex + x/q eq, over q, in the error of a quotient x/q: x/q - x'/q' <= (ex + x/q eq)/(q - eq), and q > 16
 * eq: 16/15; the rest is for the bound's own roundings. */
#define BOUND_SHARE_QUOTIENT 1.125

/* The least density that is divided by, in its errors. Chosen together with SHARE_QUOTIENT. Unseen: choice. */
#define BOUND_SHARE_KNOWN 16

/* The least density that is decided: fixed-point ones end at 2^-126. A choice, and so is 10^15, the most. Unseen:
 * choice. */
#define BOUND_SHARE_LEAST P2M(40)

/* The rounding of reflectance over density, as a part of it. By doubles: the density's two products and sum 3 u, an
 * inverse and a product 2 u: 5 of 8 u; there: 2^-59. Unseen: small. */
#define BOUND_SHARE_ROUNDING P2M(50)

/* The rounding of reflectance over density there: half a unit: 1 of 2. Unseen: small. */
#define BOUND_SHARE_UNIT SURE_UNIT

/* The error of reflectance over density: those of both, see SHARE_QUOTIENT. */
FORMULA(SHARE);

/* The error of the radiance times the falloff's factor: that of the factor, times the radiance. Unseen: hidden. */
FORMULA(SEEN_LIGHT);

/* The rounding of the radiance times the falloff's factor there: half a unit, 1 of 2. Derived with SEEN_LIGHT. Unseen:
 * small. */
#define BOUND_SEEN_LIGHT_UNIT SURE_UNIT

/* The error of SHARE's quotient times SEEN_LIGHT's light: that of either times the other. */
FORMULA(SEEN_PART);

/* The rounding of SHARE's quotient times SEEN_LIGHT's light there: half a unit: 1 of 4. Unseen: small. */
#define BOUND_SEEN_PART_UNITS (2 * SURE_UNIT)

/* The rounding of SHARE's quotient times SEEN_LIGHT's light by doubles: three products, 3 of 8 u. Derived with
 * SEEN_PART_UNITS. Unseen: small. */
#define BOUND_SEEN_PART_ROUNDING P2M(50)

/* The error of a throughput after scattering: that of the throughput before times the factor, and that of the factor
 * times the throughput. */
FORMULA(SCATTERED_WEIGHT);

/* The rounding of a throughput's product or quotient there: half a unit; 1 of 2. Unseen: small. */
#define BOUND_THROUGHPUT_UNIT SURE_UNIT

/* The rounding of a throughput's product or quotient, as a part of it. By doubles: u, or 2 u by an inverse; there:
 * 2^-59. 2.1 of 4 u. Unseen: small. */
#define BOUND_THROUGHPUT_ROUNDING P2M(51)

/* The error of a throughput times a material's constants: that of the throughput, times the largest of them. Unseen:
 * hidden. */
FORMULA(MULTIPLIED_WEIGHT);

/* The error of a throughput over an exact chance: that of the throughput, over the chance. Unseen: hidden. */
FORMULA(DIVIDED_WEIGHT);

/* The error of a chance to survive there, which is the throughput, within 2^-59 of itself, before it is cut to 32 bits.
 * 2^-14 of 1. Unseen: small. */
#define BOUND_SURVIVAL_UNIT SURE_UNIT

/* The error of a chance to survive: that of the throughput, and SURVIVAL_UNIT. Unseen: hidden. */
FORMULA(SURVIVAL);

/* The rounding of Fresnel's part in units of 2^-32, to which it is cut there: 1 of 2. Unseen: hidden. */
#define BOUND_REFLECTED_CHANCE 2

/* ---- light added to paths, see ends_tmpl.h ---- */

/* The error of the radiance, times the most that the throughput may be. */
FORMULA(ADDED);

/* The error of the throughput, times the radiance. */
FORMULA(ADDED_THROUGHPUT);

/* The rounding of the radiance times the throughput there: two products, half a unit each: 1 of 2. Unseen: small. */
#define BOUND_ADDED_UNITS (2 * SURE_UNIT)

/* The rounding of the radiance times the throughput by doubles: 1 of 4 u. Derived with ADDED_UNITS. Unseen: small. */
#define BOUND_ADDED_ROUNDING P2M(51)

/* The factor of eq + q/s es, over s, in the error of a weight q/s: q/s - q'/s' <= (eq + q/s es)/(s - es), s > 4 es:
 * 4/3; the rest is for the bound's own roundings. Unseen: hidden. */
#define BOUND_BALANCE_QUOTIENT 1.5

/* The least sum s of a weight q/s, in its errors es. Chosen together with BALANCE_QUOTIENT. Unseen: choice. */
#define BOUND_BALANCE_KNOWN 4

/* The rounding of a weight q/s. By doubles: a sum of two products and a quotient: 4 of 8 u; there: 2^-59; and a weight
 * within 2^-62 of 1 is 1 there. Unseen: small. */
#define BOUND_BALANCE_ROUNDING P2M(50)

/* The error of the balance heuristic's weight q/s: BALANCE_QUOTIENT times eq + q/s es, over s. Unseen: hidden. */
FORMULA(BALANCE);

/* The rounding of the radiance times the weight, by doubles: 1 of 2 u. Unseen: small. */
#define BOUND_WEIGHTED_ROUNDING P2M(52)

/* The rounding of the radiance times the weight there: two units, of which ADDED_UNITS has both: 0 of 2. Unseen: small.
 */
#define BOUND_WEIGHTED_UNITS (2 * SURE_UNIT)

/* The error of the radiance times the weight: the radiance times the error of the weight and WEIGHTED_ROUNDING. Unseen:
 * hidden. */
FORMULA(WEIGHTED);

/* The rounding of the radiance times the throughput there, before the weight: half a unit, as products of 2^17 and more
 * are cut. 1 of 2. Unseen: hidden. */
#define BOUND_WEIGHTED_CUT SURE_UNIT

/* The rounding of the distance to a light that is met, there: |t D| is the norm of a difference of points, .87 U, cut
 * to a unit, and 2^-57 of t: 1.87 of 4. Unseen: small. */
#define BOUND_MET_UNITS (4 * SURE_UNIT)

/* The rounding of the distance to a light that is met, as a part of t. By doubles: none; there: 2^-57. .06 of 16 u.
 * Unseen: small. */
#define BOUND_MET_ROUNDING P2M(49)

/* The error of the distance to a light that is met: that of t, MET_UNITS and MET_ROUNDING; and eo, which is not needed,
 * as the points are on the same ray. Unseen: hidden. */
FORMULA(MET_DISTANCE);

/* The error of the cosine to a light that is met: that of the direction, and COSINE. Unseen: hidden. */
FORMULA(MET_COSINE);

/* The error of facing light: the largest component of that light, times the error of the cosine to the viewer. Unseen:
 * hidden. */
FORMULA(FACING_LIGHT);

/* The rounding of facing light there: half a unit: 1 of 4. Derived with FACING_LIGHT. Unseen: small. */
#define BOUND_FACING_UNITS (2 * SURE_UNIT)

#endif
