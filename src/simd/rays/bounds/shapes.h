/* shapes.h - bounds of intersections: sphere_tmpl.h, flat_tmpl.h, triangle_tmpl.h, box_tmpl.h, grid_tmpl.h,
 * grid_ray_tmpl.h, slabs_tmpl.h, instance_tmpl.h. O and D are a ray's origin and direction, eo and ed their errors; a
 * prime marks a fixed-point value. */
#ifndef TIA_SIMD_RAYS_BOUNDS_SHAPES_H
#define TIA_SIMD_RAYS_BOUNDS_SHAPES_H

/* ---- several shapes ---- */

/* The rounding of a point O + t D or P + b G in fixed point: half a unit in each coordinate, sqrt 3/2 U together. A
 * distance that is computed from the point is rounded by half a unit more, and a norm is truncated to a unit. Needed:
 * .87 of 2 U for the point, 1.87 of 2 U with a norm. Unseen: small. */
#define BOUND_POINT_UNITS (2 * SURE_UNIT)

/* The rounding of a point O + t D or P + b G in fixed point, where nothing else is rounded. Needed: .87 of 1 U. Unseen:
 * small. */
#define BOUND_POINT_UNIT SURE_UNIT

/* The rounding of a length in fixed point: half a unit for a dot product or a distance; a norm is truncated to a unit.
 * Needed: 1 of 1 U. Unseen: small. */
#define BOUND_LENGTH_UNIT SURE_UNIT

/* The rounding of x = P + b G in doubles, relative to |x|1: u for the product and u for the sum; the roundings of P are
 * in its own bound. Also the rounding of A - P, relative to |A - P|1 and |P|1: u of both for the conversion of A, and u
 * for the difference. Needed: 2 of 4 u. Unseen: small. */
#define BOUND_POINT_ROUNDING P2M(51)

/* The error of a point O + t D: eo, the error of t, t ed, and the point's rounding in fixed point. */
FORMULA(POINT);

/* ---- spheres, see sphere_tmpl.h ---- */

/* The rounding of tca = L.D, relative to |L|1. Proved: rays_forms.g (tca). Unseen: small. */
#define BOUND_SPHERE_ALONG (SURE_ALONG * SURE_EPS)

/* The rounding of P = L - (L.D) D, relative to |L|1. Proved: rays_forms.g (aside + along). Unseen: small. */
#define BOUND_SPHERE_ASIDE (SURE_ASIDE * SURE_EPS)

/* The rounding of s = r^2 - |P|^2, relative to r^2. Proved: rays_sphere.g. Unseen: small. */
#define BOUND_SPHERE_SQUARE_ROUNDING (SURE_SQUARE * SURE_EPS)

/* The rounding of P across the ray in fixed point: half a unit in each coordinate of tca D. The half unit of tca itself
 * moves P along D. Needed: .87 of 1 U. */
#define BOUND_SPHERE_ASIDE_UNIT SURE_UNIT

/* The rounding of P in any direction in fixed point: SPHERE_ASIDE_UNIT, and half a unit of tca along D. Needed: 1.37 of
 * 2 U. Unseen: small. */
#define BOUND_SPHERE_ANY_UNITS (2 * SURE_UNIT)

/* The rounding of thc in doubles, relative to r >= thc: u for the root, and u for the share of thc in the rounding of
 * tca - thc. The share of tca is in SPHERE_ALONG. Needed: 2 of 4 u. Unseen: small. */
#define BOUND_SPHERE_ROOT (4 * SURE_EPS)

/* The rounding of thc in fixed point: the exact root is truncated to a unit. Needed: 1 of 1 U. Unseen: small. */
#define BOUND_SPHERE_ROOT_UNIT SURE_UNIT

/* The rounding of tca in fixed point: half a unit. Needed: .5 of 1 U. Unseen: small. */
#define BOUND_SPHERE_ALONG_UNIT SURE_UNIT

/* lambda, the error of P across the ray: eo, |tca| ed for the error of D, SPHERE_ASIDE and SPHERE_ASIDE_UNIT. */
FORMULA(SPHERE_ACROSS);

