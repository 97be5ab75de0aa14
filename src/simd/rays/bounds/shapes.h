/* shapes.h - bounds of intersections: sphere_tmpl.h, flat_tmpl.h, triangle_tmpl.h, box_tmpl.h, grid_tmpl.h,
 * grid_ray_tmpl.h, slabs_tmpl.h, pairs_tmpl.h, instance_tmpl.h. */
#ifndef TIA_SIMD_RAYS_BOUNDS_SHAPES_H
#define TIA_SIMD_RAYS_BOUNDS_SHAPES_H

/* ---- several shapes ---- */

/* A point O + t D or P + b G there: half a unit in each coordinate, sqrt 3/2 U together. .87 of 2; where a norm that is
 * cut to a unit is compared, or a distance that is rounded by half a one, 1.87 of 2. Unseen: small. */
#define BOUND_POINT_UNITS (2 * SURE_UNIT)

/* The same, where nothing else is rounded: .87 of 1. Unseen: small. */
#define BOUND_POINT_UNIT SURE_UNIT

/* A dot product of lengths, or a distance, there: half a unit; a norm is cut to a whole one. Unseen: small. */
#define BOUND_LENGTH_UNIT SURE_UNIT

/* P + b G by doubles: the product u b, the sum u of the point, as |x|1. 2 of 4 u; the point's own roundings are in its
 * own bound. So are A - P, of |A - P|1 and |P|1: A is converted, which is u of both, and the difference is rounded.
 * Unseen: small. */
#define BOUND_POINT_ROUNDING P2M(51)

/* A point that is within eo and goes on for t in a direction within ed. */
FORMULA(POINT);

/* ---- spheres, see sphere_tmpl.h ---- */

/* tca: |L|1. Proved: rays_forms.g (tca). Unseen: small. */
#define BOUND_SPHERE_ALONG (SURE_ALONG * SURE_EPS)

/* P = L - (L.D) D: |L|1. Proved: rays_forms.g (aside + along). Unseen: small. */
#define BOUND_SPHERE_ASIDE (SURE_ASIDE * SURE_EPS)

/* r^2 - |P|^2: r^2. Proved: rays_sphere.g. Unseen: small. */
#define BOUND_SPHERE_SQUARE_ROUNDING (SURE_SQUARE * SURE_EPS)

/* P across the ray there: half a unit in each coordinate of tca D, .87 of 1; tca's own half moves P along D. */
#define BOUND_SPHERE_ASIDE_UNIT SURE_UNIT

/* P anywhere there: SPHERE_ASIDE_UNIT, and half a unit of tca along D. 1.37 of 2. Unseen: small. */
#define BOUND_SPHERE_ANY_UNITS (2 * SURE_UNIT)

/* thc by doubles: the root u thc, and u of thc when tca - thc is rounded; thc <= r. What tca adds to that is in the 8 u
 * of |L|1. 2 of 4 u. Unseen: small. */
#define BOUND_SPHERE_ROOT (4 * SURE_EPS)

/* thc there is the exact root, cut to a unit. Unseen: small. */
#define BOUND_SPHERE_ROOT_UNIT SURE_UNIT

/* tca there: half a unit. 1 of 2. Unseen: small. */
#define BOUND_SPHERE_ALONG_UNIT SURE_UNIT

/* Across the ray P moves by eo and, D turning by ed, |tca| ed. */
FORMULA(SPHERE_ACROSS);

/* In any direction P moves by eo, |tca| ed and, along D, |L| ed: |tca| <= |L|. */
FORMULA(SPHERE_ANY);

/* |P|^2 - |P'|^2 = 2 P.(P - P') - |P - P'|^2; P is at right angles to D, so that of P - P' only the part across counts
 * in the first. |P| <= r, or the ray is undecided anyway. */
FORMULA(SPHERE_SQUARE);

