/* shapes.h - bounds of intersections: sphere_tmpl.h, flat_tmpl.h, triangle_tmpl.h, box_tmpl.h, grid_tmpl.h,
 * grid_ray_tmpl.h, slabs_tmpl.h, pairs_tmpl.h, instance_tmpl.h. */
#ifndef TIA_SIMD_RAYS_BOUNDS_SHAPES_H
#define TIA_SIMD_RAYS_BOUNDS_SHAPES_H

/* ---- several shapes ---- */

/* The rounding of a point O + t D or P + b G there: half a unit in each coordinate, sqrt 3/2 U together, .87 of 2;
 * where a norm that is cut to a unit is compared, or a distance that is rounded by half a unit, 1.87 of 2. Unseen:
 * small. */
#define BOUND_POINT_UNITS (2 * SURE_UNIT)

/* The rounding of a point O + t D or P + b G there, where nothing else is rounded: .87 of 1. Unseen: small. */
#define BOUND_POINT_UNIT SURE_UNIT

/* The rounding of a length there: half a unit of a dot product of lengths or of a distance; a norm is cut to a whole
 * unit. Unseen: small. */
#define BOUND_LENGTH_UNIT SURE_UNIT

/* The rounding of P + b G by doubles, of |x|1, x being the sum: the product u b, the sum u of the point. 2 of 4 u; the
 * point's own roundings are in its own bound. Also the rounding of A - P, of |A - P|1 and |P|1: A is converted, which
 * is u of both, and the difference is rounded. Unseen: small. */
#define BOUND_POINT_ROUNDING P2M(51)

/* The error of a point O + t D: eo, the error of t, t ed, and the point's rounding there. */
FORMULA(POINT);

/* ---- spheres, see sphere_tmpl.h ---- */

/* The rounding of tca = L.D, of |L|1. Proved: rays_forms.g (tca). Unseen: small. */
#define BOUND_SPHERE_ALONG (SURE_ALONG * SURE_EPS)

/* The rounding of P = L - (L.D) D, of |L|1. Proved: rays_forms.g (aside + along). Unseen: small. */
#define BOUND_SPHERE_ASIDE (SURE_ASIDE * SURE_EPS)

/* The rounding of s = r^2 - |P|^2, of r^2. Proved: rays_sphere.g. Unseen: small. */
#define BOUND_SPHERE_SQUARE_ROUNDING (SURE_SQUARE * SURE_EPS)

/* The rounding of P across the ray there: half a unit in each coordinate of tca D, .87 of 1; the half unit of tca
 * itself moves P along D. */
#define BOUND_SPHERE_ASIDE_UNIT SURE_UNIT

/* The rounding of P in any direction there: SPHERE_ASIDE_UNIT, and half a unit of tca along D. 1.37 of 2. Unseen:
 * small. */
#define BOUND_SPHERE_ANY_UNITS (2 * SURE_UNIT)

/* The rounding of thc by doubles, of r, as thc <= r: u of thc for the root, and u of thc when tca - thc is rounded.
 * What tca adds to the latter is in SPHERE_ALONG, 8 u of |L|1. 2 of 4 u. Unseen: small. */
#define BOUND_SPHERE_ROOT (4 * SURE_EPS)

/* The rounding of thc there: the exact root is cut to a unit. Unseen: small. */
#define BOUND_SPHERE_ROOT_UNIT SURE_UNIT

/* The rounding of tca there: half a unit. 1 of 2. Unseen: small. */
#define BOUND_SPHERE_ALONG_UNIT SURE_UNIT

/* lambda, the error of P across the ray: eo, |tca| ed as D turns, SPHERE_ASIDE and SPHERE_ASIDE_UNIT. */
FORMULA(SPHERE_ACROSS);

/* `all`, the error of P in any direction: eo; |tca| ed across the ray and |L| ed along D, where |tca| <= |L|;
 * SPHERE_ASIDE and SPHERE_ANY_UNITS. */
