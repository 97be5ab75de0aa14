/* paths.h - bounds of samples of light along paths: emitters_tmpl.h, scatter_tmpl.h, look_tmpl.h, ends_tmpl.h,
 * glass_tmpl.h, walk_paths_tmpl.h. */
#ifndef TIA_SIMD_RAYS_BOUNDS_PATHS_H
#define TIA_SIMD_RAYS_BOUNDS_PATHS_H

/* ---- densities of places on emitters, see emitters_tmpl.h ---- */

/* (2.125 x + y)/(1 - y) for x, y <= 1/8: 2.43 x + 1.15 y; the rest is for the bound's own roundings. Unseen: hidden. */
#define BOUND_PLANE_DENSITY_DISTANCE 2.5
#define BOUND_PLANE_DENSITY_COSINE 1.25 /* derived with PLANE_DENSITY_DISTANCE. Unseen: hidden. */
#define BOUND_PLANE_DENSITY_KNOWN 8     /* chosen together with PLANE_DENSITY_DISTANCE. Unseen: choice. */

/* pi d^2/(A c) by doubles: pi and A, two quotients, two products: 6 u; there four products and quotients of 2^-61 and
 * 2^-59. 6.1 of 32 u. Unseen: small. */
#define BOUND_PLANE_DENSITY_ROUNDING P2M(48)

/* Relative errors of d^2 and c, see plane_density(). Unseen: hidden. */
FORMULA(PLANE_DENSITY);

/* 1/(1 - x)^2 - 1 <= 2.1 x for x = ed/d <= 1/32; the rest is for the bound's own roundings. Unseen: hidden. */
#define BOUND_CONE_SINE 2.25
#define BOUND_CONE_SINE_KNOWN 32 /* chosen together with CONE_SINE. Unseen: choice. */

/* (r/d)^2 by doubles: r, a root of 2 u, a quotient, a product: 2 (1 + 2.5 + 1) + 1 = 10 u; there 2^-58. 10 of 16 u.
 * Unseen: small. */
#define BOUND_CONE_SINE_ROUNDING P2M(49)

/* There halves of v in the sine and its square, and a unit when the square is halved, of the square: 3.5 of 4 v.
 * Unseen: small. */
#define BOUND_CONE_SINE_UNITS P2M(60)

/* s^2 <= 1 - 2^-16, so that the root is no less than 2^-8, and s^2 above 2^-30, so that v is 2^-32 of it. Choices.
 * Unseen: choice. */
#define BOUND_CONE_WIDE P2M(16)
#define BOUND_CONE_NARROW P2M(30) /* chosen together with CONE_WIDE. Unseen: choice. */

/* A quotient of which both are off by less than an eighth together: 8/7 of that; see cone_open(). Unseen: hidden. */
#define BOUND_CONE_QUOTIENT 1.15

/* 1 + root and the quotient by doubles: 3 of 32 u; there 2^-59 and half of v in the root, which is 2^-8 or more.
 * Unseen: small. */
#define BOUND_CONE_QUOTIENT_ROUNDING P2M(48)

/* The error of s^2, as a part of it. Unseen: hidden. */
FORMULA(CONE_SINE_PART);

/* The relative errors of s^2 and of the root, s^2 p/root. Unseen: hidden. */
FORMULA(CONE_PART);

/* 1/(2 x) where x is within an eighth of itself: 8/7 of the part; the rest is for 2 u here and 2^-59 there, as the part
 * is 2^-48 or more. Unseen: hidden. */
#define BOUND_BALL_DENSITY 1.25

/* |C - P| by doubles: a difference of 2 u, of both, and a root of 2 u: 5 of 8 u. Unseen: small. */
#define BOUND_BALL_DISTANCE_ROUNDING P2M(50)

/* |C - P|: the error of the point, and the rounding; there the norm is cut to a unit. Unseen: hidden. */
FORMULA(BALL_DISTANCE);

/* |way| by doubles: a root of a sum of squares, 2.5 of 8 u. Unseen: small. */
#define BOUND_SEEN_DISTANCE_ROUNDING P2M(50)

/* |way|: the error of the way, and the rounding; there it is cut to a unit. Unseen: hidden. */
FORMULA(SEEN_DISTANCE);

/* The errors of the direction and the normal, as FACING. Unseen: hidden. */
FORMULA(SEEN_COSINE);