/* |sqrt a - sqrt b| <= |a - b|/sqrt a; |P| is `aside` at most. */
FORMULA(SPHERE_HALF_CHORD);

/* The part of t from D's turning, |P| ed and in second order |P - P'| ed, and of thc. */
FORMULA(SPHERE_POINT_ALONG);

/* Across the ray the point -(P + thc D) moves by P's lambda and thc ed. */
FORMULA(SPHERE_POINT_ACROSS);

/* t = tca - thc: tca moves by eo, and the rest by SPHERE_POINT_ALONG. */
FORMULA(SPHERE_DISTANCE);

/* SPHERE_POINT_ALONG and SPHERE_POINT_ACROSS, which are at right angles. */
FORMULA(SPHERE_POINT);

/* ---- planes, see flat_tmpl.h ---- */

/* (P - O).N and D.N: |P - O|1, and 1. Proved: rays_forms.g (way). Unseen: small. */
#define BOUND_PLANE_WAY (SURE_WAY * SURE_EPS)

/* D.N: ed, as |N| is 1, and its roundings. */
FORMULA(PLANE_SLOPE);

/* Flatter rays are undecided. A choice, not an error: fixed-point rays are parallel below 2^-42, and the quotient's
 * bound needs no more than a slope above its own. Unseen: choice. */
#define BOUND_PLANE_STEEP P2M(20)

/* (P - O).N there: half a unit; a face's, see TRIANGLE_AHEAD, 1.3 units. 1.3 of 2. */
#define BOUND_PLANE_HEIGHT_UNITS (2 * SURE_UNIT)

/* PLANE_HEIGHT_UNITS, and as many again: fixed-point quotients below half a unit are rounded to 0, so that a plane
 * 2^-46 behind the origin may be met at 0. 1.3 of 4. Unseen: small. */
#define BOUND_PLANE_BEHIND_UNITS (4 * SURE_UNIT)

/* h/s - h'/s' <= (|h - h'| + |t| |s - s'|)/(|s| - es); h moves by eo. */
FORMULA(PLANE_DISTANCE);

/* The height N.(P - O) above which a ray that rises is certainly past the plane. */
FORMULA(PLANE_BEHIND);

/* The largest coordinate of a plane's point; 1 is left on either side for roundings. */
FORMULA(PLANE_FAR);

/* Two points of the plane: O' + t' D' is O + t D, moved by a, |a| <= eo + t ed, and slid along D' back into the plane:
 * no farther than |a|/|D'.N|, which is part of the error of t. Off the plane it is by its roundings. */
FORMULA(PLANE_POINT);

/* O + t D - C: the error of t, t ed and eo, as |D| = 1. */
FORMULA(DISC_PLACE);

/* t D - (C - O) by doubles: a product and a difference, u each of |C - O|1 and |t|, and what the difference C - O and
 * its conversion round. 4 of 8 u. Unseen: small. */
#define BOUND_DISC_PLACE_ROUNDING P2M(50)

/* Squares: |x|^2 has a product and two sums, (r - e)^2 a difference and a product. 5 of 32 u. Unseen: small. */
#define BOUND_DISC_SQUARE P2M(48)

/* The roundings of DISC_PLACE_ROUNDING, and a dot product with an axis across a side: 8 of 16 u. Unseen: small. */
#define BOUND_RECTANGLE_PLACE_ROUNDING P2M(49)

/* As DISC_PLACE: the axes across the sides are no longer than 1. There: the point .87 U, its dot product and the
 * side's half of one each, 1.87 of the 2 of POINT_UNITS. */
FORMULA(RECTANGLE_PLACE);

/* ---- triangles, see triangle_tmpl.h ---- */

/* An area's roundings: |x| + |y| + |z| of the origin and the most of a corner, squared. Proved: rays_forms.g (area).
 * Unseen: small. */
#define BOUND_TRIANGLE_AREA (SURE_FACE * SURE_EPS)