FORMULA(SPHERE_ANY);

/* The error of s = r^2 - |P|^2: |P|^2 - |P'|^2 = 2 P.(P - P') - |P - P'|^2, where P is at right angles to D, so that
 * only the part of P - P' across the ray counts in 2 P.(P - P'). |P| <= r, or the ray is undecided anyway. */
FORMULA(SPHERE_SQUARE);

/* The error of thc = sqrt s: |sqrt a - sqrt b| <= |a - b|/sqrt a, a - b being the error of s, with |P| at most `aside`;
 * SPHERE_ROOT_UNIT and SPHERE_ROOT. */
FORMULA(SPHERE_HALF_CHORD);

/* The error of the point along the ray, and a part of that of t: |P| ed as D turns, |P - P'| ed in second order, and
 * the error of thc. */
FORMULA(SPHERE_POINT_ALONG);

/* The error of the point -(P + thc D) across the ray: lambda, which is P's, and thc ed. */
FORMULA(SPHERE_POINT_ACROSS);

/* The error of t = tca - thc: eo, by which tca moves, the roundings of tca, and SPHERE_POINT_ALONG. */
FORMULA(SPHERE_DISTANCE);

/* The error of the point: the hypotenuse of SPHERE_POINT_ALONG and SPHERE_POINT_ACROSS, which are at right angles, and
 * POINT_UNITS. */
FORMULA(SPHERE_POINT);

/* ---- planes, see flat_tmpl.h ---- */

/* The roundings of (P - O).N, of |P - O|1, and of D.N, of 1. Proved: rays_forms.g (way). Unseen: small. */
#define BOUND_PLANE_WAY (SURE_WAY * SURE_EPS)

/* The error of D.N: ed, as |N| is 1, and PLANE_WAY. */
FORMULA(PLANE_SLOPE);

/* The least |D.N|, less its error, of rays that are decided; flatter ones are undecided. A choice, not an error:
 * fixed-point rays are parallel below 2^-42, and the quotient's bound needs no more than a slope above its own. Unseen:
 * choice. */
#define BOUND_PLANE_STEEP P2M(20)

/* The rounding of the height (P - O).N there: half a unit; that of a face's height, see TRIANGLE_AHEAD, 1.3 units. 1.3
 * of 2. */
#define BOUND_PLANE_HEIGHT_UNITS (2 * SURE_UNIT)

/* The rounding of the height (P - O).N of a plane that may be behind the origin: PLANE_HEIGHT_UNITS, and as many again,
 * since fixed-point quotients below half a unit are rounded to 0, so that a plane 2^-46 behind the origin may be met at
 * 0. 1.3 of 4. Unseen: small. */
#define BOUND_PLANE_BEHIND_UNITS (4 * SURE_UNIT)

/* The error of t = h/s, h = (P - O).N being the height and s = D.N the slope: |h/s - h'/s'| <= (|h - h'| + |t| |s -
 * s'|)/(|s| - es), where h moves by eo and its roundings. */
FORMULA(PLANE_DISTANCE);

/* The error of the height N.(P - O): where the height is above this error a ray that rises is certainly past the plane.
 * eo and the roundings. */
FORMULA(PLANE_BEHIND);

/* The error of the largest coordinate of a plane's point: the error of t, t ed, and eo; for roundings 1 is left on
 * either side of the limit. */
FORMULA(PLANE_FAR);

/* The error of a plane's point, which is that of t. O' + t' D' is O + t D, moved by a, |a| <= eo + t ed, and slid along
 * D' back into the plane: no farther than |a|/|D'.N|, which is part of the error of t. Off the plane the point is by
 * its roundings. */
FORMULA(PLANE_POINT);

/* The error of the point from the centre, O + t D - C: the error of t, t ed and eo, as |D| = 1; POINT_UNITS and
 * DISC_PLACE_ROUNDING. */
