/* surfaces.h - bounds of a point that is met, its normal and its texture: surface_tmpl.h, texture_tmpl.h. */
#ifndef TIA_SIMD_RAYS_BOUNDS_SURFACES_H
#define TIA_SIMD_RAYS_BOUNDS_SURFACES_H

/* ---- points and normals, see surface_tmpl.h ---- */

/* O + t D by doubles: u of |t D|1 <= sqrt 3 t, and u of the sum. 3.5 of 4 u of |O|1 + t. Unseen: small. */
#define BOUND_SURFACE_POINT P2M(51)

/* P + b G: the error of the point, b times that of the normal, and the roundings. */
FORMULA(OUTSIDE);

/* b G: b times the error of the normal. */
FORMULA(OUTSIDE_NORMAL);

/* A sphere's normal: the error of the point, as the centre is exact, over the radius. */
FORMULA(ROUND_NORMAL);

/* A dot product of two directions: the errors of both, as both are 1 long. */
FORMULA(FACING);

/* The side of a surface on which the viewer is. */
FORMULA(SIDE);

/* A ray certainly leaves: D.G is above the errors of both. */
FORMULA(LEAVING);

/* A ray that goes straight on starts b behind the point along itself; see struct origin for these angles. Unseen:
 * choice. */
#define BOUND_LEAVING_STEEP P2M(2)
#define BOUND_LEAVING_FLAT P2M(6)  /* chosen together with LEAVING_STEEP. Unseen: choice. */
#define BOUND_LEAVING_BIAS P2M(20) /* chosen together with LEAVING_STEEP. Unseen: choice. */

/* A ray certainly comes back: D.G is below 0 by the errors of both. */
FORMULA(RETURNING);

/* Two mirrors: 2 dn |the part of D in the plane of the normals|, see mirrored_at(); and the error of D. */
FORMULA(MIRRORED);

/* 2 (N.V) N - V: the dot product 5 u, products and differences 3 u in each of three components, twice: 13 u; there
 * R/2 has three halves of v and is normalised. 13 of 128 u. Unseen: small. */
#define BOUND_MIRRORED_ROUNDING P2M(46)

/* P - p in an instance's axes, by doubles 8.7 u of |P - p|1 as INSTANCE_ORIGIN. 8.7 of 16 u. Unseen: small. */
#define BOUND_LOCAL_POINT (16 * SURE_EPS)

/* There the dot products have half a unit each, .87 of 2; over the scale, the quotients as much: .87 of 1. Unseen:
 * small. */
#define BOUND_LOCAL_UNITS (2 * SURE_UNIT)

/* As INSTANCE_SCALED: 2.1 of 8 u. Unseen: small. */
#define BOUND_LOCAL_SCALED P2M(50)

/* The error of the point in the world, LOCAL_POINT and LOCAL_UNITS. */
FORMULA(LOCAL_PLACE);

/* LOCAL_PLACE over the least scale. */
FORMULA(LOCAL_OVER_SCALE);

/* n_i/s_i by doubles: an inverse and a product, 2 u of n, over the least scale; there 2^-57. 2.1 of 8 u. Unseen: small.
 */
#define BOUND_WORLD_SCALED P2M(50)

/* The normal over the least scale, before it is normalised. */
FORMULA(WORLD_NORMAL);

/* m_x A + m_y B + m_z C: the axes, products and two sums, 4 u in each of three: 7 u. There it is normalised, doubles
 * leave it as long as the axes make it: 2 u. 9 of 32 u. Unseen: small. */
#define BOUND_WORLD_ROUNDING P2M(48)

/* A cylinder's part of the ray across the axis: a root of two squares of dot products of 4 u; 6 of 8 u. Unseen: small.
 */
#define BOUND_SIDE_ACROSS P2M(50)

/* The point across the axis, see side_normals(). */
FORMULA(SIDE_NORMAL);

/* 4 u of the point and 8 u of the way from the base, as side_normals() has it: 2 and 4. Unseen: small. */
#define BOUND_SIDE_POINT P2M(51)

/* The way's dot products there: half a unit each, .71 of 2. Unseen: small. */
#define BOUND_SIDE_UNITS (2 * SURE_UNIT)

/* a0 (x c) + a1 (y c) - axis s: axes, products and two sums, 5 u in each of three; there three halves of v and
 * normalised. 8.7 of 32 u. Unseen: small. */