/* Fixed-point corners are aside by 2^-46 + 2^-59 z, z < 2 far, in each of two coordinates; areas of coordinates below
 * 2 far by 2 (2 far) twice that: far 8 2^-46 = far 2^-43, and 2^-55 far^2, a fourth of u of it: TRIANGLE_AREA has 16 u,
 * of which 9 are the doubles'. 1 of 2. Unseen: small. */
#define BOUND_TRIANGLE_CORNERS P2M(42)

/* The origin's |x| + |y| + |z| from the centre, the most of a corner's, and the error of the origin. */
FORMULA(TRIANGLE_FAR);

/* far 2^-42 and far^2 16 u. Unseen: small. */
FORMULA(TRIANGLE_ROUNDINGS);

/* D.(a x (b - a)) moves by |b - a| eo and, D turning, by |a| |b - a| ed; |b - a| is twice the extent at most. */
FORMULA(TRIANGLE_EDGE);

/* TRIANGLE_ROUNDINGS and TRIANGLE_EDGE, for this face's extent. */
FORMULA(TRIANGLE_SIDE);

/* The height of a corner that is aside by 2^-46 + 2^-59 z in two coordinates, sqrt 2 of each: .71 U, in
 * PLANE_HEIGHT_UNITS, and l 2^-58.5; doubles l 16 u as PLANE_WAY has it. The mean of the corners' z has parts that add
 * up to 1, so that they leave it in the plane. 16.4 u of 32. Unseen: small. */
#define BOUND_TRIANGLE_AHEAD P2M(48)

/* t there: half a unit of the mean of z, over a main component of .577 or more, and half of the quotient: 1.4 of 4.
 * Unseen: small. */
#define BOUND_TRIANGLE_UNITS (4 * SURE_UNIT)

/* t by doubles u, there 2^-59; |t| <= l. And the parts, 2^-59 of z. 1.1 of 8 u. Unseen: small. */
#define BOUND_TRIANGLE_QUOTIENT P2M(50)

/* The height over its own face that a ray comes from: corners were aside by 2^-46 + 2^-59 z, z < 2^17, in two
 * coordinates: 2^-41.4; t by some units, eight with the point's roundings, 2^-42; b G by one. Together < 2^-40. Unseen:
 * small. */
#define BOUND_TRIANGLE_RETURN P2M(40)

/* As PLANE_DISTANCE, from the height b, in which eo has no part. */
FORMULA(TRIANGLE_RETURN_DISTANCE);

/* The point of a ray that returns is moved by eo as well. */
FORMULA(TRIANGLE_RETURN_POINT);

/* ---- pairs of faces in floats, see pairs_tmpl.h ---- */

/* (R + |M|) c, by floats: 25 of 2^-24, as pairs_tmpl.h counts. Proved: rays_pairs.g. */
#define BOUND_PAIR_AREA (SURE_PAIR * P2M(24))

/* 3 l.each c, as a face's extent is 3 c at most: c is no less than the largest coordinate of any edge. */
FORMULA(PAIR_EDGE);

/* off + by c in floats: two conversions, a product and a sum, 4 of 2^-24. Half of 2^-21. Unseen: small. */
#define BOUND_PAIR_ROUNDING P2M(21)

/* ---- boxes, see box_tmpl.h ---- */

/* (plane - O) (1/D): |t|. Proved: rays_forms.g (slab), 3 of 4 u. Unseen: small. */
#define BOUND_SLAB (SURE_SLAB * SURE_EPS)

/* plane - O by doubles: a difference, u of both; a plane is of 2^-16 and exact. 1 of 4 u. Unseen: small. */
#define BOUND_SLAB_PLANE (4 * SURE_EPS)

/* Fixed-point rays that have left a slab by t are located by t d, which is rounded by half a unit. 1 of 4. Unseen:
 * small. */
#define BOUND_SLAB_UNITS (2 * SURE_UNIT)