FORMULA(DISC_PLACE);

/* The rounding of t D - (C - O) by doubles: a product and a difference, u each of |C - O|1 and |t|, and the roundings
 * of the difference C - O and of its conversion. 4 of 8 u. Unseen: small. */
#define BOUND_DISC_PLACE_ROUNDING P2M(50)

/* The roundings of the squares that are compared: |x|^2 has a product and two sums, (r - e)^2 a difference and a
 * product. 5 of 32 u. Unseen: small. */
#define BOUND_DISC_SQUARE P2M(48)

/* The rounding of (t D - (C - O)).a by doubles, a being an axis across a side: DISC_PLACE_ROUNDING's, and a dot
 * product's: 8 of 16 u. Unseen: small. */
#define BOUND_RECTANGLE_PLACE_ROUNDING P2M(49)

/* The error of (O + t D - C).a, a being an axis across a side: that of DISC_PLACE, as these axes are no longer than 1.
 * There: the point .87 U, its dot product and the side half a unit each, 1.87 of the 2 of POINT_UNITS. */
FORMULA(RECTANGLE_PLACE);

/* ---- triangles, see triangle_tmpl.h ---- */

/* The rounding of an area D.(a x b), of far^2, far being |x| + |y| + |z| of the origin and the most of a corner.
 * Proved: rays_forms.g (area). Unseen: small. */
#define BOUND_TRIANGLE_AREA (SURE_FACE * SURE_EPS)

/* The error of an area there, of far. Fixed-point corners are aside by 2^-46 + 2^-59 z, z < 2 far, in each of two
 * coordinates; areas of coordinates below 2 far are off by 2 (2 far) twice that: far 8 2^-46 = far 2^-43, and 2^-55
 * far^2, a fourth of u of far^2: TRIANGLE_AREA has 16 u, of which 9 are the doubles'. 1 of 2. Unseen: small. */
#define BOUND_TRIANGLE_CORNERS P2M(42)

/* far, the largest distance of a corner: the origin's |x| + |y| + |z| from the centre, the most of a corner's, and the
 * error of the origin. */
FORMULA(TRIANGLE_FAR);

/* The roundings of an area: far 2^-42 of the corners there, and far^2 16 u. Unseen: small. */
FORMULA(TRIANGLE_ROUNDINGS);

/* The error of an area, divided by the face's extent: D.(a x (b - a)) moves by |b - a| eo and, as D turns, by |a| |b -
 * a| ed; |b - a| is twice the extent at most. */
FORMULA(TRIANGLE_EDGE);

/* The error of an area of this face: TRIANGLE_ROUNDINGS, and TRIANGLE_EDGE times the face's extent. */
FORMULA(TRIANGLE_SIDE);

/* The rounding of a face's height over the origin, of l, |a|1 and the extent. There: the height of a corner that is
 * aside by 2^-46 + 2^-59 z in two coordinates, sqrt 2 of each: .71 U, in PLANE_HEIGHT_UNITS, and l 2^-58.5; by doubles:
 * l 16 u, as PLANE_WAY has it. The mean of the corners' z has parts that add up to 1, so that they leave it in the
 * plane. 16.4 u of 32. Unseen: small. */
#define BOUND_TRIANGLE_AHEAD P2M(48)

/* The rounding of t there: half a unit of the mean of z, over a main component of .577 or more, and half a unit of the
 * quotient: 1.4 of 4. Unseen: small. */
#define BOUND_TRIANGLE_UNITS (4 * SURE_UNIT)

/* The rounding of t, of l, as |t| <= l. By doubles: u; there: 2^-59, and 2^-59 of z for the parts. 1.1 of 8 u. Unseen:
 * small. */
#define BOUND_TRIANGLE_QUOTIENT P2M(50)