/* `all`, the error of P in any direction: eo; |tca| ed across the ray and |L| ed along D, where |tca| <= |L|;
 * SPHERE_ASIDE and SPHERE_ANY_UNITS. */
FORMULA(SPHERE_ANY);

/* The error of s = r^2 - |P|^2: |P|^2 - |P'|^2 = 2 P.(P - P') - |P - P'|^2. P is at right angles to D, so only the part
 * of P - P' across the ray, lambda, counts in 2 P.(P - P'). |P| <= r, or the ray is undecided anyway.
 * SPHERE_SQUARE_ROUNDING is added. */
FORMULA(SPHERE_SQUARE);

/* The error of thc = sqrt s, see root_error(), by the error of s with |P| at most `aside`; SPHERE_ROOT_UNIT and
 * SPHERE_ROOT. */
FORMULA(SPHERE_HALF_CHORD);

/* The error of the point along the ray, which is also a part of the error of t: |P| ed for the error of D, |P - P'| ed
 * in second order, and the error of thc. */
FORMULA(SPHERE_POINT_ALONG);

/* The error of the point -(P + thc D) across the ray: lambda for P, and thc ed. */
FORMULA(SPHERE_POINT_ACROSS);

/* The error of t = tca - thc: eo, by which tca changes, the roundings of tca, and SPHERE_POINT_ALONG. */
FORMULA(SPHERE_DISTANCE);

/* The error of the point: the root of the sum of the squares of SPHERE_POINT_ALONG and SPHERE_POINT_ACROSS, which are
 * at right angles, and POINT_UNITS. */
FORMULA(SPHERE_POINT);

/* ---- planes, see flat_tmpl.h ---- */

/* The rounding of (P - O).N, relative to |P - O|1, and of D.N. Proved: rays_forms.g (way). Unseen: small. */
#define BOUND_PLANE_WAY (SURE_WAY * SURE_EPS)

/* The error of D.N: ed, as |N| is 1, and PLANE_WAY. */
FORMULA(PLANE_SLOPE);

/* The least |D.N| less its error; rays that are closer to parallel with the plane are undecided. A choice: fixed-point
 * rays count as parallel only below 2^-42, and PLANE_DISTANCE holds wherever |D.N| exceeds its error. Unseen: choice.
 */
#define BOUND_PLANE_STEEP P2M(20)

/* The rounding of the height (P - O).N in fixed point: half a unit of a plane's, and 1.3 units of a face's, see
 * TRIANGLE_AHEAD. Needed: 1.3 of 2 U. */
#define BOUND_PLANE_HEIGHT_UNITS (2 * SURE_UNIT)

/* The rounding of the height (P - O).N of a plane that may be behind the origin: half a unit, and half a unit more,
 * since fixed-point quotients below half a unit are rounded to 0, so that a plane 2^-46 behind the origin may be met at
 * t = 0. Needed: 1 of 4 U. Unseen: small. */
#define BOUND_PLANE_BEHIND_UNITS (4 * SURE_UNIT)

/* The error of t = h/s, with the height h = (P - O).N and the slope s = D.N: |h/s - h'/s'| <= (|h - h'| + |t| |s -
 * s'|)/(|s| - es), es being the error of s. The error of h is eo and its roundings. */
FORMULA(PLANE_DISTANCE);

/* The error of the height h = (P - O).N: eo and the roundings. Where |h| exceeds this error, and D.N certainly has the
 * other sign, the plane is certainly behind the origin. */
FORMULA(PLANE_BEHIND);

/* The error of the largest coordinate of a plane's point: the error of t, t ed, and eo. The roundings are covered by a
 * margin of 1 on either side of the limit 2^16. */
FORMULA(PLANE_FAR);

/* The error of a plane's point: at most the error of t. The fixed-point ray passes O + t D at a distance |a| <= eo + t
 * ed. The projection of a along D' into the plane is no longer than |a|/|D'.N|, which is a part of the error of t. Off
 * the plane, the point is only rounded. */
FORMULA(PLANE_POINT);

/* The error of the point relative to the centre, O + t D - C: the error of t, as |D| = 1, t ed and eo; POINT_UNITS and
 * DISC_PLACE_ROUNDING. */