/* A place on a rectangle or disc by doubles: 2 u - 1 is exact, a disc's is within 2^-50 in both coordinates, 11.3 u of
 * the radius; a product and the axis 2 u of the parts across and along, two sums 2 u of the place. 11.3 of 16 u.
 * Unseen: small. */
#define BOUND_EMITTER_PLACE_ROUNDING P2M(49)

/* There: a disc's two products half a unit each, .71 U, two points along axes .87 U each: 2.45 of 6. Unseen: small. */
#define BOUND_EMITTER_PLACE_UNITS (6 * SURE_UNIT)

/* The error of the place: EMITTER_PLACE_ROUNDING and EMITTER_PLACE_UNITS. Unseen: hidden. */
FORMULA(EMITTER_PLACE);

/* The way back's height over the plane: differences u of both, a dot product 4 u: 5 of 8 u. And of the way itself,
 * which b N lies beside: 3 u. Unseen: small. */
#define BOUND_EMITTER_SIDE_ROUNDING P2M(50)

/* There the dot product half a unit; of the way, the place off the plane .87 U: .87 of 2. Unseen: small. */
#define BOUND_EMITTER_SIDE_UNITS (2 * SURE_UNIT)

/* The errors of point and place. Unseen: hidden. */
FORMULA(EMITTER_SIDE);

/* C - P by doubles: 2 of 4 u of both. It stands for the error of the origin in sphere_tmpl.h, whose L is exact there.
 * Unseen: small. */
#define BOUND_BALL_WAY_ROUNDING P2M(51)

/* A place on a ball, t along a direction: as SPHERE_POINT, not at right angles but added. Unseen: hidden. */
FORMULA(BALL_PLACE);

/* There: the point .87 U, and t's 1.5 U, which SPHERE_HALF_CHORD and SPHERE_ALONG_UNIT have: 2.4 of 4. Unseen: small.
 */
#define BOUND_BALL_PLACE_UNITS (4 * SURE_UNIT)

/* O + t D by doubles, 3.5 u of both as SURFACE_POINT. 3.5 of 8 u. Unseen: small. */
#define BOUND_BALL_PLACE_ROUNDING P2M(50)

/* C - P: the error of the point. Unseen: hidden. */
FORMULA(BALL_WAY);

/* h = open u: the relative error of `open`, and a product, 1 of 8 u; there half of v. 1 of 8. Unseen: small. */
#define BOUND_BALL_HEIGHT_ROUNDING P2M(50)

/* There the halves of v of h and of h (1 - h/2), and the root's cut: 2 of 4 v. Unseen: small. */
#define BOUND_BALL_HEIGHT_UNITS P2M(60)

/* The error of h. Unseen: hidden. */
FORMULA(BALL_HEIGHT);

/* r = sqrt(2 h - h^2): |a - b|/(sqrt a + sqrt b) with |a - b| <= 2 eh, and sqrt b >= .93 sqrt a while h is within an
 * eighth: 1.04 eh/r. Smaller h are off by v/2 of BALL_HEIGHT_UNITS' 4 v, an eighth, so that 1.04 holds of them too.
 * Unseen: hidden. */
#define BOUND_BALL_RADIUS_ROOT 1.125

/* By doubles a difference, a product and a root: 2 of 16 u. There it is cut to v, which BALL_HEIGHT_UNITS has. Unseen:
 * small. */
#define BOUND_BALL_RADIUS_ROUNDING P2M(49)

/* The error of r. Unseen: hidden. */
FORMULA(BALL_RADIUS);

/* The direction in the cone: r times a turn that is off by LOCAL, and the errors of r and h. Unseen: hidden. */
FORMULA(BALL_LOCAL);

/* The place from the centre: 2 u of both, of which the point's own are in its bound. 2 of 4 u. Unseen: small. */
#define BOUND_BALL_NORMAL_ROUNDING P2M(51)

/* The normal: the error of the place, over the radius. Unseen: hidden. */
FORMULA(BALL_NORMAL);

/* The way to where the shadow ray ends: a product, a sum and a difference: 3 of 8 u of both. Unseen: small. */
#define BOUND_BALL_END_ROUNDING P2M(50)

/* The errors of the place and the point, and b times that of the normal. Unseen: hidden. */
FORMULA(BALL_END);