/* The error there of a returning ray's height over its own face: corners were aside by 2^-46 + 2^-59 z, z < 2^17, in
 * two coordinates: 2^-41.4; t by some units, eight with the point's roundings, 2^-42; b G by one. Together < 2^-40.
 * Unseen: small. */
#define BOUND_TRIANGLE_RETURN P2M(40)

/* The error of t where a ray returns to its face, from the height b, in which eo has no part: that of PLANE_DISTANCE
 * without eo, with TRIANGLE_RETURN. */
FORMULA(TRIANGLE_RETURN_DISTANCE);

/* The error of the point where a ray returns to its face: eo as well, the error of t, t ed, and POINT_UNITS. */
FORMULA(TRIANGLE_RETURN_POINT);

/* ---- pairs of faces in floats, see pairs_tmpl.h ---- */

/* The rounding of an area by floats, of (R + |M|) c: 25 of 2^-24, as pairs_tmpl.h counts. Proved: rays_pairs.g. */
#define BOUND_PAIR_AREA (SURE_PAIR * P2M(24))

/* The error l.each times a face's extent, divided by c, the pair's `size`: the extent is 3 c at most, as c is no less
 * than the largest coordinate of any edge. */
FORMULA(PAIR_EDGE);

/* The roundings of the bound off + by c in floats: two conversions, a product and a sum, 4 of 2^-24. Half of 2^-21.
 * Unseen: small. */
#define BOUND_PAIR_ROUNDING P2M(21)

/* ---- boxes, see box_tmpl.h ---- */

/* The rounding of t = (plane - O) (1/D), of |t|. Proved: rays_forms.g (slab), 3 of 4 u. Unseen: small. */
#define BOUND_SLAB (SURE_SLAB * SURE_EPS)

/* The rounding of plane - O by doubles, of |plane| and |O|: a difference, u of both; a plane is a multiple of 2^-16 and
 * exact. 1 of 4 u. Unseen: small. */
#define BOUND_SLAB_PLANE (4 * SURE_EPS)

/* The rounding of a place there: fixed-point rays that have left a slab by t are located by t d, which is rounded by
 * half a unit. 1 of 4. Unseen: small. */
#define BOUND_SLAB_UNITS (2 * SURE_UNIT)

/* The component of the direction, besides SLAB_TURN times its error, below which a ray is nearly level: times across
 * the axis are undecided. A choice; |d| - ed is otherwise 63/64 |d| at least. Unseen: choice. */
#define BOUND_SLAB_STEEP P2M(24)

/* The number of times that a component of the direction must exceed its error. Chosen together with SLAB_STEEP. */
#define BOUND_SLAB_TURN 64

/* The error of the time t of a plane: (eo + roundings + |t| (ed + 4 u))/(|d| - ed), a quotient's, as in PLANE_DISTANCE.
 */
FORMULA(SLAB_TIME);

/* The largest move of a level ray across the slab, anywhere up to the box's far end: eo, reach (ed + |d|), and the
 * roundings of the planes. */
FORMULA(SLAB_LEVEL);

/* ---- boxes of the hierarchy in floats, see slabs_tmpl.h ---- */

/* The least component of a direction; smaller ones are replaced by this. That is a turn that moves a ray by 2^17 2^-60
 * = 2^-43, which is less than the roundings of `pad` where anything reaches 2^-22; boxes do, by their margin of 2^-16.
 * Unseen: choice. */
#define BOUND_SLABS_TINY P2M(60)

/* The distance between the certified ray and the fixed-point ray, anywhere in the scene's box: eo, and ed times
 * `reach`, |O - centre|1 + extent. */
FORMULA(SLABS_APART);

/* The roundings of the planes' distances in floats: 8 of 2^-24 of |o| + reach, as slabs_tmpl.h counts: below 2^-21 of
 * |o| + reach. */
#define BOUND_SLABS_FLOATS P2M(21)