FORMULA(DISC_PLACE);

/* The rounding of t D - (C - O) in doubles, relative to |C - O|1 and |t|: u each for the product, the last difference,
 * the difference C - O and the conversion of C. Needed: 4 of 8 u. Unseen: small. */
#define BOUND_DISC_PLACE_ROUNDING P2M(50)

/* The rounding of the squares that are compared: 3 u for |x|^2, a product and two sums; 3 u for (r - e)^2, a difference
 * and a product; and u for the product with this factor. Needed: 7 of 32 u. Unseen: small. */
#define BOUND_DISC_SQUARE P2M(48)

/* The rounding of (t D - (C - O)).a in doubles, a being an axis across a side: 4 u as DISC_PLACE_ROUNDING, and 4 u for
 * the dot product. Needed: 8 of 16 u. Unseen: small. */
#define BOUND_RECTANGLE_PLACE_ROUNDING P2M(49)

/* The error of (O + t D - C).a, a being an axis across a side: as DISC_PLACE, since these axes are no longer than 1. In
 * fixed point the point is off by .87 U, and its dot product and the side by half a unit each: 1.87 of the 2 U of
 * POINT_UNITS. */
FORMULA(RECTANGLE_PLACE);

/* ---- triangles, see triangle_tmpl.h ---- */

/* The rounding of an area D.(a x b), relative to far^2, far being |x| + |y| + |z| of the origin and the largest
 * distance of a corner. Proved: rays_forms.g (area). Unseen: small. */
#define BOUND_TRIANGLE_AREA (SURE_FACE * SURE_EPS)

/* The error of a fixed-point area by its corners, relative to far. Each of two coordinates of a corner is off by e =
 * 2^-46 + 2^-59 z, z < 2 far. So an area of coordinates below 2 far is off by 8 far e: 2^-43 far, and 2^-55 far^2. The
 * latter is u/4 far^2, which TRIANGLE_AREA covers: it has 16 u, and doubles need 9. Needed: 2^-43 of 2^-42. Unseen:
 * small. */
#define BOUND_TRIANGLE_CORNERS P2M(42)

/* far, the largest distance of a corner from the origin: the origin's |x| + |y| + |z| from the centre, the largest
 * distance of a corner from the centre, and the error of the origin. */
FORMULA(TRIANGLE_FAR);

/* The rounding of an area: TRIANGLE_CORNERS, 2^-42 far, and TRIANGLE_AREA, 16 u far^2. Unseen: small. */
FORMULA(TRIANGLE_ROUNDINGS);

/* The error of an area, divided by the face's extent: D.(a x (b - a)) changes by |b - a| eo, and by |a| |b - a| ed for
 * the error of D; |b - a| is at most twice the extent. */
FORMULA(TRIANGLE_EDGE);

/* The error of an area of this face: TRIANGLE_ROUNDINGS, and TRIANGLE_EDGE times the face's extent. */
FORMULA(TRIANGLE_SIDE);

/* The rounding of a face's height over the origin, relative to l, the sum of |a|1 and the extent. In doubles: 16 u, as
 * PLANE_WAY. In fixed point two coordinates of a corner are off by 2^-46 + 2^-59 z. The height of a corner is off by
 * sqrt 2 times that: .71 U, which PLANE_HEIGHT_UNITS covers, and 2^-58.5 l. The weights of the three corners add up to
 * 1, so that errors of the weights leave the weighted mean in the plane. Needed: 16.4 of 32 u. Unseen: small. */
#define BOUND_TRIANGLE_AHEAD P2M(48)

/* The rounding of t in fixed point: half a unit of the mean of z, divided by D's main component of .577 or more, and
 * half a unit of the quotient. Needed: 1.4 of 4 U. Unseen: small. */
#define BOUND_TRIANGLE_UNITS (4 * SURE_UNIT)

/* The rounding of t, relative to l >= |t|. In doubles: u. In fixed point: 2^-59 of the quotient, and 2^-59 of z for the
 * weights. Needed: 1.1 of 8 u. Unseen: small. */
#define BOUND_TRIANGLE_QUOTIENT P2M(50)