#define BOUND_SIDE_ROUNDING P2M(48)

/* Areas of a face as seen along its main axis: the corners move by ep together, and an area by its edge times ep: by no
 * more than ew for the two areas at the first corner, twice that for the third. */
FORMULA(SMOOTH_AREA);

/* An area a d - b c by doubles: two differences, a product and a difference, 4 u of far^2, as |a| + |b| and |c| + |d|
 * are far at most; the sum of three, of sizes 2 far^2 together, 12 u of far^2, of which a part w <= 1 takes w. There
 * areas are exact. 16 of 16 u; the 32/31 that a
 * quotient by less than the sum takes is in what TRIANGLE_AHEAD has to spare, 15 u of the extent, which the point is
 * off by. Unseen: small. */
#define BOUND_SMOOTH_ROUNDING P2M(49)

/* A part by doubles: an inverse and a product; there the areas are cut to 62 bits, and the quotient is within 2^-59. 2
 * of 8 u. Unseen: small. */
#define BOUND_SMOOTH_PART P2M(50)

/* An area and the sum move by ew; so a part moves by ew over the sum. */
FORMULA(SMOOTH_SHARE);

/* Parts of less may be below 0 there: twice their errors. Unseen: small. */
FORMULA(SMOOTH_CLEAR);

/* The fixed-point code clamps negative weights to 0 and renormalises by 1 + N, N being the sum clamped away. The
 * certified ones are not below -ew, as the ray meets the face. So a part of which 0 is left changes by ew at most.
 * Another, w <= 1, moves by D and then changes by (D - N w)/(1 + N) in all. If only the first corner's is below 0, N is
 * at most ew and the two moves of the others, D among them, which leaves 2 ew; if only the other one's is, N is at most
 * 2 ew: 3 ew. If both are, it becomes 1 where it was 1 less the two, whose sum is between -2 ew and D. */
#define BOUND_SMOOTH_CUT 3

/* Known within 1/32 of the sum, so that its inverse is off by 32/31 of that: what the three roundings of parts and the
 * areas' 16 u leave. A choice. Unseen: choice. */
#define BOUND_SMOOTH_KNOWN 32

/* The parts' errors add up to 0, as their sum stays: the common part of the corners' normals does not count, only how
 * far those of the other two are from the first's, times their own parts' errors. */
FORMULA(SMOOTH_NORMAL);

/* The sum of three normals by their parts: the normal's conversion, two products, two sums: 6 u in each of three. 10.4
 * of 64 u. Unseen: small. */
#define BOUND_SMOOTH_SUM P2M(47)

/* ---- textures, see texture_tmpl.h ---- */

/* A point along an axis, v.a, by doubles: a difference, the axis, a product and two sums: 5 of 16 u of |v|1. Unseen:
 * small. */
#define BOUND_UV_ALONG P2M(49)

/* A point along an axis there: half a unit, 1 of 4. Unseen: small. */
#define BOUND_UV_ALONG_UNITS (2 * SURE_UNIT)

/* A coordinate of 0..1 there: a quotient's or an angle's half unit; 1 of 4. Of a sphere's second one it is twice an
 * angle's: 2 of 4. */
#define BOUND_UV_UNITS (2 * SURE_UNIT)

/* A quotient's or an angle's half unit alone. 1 of 2. */
#define BOUND_UV_UNIT SURE_UNIT

/* A coordinate of 0..1 by doubles: a sum, a scale and a product, or a quotient: 3 of 8 u. Unseen: small. */
#define BOUND_UV_ROUNDING P2M(50)

/* The errors of the point and its dot product, by the scale; a plane's is a power of two. */
FORMULA(UV_FLAT);

/* A box's faces: at, min and size are subtracted, 3 u of all; a grid's min is a product and a sum, 2 u more. 5 of 8 u.
 * There the differences are exact. Unseen: small. */
#define BOUND_UV_BOX_ROUNDING P2M(50)

/* The errors of the point and its roundings, over the least side. */
FORMULA(UV_BOX);

/* As SMOOTH_AREA; and SMOOTH_ROUNDING for its areas. */
FORMULA(UV_FACE_AREA);