/* The largest margin SLABS_APART, as a part of the extent: a ray with a wider one would enter nearly every box. A
 * choice: 2^-9 of the scene, and of 2^-10 more where it has no extent. */
#define BOUND_SLABS_WIDE P2M(9)

/* The length that is added to the scene's extent for the largest margin. Chosen together with SLABS_WIDE. */
#define BOUND_SLABS_LEAST P2M(10)

/* The rounding of a limit to a float: 2^-24 of the limit. 1 of 4. Unseen: small. */
#define BOUND_SLABS_LIMIT P2M(22)

/* ---- grids, see grid_tmpl.h and grid_ray_tmpl.h ---- */

/* The rounding of a plane's distance, corner + edge n - O, by doubles: a product, of numbers of 2^-16 and a count that
 * fit, a sum and a difference; in grid_tmpl.h, of A and plane B: 3 u each with the inverse, of which two are of t. 3 of
 * 4 u. Unseen: small. */
#define BOUND_GRID_PLANE (4 * SURE_EPS)

/* As SLAB_UNITS, the rounding of a place by t d there. Unseen: small. */
#define BOUND_GRID_UNITS (2 * SURE_UNIT)

/* The rounding of the time t of a plane, of |t|: the inverse of d, the product with this inverse, and in grid_tmpl.h
 * the sum A + plane B. 3 of 4 u. Unseen: small. */
#define BOUND_GRID_TIME (4 * SURE_EPS)

/* As SLAB_STEEP, the component of the direction below which a ray is nearly level. Unseen: choice. */
#define BOUND_GRID_STEEP P2M(24)

/* The number of times that a component of the direction must exceed its error. Chosen together with GRID_STEEP. */
#define BOUND_GRID_TURN 64

/* The part of a time's error that does not grow with the time: (eo + roundings)/(|d| - ed), and half a unit there. */
FORMULA(GRID_BASE);

/* The part of a time's error that grows with the time: (ed + 4 u)/(|d| - ed). */
FORMULA(GRID_SLOPE);

/* The rounding of a cell's number (place - corner)/edge in grid_tmpl.h, of that number: a difference, an inverse and a
 * product. 3 of 16 u. Unseen: small. */
#define BOUND_GRID_CELL P2M(49)

/* The rounding of a cell's number (place - corner)/edge in grid_ray_tmpl.h: a difference and a quotient. 2 of 8 u.
 * Unseen: small. */
#define BOUND_GRID_RAY_CELL P2M(50)

/* The error of the place O + at D where a ray enters the grid: eo, at ed, and the error of `at`. */
FORMULA(GRID_PLACE);

/* The rounding of a place o + at d by doubles, of |o| and at: u of at, u of the sum, and u when the corner is
 * subtracted. 3 of 8 u. Unseen: small. */
#define BOUND_GRID_PLACE_ROUNDING (8 * SURE_EPS)

/* The largest move of a level ray across the axis, anywhere in the grid: eo, and reach (ed + |d|). */
FORMULA(GRID_LEVEL);

/* The rounding of the place where a ray enters there: half a unit of t d, as also of the times by which cells are
 * found. 1 of 4. Unseen: small. */
#define BOUND_GRID_PLACE_UNITS (2 * SURE_UNIT)

/* The rounding of the place of a level ray there: half a unit, as in GRID_PLACE_UNITS, 1 of 8. Unseen: small. */
#define BOUND_GRID_LEVEL_UNITS (4 * SURE_UNIT)

/* The largest difference of the times of two planes whose order is undecided: twice the largest error of a time. */
FORMULA(GRID_ORDER);

/* ---- instances, see instance_tmpl.h ---- */

/* The rounding of v = O - p along the axes, of |v|1 and the box's size. By doubles: a difference, the axis, a product
 * and two sums: 5 u of |v|1 in each of three, sqrt 3 of that is 8.7 u. There: the ray that is moved to the box is
 * turned by 2^-57, which is 4 2^-59 of the box's distance. 8.8 u of 32. Unseen: small. */