/* The error of the fixed-point height from which a ray returns to its own face. The corners are off by 2^-46 + 2^-59 z,
 * z < 2^17, in two coordinates: 2^-41.4. The roundings of t and of the point are eight units, 2^-42; b G is rounded by
 * one unit. Together below 2^-40. Unseen: small. */
#define BOUND_TRIANGLE_RETURN P2M(40)

/* The error of t where a ray returns to its face from the height b: as PLANE_DISTANCE, but with TRIANGLE_RETURN in
 * place of eo, as b does not depend on the origin. */
FORMULA(TRIANGLE_RETURN_DISTANCE);

/* The error of the point where a ray returns to its face: eo, the error of t, t ed, and POINT_UNITS. */
FORMULA(TRIANGLE_RETURN_POINT);

/* ---- boxes, see box_tmpl.h ---- */

/* The rounding of t = (plane - O) (1/D), relative to |t|. Proved: rays_forms.g (slab), 3 of 4 u. Unseen: small. */
#define BOUND_SLAB (SURE_SLAB * SURE_EPS)

/* The rounding of plane - O in doubles, relative to |plane| and |O|: u for the difference; a plane is a multiple of
 * 2^-16 and exact. Needed: 1 of 4 u. Unseen: small. */
#define BOUND_SLAB_PLANE (4 * SURE_EPS)

/* The rounding of a coordinate in fixed point: is_left() of geometry/box.c compares t d, which is rounded by half a
 * unit. Needed: .5 of 2 U. Unseen: small. */
#define BOUND_SLAB_UNITS (2 * SURE_UNIT)

/* The amount by which a component of the direction must exceed SLAB_TURN times its error. Otherwise the ray is nearly
 * level, and times along this axis are undecided. A choice; |d| - ed is at least 63/64 |d| where times are decided.
 * Unseen: choice. */
#define BOUND_SLAB_STEEP P2M(24)

/* The least component of the direction, in multiples of its error. Chosen together with SLAB_STEEP. */
#define BOUND_SLAB_TURN 64

/* 1/(|d| - ed) in multiples of 1/|d|, as ed is below |d|/SLAB_TURN: 64/63, and 2 u for the quotient and the product.
 * Needed: 1.0159 of 1.016. Unseen: small. */
#define BOUND_SLAB_OVER 1.016

/* The error of the time t of a plane: (eo + roundings + |t| (ed + 4 u))/(|d| - ed), that of a quotient as in
 * PLANE_DISTANCE. */
FORMULA(SLAB_TIME);

/* The largest change of a level ray's coordinate along the axis as far as the box extends: eo, reach (ed + |d|), and
 * the roundings of the planes. */
FORMULA(SLAB_LEVEL);

/* ---- boxes of the hierarchy in floats, see slabs_tmpl.h ---- */

/* The least component of a direction; smaller ones are replaced by this. This turns the ray and moves it by 2^17 2^-60
 * = 2^-43 at most. SLABS_FLOATS is larger where |o| + reach is at least 2^-22, as it is for every box because of its
 * margin of 2^-16. Unseen: choice. */
#define BOUND_SLABS_TINY P2M(60)

/* The distance between the certified ray and the fixed-point ray anywhere in the scene's box: eo, and ed times `reach`,
 * |O - centre|1 + extent. */
FORMULA(SLABS_APART);

/* The rounding of the planes' distances in floats, relative to |o| + reach: 8 roundings of 2^-24, see slabs_tmpl.h. */
#define BOUND_SLABS_FLOATS P2M(21)

/* The largest SLABS_APART, relative to the scene's extent and SLABS_LEAST: a ray with a wider margin would enter nearly
 * every box, and is undecided instead. A choice. */
#define BOUND_SLABS_WIDE P2M(9)

/* The length that is added to the scene's extent for SLABS_WIDE, as the extent may be 0. Chosen together with
 * SLABS_WIDE. */
#define BOUND_SLABS_LEAST P2M(10)

/* The relative rounding of a limit to a float. Needed: 2^-24 of 2^-22. Unseen: small. */
#define BOUND_SLABS_LIMIT P2M(22)

/* ---- grids, see grid_tmpl.h and grid_ray_tmpl.h ---- */