/* A component of the direction below this, or 64 times its bound, is nearly level: times across it are undecided. A
 * choice; |d| - ed is then 63/64 |d| at least. Unseen: choice. */
#define BOUND_SLAB_STEEP P2M(24)
#define BOUND_SLAB_TURN 64 /* chosen together with SLAB_STEEP */

/* t: (eo + roundings + |t| (ed + 4 u))/(|d| - ed), a quotient's as PLANE_DISTANCE. */
FORMULA(SLAB_TIME);

/* The largest move of a level ray across the slab anywhere up to the box's far end. */
FORMULA(SLAB_LEVEL);

/* ---- boxes of the hierarchy in floats, see slabs_tmpl.h ---- */

/* Smaller components of directions are replaced by this: a turn that moves a ray by 2^17 2^-60 = 2^-43, which is less
 * than the roundings of `pad` where anything reaches 2^-22; boxes do, by their margin of 2^-16. Unseen: choice. */
#define BOUND_SLABS_TINY P2M(60)

/* The distance of two rays in the scene: eo, and ed times its reach. */
FORMULA(SLABS_APART);

/* Floats: 8 of 2^-24 of |o| + reach, as slabs_tmpl.h counts: below 2^-21 of it. */
#define BOUND_SLABS_FLOATS P2M(21)

/* A ray with a wider margin would enter nearly every box. A choice: 2^-9 of the scene, and of 2^-10 more where it has
 * no extent. */
#define BOUND_SLABS_WIDE P2M(9)
#define BOUND_SLABS_LEAST P2M(10) /* chosen together with SLABS_WIDE */

/* A limit, rounded to a float: 2^-24 of it. 1 of 4. Unseen: small. */
#define BOUND_SLABS_LIMIT P2M(22)

/* ---- grids, see grid_tmpl.h and grid_ray_tmpl.h ---- */

/* corner + edge n - O, by doubles: a product, of numbers of 2^-16 and a count that fit, a sum and a difference. In
 * grid_tmpl.h: A and plane B, 3 u each with the inverse, of which two are of t. 3 of 4 u. Unseen: small. */
#define BOUND_GRID_PLANE (4 * SURE_EPS)

/* As SLAB_UNITS. Unseen: small. */
#define BOUND_GRID_UNITS (2 * SURE_UNIT)

/* t: the inverse of d, the product with it and in grid_tmpl.h the sum A + plane B. 3 of 4 u. Unseen: small. */
#define BOUND_GRID_TIME (4 * SURE_EPS)

/* As SLAB_STEEP. Unseen: choice. */
#define BOUND_GRID_STEEP P2M(24)
#define BOUND_GRID_TURN 64 /* chosen together with GRID_STEEP */

/* The part of a time's bound that does not grow with it: (eo + roundings)/(|d| - ed), and half a unit there. */
FORMULA(GRID_BASE);

/* The part of a time's bound that grows with it: (ed + 4 u)/(|d| - ed). */
FORMULA(GRID_SLOPE);

/* The cell (place - corner)/edge: a difference, in grid_tmpl.h an inverse, and a product or quotient. 3 of 16 u.
 * Unseen: small. */
#define BOUND_GRID_CELL P2M(49)

/* The cell by a quotient: 2 of 8 u. Unseen: small. */
#define BOUND_GRID_RAY_CELL P2M(50)

/* The ray's entry: eo, at ed, and as far as `at` is off. */
FORMULA(GRID_PLACE);

/* o + at d by doubles: u at, u of the sum and u when the corner is subtracted, of |o| and at. 3 of 8 u. Unseen: small.
 */
#define BOUND_GRID_PLACE_ROUNDING (8 * SURE_EPS)

/* The largest move of a level ray across the axis anywhere in the grid. */
FORMULA(GRID_LEVEL);

/* A place there: t d is rounded by half a unit, and so are the times by which cells are found. 1 of 4; 1 of 8. Unseen:
 * small. */