/* L - P: the error of the point, and POINT_ROUNDING of both; there it is exact. Unseen: hidden. */
FORMULA(POINT_WAY);

/* ---- lobes, see scatter_tmpl.h ---- */

/* (a/s) (e/s) s/(s - e), and s > 16 e: 16/15 of it; the rest is for the bound's own roundings. Unseen: hidden. */
#define BOUND_CHANCE_QUOTIENT 1.125
#define BOUND_CHANCE_KNOWN 16 /* chosen together with CHANCE_QUOTIENT. Unseen: choice. */

/* a/s by doubles, three sums and a quotient: 4 of 8 u; there 2^-59. Unseen: small. */
#define BOUND_CHANCE_ROUNDING P2M(50)

/* A textured colour's largest channel: the error of the texel, and half a unit. 1 of 2. Unseen: small. */
#define BOUND_CHANCE_UNIT SURE_UNIT

/* The sum is off by e, its terms before are exact. Unseen: hidden. */
FORMULA(CHANCE);

/* R.L: the errors of both directions, as FACING. Unseen: hidden. */
FORMULA(LOBE_COSINE);

/* x^n: n times LOBE_COSINE, and POWER. Unseen: hidden. */
FORMULA(LOBE_POWER);

/* (n + 2)/2 p c specular: the error of p times the cosine, and that of c times the height. By doubles 4 u of a height
 * of 5001 at most, of which POWER has 170 u to spare. Unseen: hidden. */
FORMULA(LOBE_REFLECTED);

/* There: the height's half unit, by specular, its product with specular and with the cosine, half of one each: (1 +
 * most/2) of 3 (1 + most). Unseen: small. */
#define BOUND_LOBE_UNITS (3 * SURE_UNIT)

/* The error of the lobe's density, times its chance; there the height's half unit: 1 of 4. Unseen: hidden. */
FORMULA(LOBE_DENSITY);

/* Derived with LOBE_DENSITY. Unseen: small. */
#define BOUND_LOBE_DENSITY_UNITS (2 * SURE_UNIT)

/* Colour by cosine: the error of either times the other, both 1 at most; there half a unit: 1 of 4. Unseen: hidden. */
FORMULA(DIFFUSE_REFLECTED);

/* Derived with DIFFUSE_REFLECTED. Unseen: small. */
#define BOUND_DIFFUSE_UNITS (2 * SURE_UNIT)

/* Chance by cosine: the error of the cosine, and a product by doubles; there 2^-61. 1 of 4 u. Unseen: small. */
#define BOUND_DIFFUSE_DENSITY_ROUNDING P2M(51)

/* Derived with DIFFUSE_DENSITY_ROUNDING. Unseen: hidden. */
FORMULA(DIFFUSE_DENSITY);

/* ---- light that is looked for, see look_tmpl.h and walk_paths_tmpl.h ---- */

/* x/q - x'/q' <= (ex + x/q eq)/(q - eq), and q > 16 eq: 16/15 of it; the rest is for the bound's own roundings. */
#define BOUND_SHARE_QUOTIENT 1.125
#define BOUND_SHARE_KNOWN 16 /* chosen together with SHARE_QUOTIENT. Unseen: choice. */

/* Smaller densities are undecided: fixed-point ones end at 2^-126. A choice, and so is 10^15 above. Unseen: choice. */
#define BOUND_SHARE_LEAST P2M(40)

/* By doubles the density's two products and sum 3 u, an inverse and a product 2 u: 5 of 8 u; there 2^-59. Unseen:
 * small. */
#define BOUND_SHARE_ROUNDING P2M(50)

/* There half a unit: 1 of 2. Unseen: small. */
#define BOUND_SHARE_UNIT SURE_UNIT

/* Reflectance over density: both are off, see SHARE_QUOTIENT. */
FORMULA(SHARE);

/* Radiance times the part that is left: there half a unit, 1 of 2. Unseen: hidden. */
FORMULA(SEEN_LIGHT);

/* Derived with SEEN_LIGHT. Unseen: small. */
#define BOUND_SEEN_LIGHT_UNIT SURE_UNIT

/* Share by light: the error of either times the other. */
FORMULA(SEEN_PART);