/* The rounding in doubles of a plane's distance corner + edge n - O, relative to |corner|, the grid's size and |O|. In
 * grid_ray_tmpl.h: u for the difference, as edge n and its sum with the corner are exact. In grid_tmpl.h: 3 u each for
 * A = (corner - O)/d and plane B, B = edge/d. Needed: 3 of 4 u. Unseen: small. */
#define BOUND_GRID_PLANE (4 * SURE_EPS)

/* As SLAB_UNITS, the rounding of a coordinate by t d in fixed point. Unseen: small. */
#define BOUND_GRID_UNITS (2 * SURE_UNIT)

/* The rounding of the time t of a plane, relative to |t|: u each for the inverse of d, the product with it, and the sum
 * A + plane B in grid_tmpl.h. Needed: 3 of 4 u. Unseen: small. */
#define BOUND_GRID_TIME (4 * SURE_EPS)

/* As SLAB_STEEP, the amount by which a component of the direction must exceed GRID_TURN times its error. Unseen:
 * choice. */
#define BOUND_GRID_STEEP P2M(24)

/* The least component of the direction, in multiples of its error. Chosen together with GRID_STEEP. */
#define BOUND_GRID_TURN 64

/* As SLAB_OVER. Unseen: small. */
#define BOUND_GRID_OVER 1.016

/* The part of a time's error that does not grow with the time: (eo + roundings)/(|d| - ed), and half a unit in fixed
 * point. */
FORMULA(GRID_BASE);

/* The part of a time's error that grows with the time: (ed + 4 u)/(|d| - ed). */
FORMULA(GRID_SLOPE);

/* The relative rounding of a cell's number (place - corner)/edge in grid_tmpl.h: a difference, an inverse and a
 * product. Needed: 3 of 16 u. Unseen: small. */
#define BOUND_GRID_CELL P2M(49)

/* The relative rounding of a cell's number (place - corner)/edge in grid_ray_tmpl.h: a difference and a quotient.
 * Needed: 2 of 8 u. Unseen: small. */
#define BOUND_GRID_RAY_CELL P2M(50)

/* The error of the point O + t D where a ray enters the grid: eo, t ed, and the error of t. */
FORMULA(GRID_PLACE);

/* The rounding of a coordinate o + t d in doubles, relative to |o| and t: u for the product, u for the sum, and u when
 * the corner is subtracted. Needed: 3 of 8 u. Unseen: small. */
#define BOUND_GRID_PLACE_ROUNDING (8 * SURE_EPS)

/* The largest change of a level ray's coordinate along the axis anywhere in the grid: eo, and reach (ed + |d|). */
FORMULA(GRID_LEVEL);

/* The rounding, in fixed point, of the point where a ray enters: half a unit of t d, or of the times by which
 * find_cell() of geometry/grid.c corrects the cell. Needed: .5 of 2 U. Unseen: small. */
#define BOUND_GRID_PLACE_UNITS (2 * SURE_UNIT)

/* The rounding of a level ray's coordinate in fixed point: half a unit, as in GRID_PLACE_UNITS. Needed: .5 of 4 U.
 * Unseen: small. */
#define BOUND_GRID_LEVEL_UNITS (4 * SURE_UNIT)

/* The error of u = (t - A)/B, the number of a plane at the time t of another: both times may be off by the largest
 * error of a time, as in GRID_ORDER, over B. */
FORMULA(GRID_LEAP);

/* The rounding of u in doubles, relative to (|t| + |A|)/|B|: a difference, 2 u for the inverse of B, which is the
 * product of two rounded numbers, and a product. Needed: 5 of 16 u. Unseen: small. */
#define BOUND_GRID_LEAP_ROUNDING P2M(49)

/* The largest difference between the times of two planes whose order is undecided: twice the largest error of a time.
 */
FORMULA(GRID_ORDER);

/* ---- instances, see instance_tmpl.h ---- */

/* The rounding of v = O - p along the instance's axes, relative to |v|1 and the box's size. In doubles: a difference,
 * the axis, a product and two sums, 5 u in each of three coordinates, 8.7 u together. In fixed point the ray is moved
 * to the box, and its direction is then off by 2^-57, as if v were off by 2^-57 of the box's distance. Needed: 8.8 of
 * 32 u. Unseen: small. */