/* Parts are known within a sixteenth; else the face is too small. A choice, as SMOOTH_KNOWN. Unseen: choice. */
#define BOUND_UV_FACE_KNOWN 16

/* Three times the errors of parts, as one may be cut to 0: see SMOOTH_CUT. */
FORMULA(UV_FACE);

/* The sum of three coordinates by parts: 1 - a - b has two differences, then a product and two sums: 5 of 16 u of the
 * given coordinates. Unseen: small. */
#define BOUND_UV_FACE_SUM P2M(49)

/* The errors of the parts, times the distances of the corners' coordinates. */
FORMULA(UV_MESH);

/* A fixed-point angle of a vector that is off by e: e over its length at most over 2 pi, .1592 asin x/x <= .1596 for x
 * < 1/16; the rest is for the bound's own roundings. */
#define BOUND_ANGLE_TURN 0.1875

/* tia_atan2: 60 steps that cut a unit of 2^-62 each from a vector of 3/4 of the length s: 2^-55.7 over 2 pi s, once
 * here and once there, of which BOUND_ANGLE_TURN has e/s with e of 2^-50 or more; its result by 2^-55, and u of the
 * components that it is given here. 1.3 of 8 u. Unseen: small. */
#define BOUND_ANGLE_ROUNDING P2M(50)

/* The turn of the vector, and the angle's rounding. */
FORMULA(ANGLE);

/* For x below 0 the angle jumps at y = 0: y is off by no more than the vector. */
FORMULA(ANGLE_SEAM);

/* Directions that are off by more than a sixteenth have no angle, nor have those below 2^-12: choices. Unseen: choice.
 */
#define BOUND_ANGLE_KNOWN 16
#define BOUND_ANGLE_LEAST P2M(12) /* chosen together with ANGLE_KNOWN. Unseen: choice. */

/* v/|v| for |v| known within a sixteenth, as UNIT_CHORD. */
#define BOUND_UV_CHORD 1.0625

/* v/|v| by doubles: the difference, a root and a quotient: 5 u; there 2^-58. 5 of 16 u. Unseen: small. */
#define BOUND_UV_SPHERE_ROUNDING P2M(49)

/* sqrt(x^2 + z^2) there, of at least 2^-12: halves of v in both squares and the root is cut: 2 v/2^-12 = 2^-49. By
 * doubles 3 u. 19 of 128 u. Unseen: small. */
#define BOUND_UV_POLE P2M(46)

/* The errors of both angles. */
FORMULA(UV_SPHERE);

/* The second coordinate is twice an angle. */
FORMULA(UV_SPHERE_HEIGHT);

/* The error of the way from the centre, over its length. */
FORMULA(UV_SPHERE_TURN);

/* The way from the base along the axes. */
FORMULA(UV_ROUND_PLACE);

/* A cap: the error of the place, over the diameter. */
FORMULA(UV_CAP);

/* v/|v| of two components by doubles: two squares, a sum, a root and a quotient, 3.5 u; 3.5 of 8 u. Unseen: small. */
#define BOUND_UV_ROUND_ROUNDING P2M(50)

/* The error of the way across the axis, over its length. */
FORMULA(UV_ROUND_TURN);

/* A side: the error of the height, over the length. */
FORMULA(UV_HEIGHT);

/* (uv - offset) repeat texels by doubles: a difference, two products and half a texel less: 4 of 8 u of both. Unseen:
 * small. */
#define BOUND_TEXEL_ROUNDING P2M(50)

/* There the part of a pattern is cut to a unit, times the texels: 1 of 8. Unseen: small. */
#define BOUND_TEXEL_UNITS P2M(42)

/* The errors of coordinates, in texels. */
FORMULA(TEXEL_PLACE);

/* A texel's colour there: a quotient and its product with the material's, half a unit each; by doubles 2 u. 1 of 2.
 * Unseen: small. */
#define BOUND_TEXEL_COLOUR P2M(44)

/* Bilinear: three differences of texels, whose product is rounded by half a unit of 1/255; the quotient and the product
 * with the material's colour, half of one each; by doubles 8 u. 1.04 of 8. Unseen: small. */
#define BOUND_TEXEL_BLEND P2M(42)

/* The error of the place: within a texel either way the colour is no steeper than from 0 to 1. */
FORMULA(TEXEL_BLEND_PLACE);

#endif