#define BOUND_GRID_PLACE_UNITS (2 * SURE_UNIT)
#define BOUND_GRID_LEVEL_UNITS (4 * SURE_UNIT) /* derived with GRID_PLACE_UNITS. Unseen: small. */

/* Two planes are in order where their times are farther apart than both are off. */
FORMULA(GRID_ORDER);

/* ---- instances, see instance_tmpl.h ---- */

/* v = O - p along the axes: a difference, the axis, a product and two sums: 5 u of |v|1 in each of three, sqrt 3 of
 * that is 8.7 u. The ray that is moved to the box is turned by 2^-57 there, which is 4 2^-59 of the box's distance: 8.8
 * u of 32. Unseen: small. */
#define BOUND_INSTANCE_ORIGIN (32 * SURE_EPS)

/* There: the moved point .87 U, its dot products half of one each, .87. 1.73 of 4. Unseen: small. */
#define BOUND_INSTANCE_UNITS (4 * SURE_UNIT)

/* Divided by the scales: half a unit each, .87 of 4; report_placed() adds as much again for the way back. Unseen:
 * small. */
#define BOUND_INSTANCE_SCALED_UNITS (4 * SURE_UNIT)

/* The inverse of the scale and the product, 2 u, and 2^-59 there. 2.1 of 8 u. Unseen: small. */
#define BOUND_INSTANCE_SCALED P2M(50)

/* In the instance's axes the origin has the error of v, over the least scale. */
FORMULA(INSTANCE_PLACE);

/* (D.a_i)/s_i times s_i: the axis, a product, two sums, an inverse and a product: 6 u in each of three. 10.4 of 16 u.
 * There: half of v and 2^-57. Unseen: small. */
#define BOUND_INSTANCE_DIRECTION P2M(49)

/* The direction, and its length, over the least scale. */
FORMULA(INSTANCE_LENGTH);

/* k is known within a sixteenth of it, so that 1/(k - ek) is 1.07/k at most. Proved: rays_forms.g (scaled). */
#define BOUND_INSTANCE_RATIO 1.07
#define BOUND_INSTANCE_KNOWN 16 /* chosen together with INSTANCE_RATIO. Unseen: choice. */

/* |t/k - t'/k'| <= e/k + 1.07 (t + e) ek/k^2, see instance_tmpl.h. */
FORMULA(INSTANCE_DISTANCE);

/* t/k there: half a unit, and half of one when `start` is subtracted; 1 of 2. Unseen: small. */
#define BOUND_INSTANCE_DISTANCE_UNITS (2 * SURE_UNIT)

/* t/k by doubles: an inverse and a product, 2 u, and 2^-59 there. 2.1 of 8 u. Unseen: small. */
#define BOUND_INSTANCE_DISTANCE_ROUNDING P2M(50)

/* 1/k' >= 1/(k + ek) >= (1 - ek/k)/k: the part by which `low` may be less. 1 of 2. Unseen: small. */
#define BOUND_INSTANCE_LOW 2

/* `limit` in the instance's axes: t (k + ek), the roundings, and the origin, which is eo off along the ray. A larger
 * limit would do as well: hits behind a limit do not count, and testing them only takes time. */
#define BOUND_INSTANCE_LIMIT (1 + P2M(10))
#define BOUND_INSTANCE_LIMIT_MORE P2M(20) /* chosen together with INSTANCE_LIMIT. Unseen: choice. */

/* The point is off by the largest scale times as much as in the axes, where the roundings of the origin there are
 * counted, .87 U of INSTANCE_SCALED_UNITS, and again when the world's point is made of t alone; and by t's. */
FORMULA(INSTANCE_POINT);

/* The world's point there .87 U, t 1 U. 1.87 of 4. Unseen: small. */
#define BOUND_INSTANCE_POINT_UNITS (4 * SURE_UNIT)

#endif