/* There half a unit: 1 of 4. By doubles three products, 3 of 8 u. Unseen: small. */
#define BOUND_SEEN_PART_UNITS (2 * SURE_UNIT)
#define BOUND_SEEN_PART_ROUNDING P2M(50) /* derived with SEEN_PART_UNITS. Unseen: small. */

/* The error of the throughput times the factor, and that of the factor times the throughput. */
FORMULA(SCATTERED_WEIGHT);

/* A throughput's product or quotient there: half a unit; 1 of 2. Unseen: small. */
#define BOUND_THROUGHPUT_UNIT SURE_UNIT

/* By doubles a product, u; by an inverse 2 u, there 2^-59. 2.1 of 4 u. Unseen: small. */
#define BOUND_THROUGHPUT_ROUNDING P2M(51)

/* Throughput by a material's constants: the error of the throughput, times the largest. Unseen: hidden. */
FORMULA(MULTIPLIED_WEIGHT);

/* Throughput over an exact chance: the error of the throughput over it. Unseen: hidden. */
FORMULA(DIVIDED_WEIGHT);

/* A chance is the throughput, within 2^-59 of itself there, cut to 32 bits. 2^-14 of 1. Unseen: small. */
#define BOUND_SURVIVAL_UNIT SURE_UNIT

/* SURVIVAL_UNIT and the error of the throughput. Unseen: hidden. */
FORMULA(SURVIVAL);

/* Fresnel's part in units of 2^-32, cut there: 1 of 2. Unseen: hidden. */
#define BOUND_REFLECTED_CHANCE 2

/* ---- light added to paths, see ends_tmpl.h ---- */

/* Radiance by throughput: the error of the radiance, times the throughput. */
FORMULA(ADDED);

/* The error of the throughput, times the radiance. */
FORMULA(ADDED_THROUGHPUT);

/* There two products, half a unit each: 1 of 2. By doubles u of 4. Unseen: small. */
#define BOUND_ADDED_UNITS (2 * SURE_UNIT)
#define BOUND_ADDED_ROUNDING P2M(51) /* derived with ADDED_UNITS. Unseen: small. */

/* q/s - q'/s' <= (eq + q/s es)/(s - es), s > 4 es: 4/3 of it; the rest is for the bound's own roundings. Unseen:
 * hidden. */
#define BOUND_BALANCE_QUOTIENT 1.5
#define BOUND_BALANCE_KNOWN 4 /* chosen together with BALANCE_QUOTIENT. Unseen: choice. */

/* A sum of two products and a quotient by doubles: 4 of 8 u; there 2^-59; a weight within 2^-62 of 1 is 1 there.
 * Unseen: small. */
#define BOUND_BALANCE_ROUNDING P2M(50)

/* The balance heuristic's weight. Unseen: hidden. */
FORMULA(BALANCE);

/* Radiance by weight, by doubles: 1 of 2 u. Unseen: small. */
#define BOUND_WEIGHTED_ROUNDING P2M(52)

/* Two units there, of which ADDED_UNITS has both: 0 of 2. Unseen: small. */
#define BOUND_WEIGHTED_UNITS (2 * SURE_UNIT)

/* Radiance by the error of the weight. Unseen: hidden. */
FORMULA(WEIGHTED);

/* Before the weight, products of 2^17 and more are cut there: the product's half unit. 1 of 2. Unseen: hidden. */
#define BOUND_WEIGHTED_CUT SURE_UNIT

/* The distance to a light that is met: there |t D| is the norm of a difference of points, .87 U, cut to a unit, and
 * 2^-57 of t: 1.87 of 4. Unseen: small. */
#define BOUND_MET_UNITS (4 * SURE_UNIT)

/* By doubles none; 2^-57 there: .06 of 16 u. Unseen: small. */
#define BOUND_MET_ROUNDING P2M(49)

/* The error of t; eo is not needed, as the points are on the same ray. Unseen: hidden. */
FORMULA(MET_DISTANCE);

/* The error of the direction, and COSINE. Unseen: hidden. */
FORMULA(MET_COSINE);

/* The cosine to the viewer, by the error of the cosine; there half a unit: 1 of 4. Unseen: hidden. */
FORMULA(FACING_LIGHT);

/* Derived with FACING_LIGHT. Unseen: small. */
#define BOUND_FACING_UNITS (2 * SURE_UNIT)

#endif