#define BOUND_INSTANCE_ORIGIN (32 * SURE_EPS)

/* The rounding of v along the instance's axes in fixed point: .87 U of the moved point, and .87 U of three dot
 * products. Needed: 1.73 of 4 U. Unseen: small. */
#define BOUND_INSTANCE_UNITS (4 * SURE_UNIT)

/* The rounding of the origin in the instance's axes in fixed point, after the division by the scales: half a unit in
 * each of three coordinates. Needed: .87 of 4 U. Unseen: small. */
#define BOUND_INSTANCE_SCALED_UNITS (4 * SURE_UNIT)

/* The rounding of the division by the scales, relative to the origin in the instance's axes. In doubles: 2 u for the
 * inverse of the scale and the product. In fixed point: 2^-59. Needed: 2.1 of 8 u. Unseen: small. */
#define BOUND_INSTANCE_SCALED P2M(50)

/* The error of the origin in the instance's axes: the error of v along them, divided by the least scale. */
FORMULA(INSTANCE_PLACE);

/* The rounding of a component (D.a_i)/s_i of the direction, times s_i. In doubles: the axis, a product, two sums, an
 * inverse and a product, 6 u in each of three components, 10.4 u together. In fixed point: half of 2^-62, and 2^-57.
 * Needed: 10.5 of 16 u. Unseen: small. */
#define BOUND_INSTANCE_DIRECTION P2M(49)

/* The error of the direction in the instance's axes before it is normalised, and of its length k: ed and
 * INSTANCE_DIRECTION, divided by the least scale. */
FORMULA(INSTANCE_LENGTH);

/* The largest k/(k - ek), k being above 16 ek. Proved: rays_forms.g (scaled). */
#define BOUND_INSTANCE_RATIO 1.07

/* The least length k, in multiples of its error ek. Chosen together with INSTANCE_RATIO. Unseen: choice. */
#define BOUND_INSTANCE_KNOWN 16

/* The error of the distance t/k in the world: |t/k - t'/k'| <= e/k + 1.07 (t + e) ek/k^2, e being the error of t, see
 * instance_tmpl.h; and the roundings of t/k. */
FORMULA(INSTANCE_DISTANCE);

/* The rounding of t/k in fixed point: half a unit, and half a unit when `start` is subtracted. Needed: 1 of 2 U.
 * Unseen: small. */
#define BOUND_INSTANCE_DISTANCE_UNITS (2 * SURE_UNIT)

/* The relative rounding of t/k. In doubles: 2 u for an inverse and a product. In fixed point: 2^-59. Needed: 2.1 of 8
 * u. Unseen: small. */
#define BOUND_INSTANCE_DISTANCE_ROUNDING P2M(50)

/* The factor of ek/k in the relative amount by which `low` in the world may be below low/k: 1/k' >= 1/(k + ek) >= (1 -
 * ek/k)/k. Needed: 1 of 2. Unseen: small. */
#define BOUND_INSTANCE_LOW 2

/* The factor for the roundings of `limit` in the instance's axes, t (k + ek), to which the origin's error is added. A
 * larger limit is correct too, as hits behind a limit do not count; testing them only takes time. */
#define BOUND_INSTANCE_LIMIT (1 + P2M(10))

/* The length that is added to `limit` in the instance's axes. Chosen together with INSTANCE_LIMIT. Unseen: choice. */
#define BOUND_INSTANCE_LIMIT_MORE P2M(20)

/* The error of the point in the world. It is the largest scale times the error of the point in the instance's axes,
 * which includes the .87 U of INSTANCE_SCALED_UNITS for the origin; eo; and, as the fixed-point code computes the
 * world's point from t alone, INSTANCE_POINT_UNITS and the roundings of t. */
FORMULA(INSTANCE_POINT);

/* The rounding of the point in the world in fixed point: .87 U of the point, and 1 U of t. Needed: 1.87 of 4 U. Unseen:
 * small. */
#define BOUND_INSTANCE_POINT_UNITS (4 * SURE_UNIT)

#endif