#define BOUND_INSTANCE_ORIGIN (32 * SURE_EPS)

/* The rounding of v along the axes there: the moved point .87 U, its dot products half a unit each, .87 U. 1.73 of 4.
 * Unseen: small. */
#define BOUND_INSTANCE_UNITS (4 * SURE_UNIT)

/* The rounding there of the origin in the instance's axes, divided by the scales: half a unit in each of three, .87 of
 * 4; report_placed() adds as much again for the way back. Unseen: small. */
#define BOUND_INSTANCE_SCALED_UNITS (4 * SURE_UNIT)

/* The rounding of the division by the scales, of the origin in the instance's axes. By doubles: the inverse of the
 * scale and the product, 2 u; there: 2^-59. 2.1 of 8 u. Unseen: small. */
#define BOUND_INSTANCE_SCALED P2M(50)

/* The error of the origin in the instance's axes: that of v along them, over the least scale. */
FORMULA(INSTANCE_PLACE);

/* The rounding of a component (D.a_i)/s_i of the direction, times s_i. By doubles: the axis, a product, two sums, an
 * inverse and a product: 6 u in each of three, 10.4 of 16 u; there: half of v and 2^-57. Unseen: small. */
#define BOUND_INSTANCE_DIRECTION P2M(49)

/* The error of the direction in the instance's axes before it is normalised, and of its length k: ed and
 * INSTANCE_DIRECTION, over the least scale. */
FORMULA(INSTANCE_LENGTH);

/* The largest 1/(k - ek) in 1/k: 1.07, as k is known within a sixteenth. Proved: rays_forms.g (scaled). */
#define BOUND_INSTANCE_RATIO 1.07

/* The number of times that k must exceed its error. Chosen together with INSTANCE_RATIO. Unseen: choice. */
#define BOUND_INSTANCE_KNOWN 16

/* The error of the distance t/k in the world: |t/k - t'/k'| <= e/k + 1.07 (t + e) ek/k^2, see instance_tmpl.h; and the
 * roundings of t/k. */
FORMULA(INSTANCE_DISTANCE);

/* The rounding of t/k there: half a unit, and half a unit when `start` is subtracted; 1 of 2. Unseen: small. */
#define BOUND_INSTANCE_DISTANCE_UNITS (2 * SURE_UNIT)

/* The rounding of t/k. By doubles: an inverse and a product, 2 u; there: 2^-59. 2.1 of 8 u. Unseen: small. */
#define BOUND_INSTANCE_DISTANCE_ROUNDING P2M(50)

/* The largest part, in ek/k, by which `low` in the world may be less than low/k: 1/k' >= 1/(k + ek) >= (1 - ek/k)/k. 1
 * of 2. Unseen: small. */
#define BOUND_INSTANCE_LOW 2

/* The factor for the roundings of `limit` in the instance's axes, t (k + ek); the origin, which is eo off along the
 * ray, is added. A larger limit would do as well: hits behind a limit do not count, and testing them only takes time.
 */
#define BOUND_INSTANCE_LIMIT (1 + P2M(10))

/* The length that is added to `limit` in the instance's axes. Chosen together with INSTANCE_LIMIT. Unseen: choice. */
#define BOUND_INSTANCE_LIMIT_MORE P2M(20)

/* The error of the point in the world: the largest scale times its error in the instance's axes, where the roundings of
 * the origin are counted, .87 U of INSTANCE_SCALED_UNITS; eo; and, as the world's point is made of t alone, the
 * roundings once more: INSTANCE_POINT_UNITS, and those of t. */
FORMULA(INSTANCE_POINT);

/* The rounding of the point in the world there: .87 U, and 1 U of t. 1.87 of 4. Unseen: small. */
#define BOUND_INSTANCE_POINT_UNITS (4 * SURE_UNIT)

#endif
