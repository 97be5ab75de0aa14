/* surfaces.h - bounds of a point that is met, its normal and its texture: surface_tmpl.h, texture_tmpl.h. P is the
 * point, G the geometric and N the shading normal, V the direction to the viewer, D that of a new ray, and b the
 * distance from the surface at which new rays start. */
#ifndef TIA_SIMD_RAYS_BOUNDS_SURFACES_H
#define TIA_SIMD_RAYS_BOUNDS_SURFACES_H

/* ---- points and normals, see surface_tmpl.h ---- */

/* The rounding of the point O + t D in doubles, relative to |O|1 + t: u |t D|1 <= sqrt 3 u t for the product, and u for
 * the sum. Needed: 3.5 of 4 u. Unseen: small. */
#define BOUND_SURFACE_POINT P2M(51)

/* The error of a point P + b G off the surface: the error of P, OUTSIDE_NORMAL, and the roundings. */
FORMULA(OUTSIDE);

/* The error of b G: b times that of G. */
FORMULA(OUTSIDE_NORMAL);

/* The error of the vector from a sphere's centre to the point, whose direction is the normal: that of the point, as the
 * centre is exact. v3_unit() divides it by the radius. */
FORMULA(ROUND_NORMAL);

/* The error of N.V, the cosine to the viewer: the errors of N and V, which are 1 long, and COSINE. */
FORMULA(FACING);

/* The error of G.V, whose sign is the side of the surface on which the viewer is: the errors of G and V, and COSINE. */
FORMULA(SIDE);

/* The value of D.G above which a ray certainly leaves the surface: the errors of D and G, COSINE, and the least cosine
 * required. */
FORMULA(LEAVING);

/* The least cosine with which a ray that goes straight on certainly leaves the surface, if b is below LEAVING_BIAS.
 * Such a ray starts b behind the point along itself; see struct origin. Unseen: choice. */
#define BOUND_LEAVING_STEEP P2M(2)

/* The least cosine, as LEAVING_STEEP, if b is LEAVING_BIAS or more. Chosen together with LEAVING_STEEP. Unseen: choice.
 */
#define BOUND_LEAVING_FLAT P2M(6)

/* The least b with which LEAVING_FLAT replaces LEAVING_STEEP. Chosen together with LEAVING_STEEP. Unseen: choice. */
#define BOUND_LEAVING_BIAS P2M(20)

/* The amount by which D.G must be below 0 so that a ray certainly returns to the surface: the errors of D and G, and
 * COSINE. */
FORMULA(RETURNING);

/* The error of the mirrored direction. If N is off by dn, the mirrored direction is off by 2 dn times the part of V in
 * the plane of the two normals, see mirrored_at(). The error of V is added. */
FORMULA(MIRRORED);

/* The rounding of 2 (N.V) N - V. In doubles: 5 u for N.V, so 10 u for twice that; 2 u for its product with N, 1 u for
 * the difference. In fixed point: three halves of 2^-62, and half the result is normalised. Needed: 13 of 128 u.
 * Unseen: small. */
#define BOUND_MIRRORED_ROUNDING P2M(46)

/* The rounding of P - p along an instance's axes in doubles, relative to |P - p|1: 8.7 u, as in INSTANCE_ORIGIN.
 * Needed: 8.7 of 16 u. Unseen: small. */
#define BOUND_LOCAL_POINT (16 * SURE_EPS)

/* The rounding of P - p along an instance's axes in fixed point: half a unit in each of three dot products. Needed: .87
 * of 2 U. POINT_UNIT covers the quotients by the scales, which are rounded by as much. Unseen: small. */
#define BOUND_LOCAL_UNITS (2 * SURE_UNIT)

/* The rounding of the division by the scales, relative to the point in the instance's axes: 2.1 of 8 u, as in
 * INSTANCE_SCALED. Unseen: small. */
#define BOUND_LOCAL_SCALED P2M(50)

/* The error of P - p along an instance's axes: the error of the point in the world, LOCAL_POINT and LOCAL_UNITS. */
FORMULA(LOCAL_PLACE);

/* The error of the point in an instance's axes after the division by the scales: LOCAL_PLACE, divided by the least
 * scale. */
FORMULA(LOCAL_OVER_SCALE);

/* The rounding of n_i/s_i, before it is divided by the least scale. In doubles: 2 u for an inverse and a product. In
 * fixed point: 2^-57. Needed: 2.1 of 8 u. Unseen: small. */
#define BOUND_WORLD_SCALED P2M(50)

/* The error of the normal n_i/s_i before it is normalised: the error of n and WORLD_SCALED, divided by the least scale.
 */
FORMULA(WORLD_NORMAL);

/* The rounding of the normal m_x A + m_y B + m_z C in the world. In doubles: the axes, products and two sums, 4 u in
 * each of three components, 7 u together. The fixed-point code normalises the sum; doubles do not, and leave its length
 * off 1 by 2 u of the axes. Needed: 9 of 32 u. Unseen: small. */
#define BOUND_WORLD_ROUNDING P2M(48)

/* The rounding of the length of the ray's part across a cylinder's axis: 4 u of two dot products, and 2 u of the root
 * of their squares. Needed: 6 of 8 u. Unseen: small. */
#define BOUND_SIDE_ACROSS P2M(50)

/* The error of the point across the axis: `across` times the error of the point, see side_normals(). */
FORMULA(SIDE_NORMAL);

/* The rounding of the point across the axis in doubles: 2 of 4 u relative to the point, and 4 of 8 u relative to its
 * vector from the base, see side_normals(). Unseen: small. */
#define BOUND_SIDE_POINT P2M(51)

/* The rounding of the point across the axis in fixed point: half a unit in each of two dot products. Needed: .71 of 2
 * U. Unseen: small. */
#define BOUND_SIDE_UNITS (2 * SURE_UNIT)

/* The rounding of a side's normal a0 (x c) + a1 (y c) - axis s. In doubles: axes, products and two sums, 5 u in each of
 * three components. In fixed point: three halves of 2^-62, and the sum is normalised. Needed: 8.7 of 32 u. Unseen:
 * small. */
#define BOUND_SIDE_ROUNDING P2M(48)

/* ew without SMOOTH_ROUNDING, the error of a face's areas in the projection along its main axis. As the point is off by
 * ep, an area changes by ep times its edge: by at most ew for the two areas whose edge ends at the first corner, and by
 * twice that for the other. */
FORMULA(SMOOTH_AREA);

/* The rounding of a face's areas in doubles, relative to far^2; fixed-point areas are exact. An area a d - b c has two
 * differences, a product and a difference: 4 u far^2, as |a| + |b| and |c| + |d| are at most far. The sum of the three
 * areas has two roundings more, and its products add up to at most 2 far^2 in size: it is off by 12 u far^2, and a part
 * w <= 1 by w times as much. Needed: 16 of 16 u. A quotient by a sum that is too small may be larger by 32/31:
 * TRIANGLE_AHEAD covers that, as it adds 15 u of the extent more than needed to the error of the point. Unseen: small.
 */
#define BOUND_SMOOTH_ROUNDING P2M(49)

/* The rounding of a part, an area over the sum of the three. In doubles: 2 u for an inverse and a product. In fixed
 * point areas are truncated to 62 bits, and the quotient is within 2^-59. Needed: 2.1 of 8 u. Unseen: small. */
#define BOUND_SMOOTH_PART P2M(50)

/* The error of a part, an area over the sum of the three: ew over the sum, as the area is off by ew. The sum does not
 * depend on the point; its roundings are in ew. */
FORMULA(SMOOTH_SHARE);

/* The value above which a part is certainly not negative in fixed point: twice SMOOTH_SHARE, as the first corner's part
 * may be off by that. Unseen: small. */
FORMULA(SMOOTH_CLEAR);

/* The largest error of a part, in multiples of e = SMOOTH_SHARE + SMOOTH_PART, where the fixed-point code clamps
 * negative parts to 0 and divides the others by 1 + N, N being the sum clamped away. As the ray meets the face, no
 * certified part is below -e. A part that is clamped changes by at most e. Another part w <= 1, off by D before,
 * changes by (D - N w)/(1 + N). If only the first corner's part is clamped, N is at most e plus the errors of the two
 * others, one of which is D, so w changes by at most 2 e. If only the second or the third corner's part is clamped, N
 * is at most 2 e, and w changes by at most 3 e. If the first corner's part and one of these are clamped, w becomes 1;
 * before, it was 1 less the two parts, whose sum is between -2 e and D. */
#define BOUND_SMOOTH_CUT 3

/* The least sum of the areas, in multiples of ew. The sum is then within 1/32 and its inverse within 1/31, which
 * SMOOTH_ROUNDING takes into account. A choice. Unseen: choice. */
#define BOUND_SMOOTH_KNOWN 32

/* The error of the sum of the corners' normals, weighted by their parts, before it is normalised. The errors of the
 * parts add up to 0, so only the differences of the two other normals from the first corner's count, each times the
 * error of its part. */
FORMULA(SMOOTH_NORMAL);

/* The rounding of the weighted sum of three normals: a conversion, two products and two sums, 5 u in each of three
 * components. Needed: 8.7 of 64 u. Unseen: small. */
#define BOUND_SMOOTH_SUM P2M(47)

/* ---- textures, see texture_tmpl.h ---- */

/* The rounding of v.a, a point's coordinate along an axis, in doubles, relative to |v|1: a difference, the axis, a
 * product and two sums. Needed: 5 of 16 u. Unseen: small. */
#define BOUND_UV_ALONG P2M(49)

/* The rounding of v.a, a point's coordinate along an axis, in fixed point: half a unit. Needed: .5 of 2 U. Unseen:
 * small. */
#define BOUND_UV_ALONG_UNITS (2 * SURE_UNIT)

/* The rounding of a coordinate in 0..1 in fixed point: half a unit of a quotient or an angle. A sphere's second
 * coordinate has twice the rounding of an angle. Needed: 1 of 2 U. */
#define BOUND_UV_UNITS (2 * SURE_UNIT)

/* The rounding of a coordinate that is a single quotient, in fixed point: half a unit. Needed: .5 of 1 U. */
#define BOUND_UV_UNIT SURE_UNIT

/* The rounding of a coordinate in 0..1 in doubles: a sum, a scale and a product, or a quotient. Needed: 3 of 8 u.
 * Unseen: small. */
#define BOUND_UV_ROUNDING P2M(50)

/* The error of a plane's or a disc's coordinate: the errors of the point and of its dot product with an axis, times the
 * scale; a plane's scale is a power of two. */
FORMULA(UV_FLAT);

/* The rounding of a point relative to a box's corner in doubles, relative to |at|1, |min|1 and |size|1: 3 u for the
 * differences, and 2 u for a grid's min, a product and a sum. In fixed point the differences are exact. Needed: 5 of 8
 * u. Unseen: small. */
#define BOUND_UV_BOX_ROUNDING P2M(50)

/* The error of a coordinate on a box's face: the error of the point and its roundings, divided by the least side. */
FORMULA(UV_BOX);

/* The error of a face's area in the projection along its main axis, as SMOOTH_AREA; SMOOTH_ROUNDING is added for the
 * areas' roundings. */
FORMULA(UV_FACE_AREA);

/* The least sum of a face's areas, in multiples of their error. In smaller faces coordinates are undecided. A choice,
 * like SMOOTH_KNOWN. Unseen: choice. */
#define BOUND_UV_FACE_KNOWN 16

/* The error of a barycentric coordinate: three times that of a part, as another part may be clamped to 0, see
 * SMOOTH_CUT. */
FORMULA(UV_FACE);

/* The rounding of the weighted sum of three given coordinates, relative to the coordinates: two differences in 1 - a -
 * b, a product and two sums. Needed: 5 of 16 u. Unseen: small. */
#define BOUND_UV_FACE_SUM P2M(49)

/* The error of a mesh's own coordinates: the error of the parts, times the distances of the other corners' coordinates
 * from the first corner's. */
FORMULA(UV_MESH);

/* The factor of e/|v| in the error of the angle of v, divided by 2 pi, e being the error of v. It is .1592 asin x/x <=
 * .1596 for x = e/|v| < 1/16. The rest covers the roundings of the bound itself. */
#define BOUND_ANGLE_TURN 0.1875

/* The rounding of an angle, divided by 2 pi. tia_atan2's 60 steps truncate a vector of 3/4 of the length s by 2^-62
 * each. That is 2^-55.7/(2 pi s), in doubles and again in fixed point; the rest of ANGLE_TURN, times e/s, covers both,
 * as e is at least 2^-50. Apart from that the result is within 2^-55, and in doubles the components of the vector are
 * within u. Needed: 1.3 of 8 u. Unseen: small. */
#define BOUND_ANGLE_ROUNDING P2M(50)

/* The error of an angle, divided by 2 pi: ANGLE_TURN times e over the vector's length, and ANGLE_ROUNDING. */
FORMULA(ANGLE);

/* The largest |y| with which the angle of a vector with x < 0 may be on the other side of the jump at y = 0: e, as y is
 * off by no more than the vector is. */
FORMULA(ANGLE_SEAM);

/* The least length of a vector, in multiples of its error; otherwise its angle is undecided. A choice. Unseen: choice.
 */
#define BOUND_ANGLE_KNOWN 16

/* The least length of a vector whose angle is decided. Chosen together with ANGLE_KNOWN. Unseen: choice. */
#define BOUND_ANGLE_LEAST P2M(12)

/* The factor of e/|v| in the error of v/|v|, v having the error e < |v|/16: 1 + 2^-10, as UNIT_CHORD. The rest covers
 * the roundings of the bound itself. */
#define BOUND_UV_CHORD 1.0625

/* The rounding of v/|v|, v being the vector from a sphere's centre to the point. In doubles: 5 u for the difference, a
 * root and a quotient. In fixed point: 2^-58. Needed: 5.1 of 16 u. Unseen: small. */
#define BOUND_UV_SPHERE_ROUNDING P2M(49)

/* The rounding of sqrt(x^2 + z^2), which is at least 2^-12. In doubles: 3 u. In fixed point: half of 2^-62 in each
 * square, and a root truncated to 2^-62: at most 2 2^-62/2^-12 = 2^-49. Needed: 19 of 128 u. Unseen: small. */
#define BOUND_UV_POLE P2M(46)

/* The error of a sphere's coordinates: the errors of both angles, the second of them doubled, and UV_UNITS. */
FORMULA(UV_SPHERE);

/* The error of a sphere's second coordinate, which is twice an angle: twice the error of the angle. */
FORMULA(UV_SPHERE_HEIGHT);

/* The error of v/|v|, v being the vector from a sphere's centre to the point: UV_CHORD times the error of v over its
 * length, and UV_SPHERE_ROUNDING. */
FORMULA(UV_SPHERE_TURN);

/* The error of the vector from a cylinder's or a cone's base to the point, along the axes: the error of the point,
 * UV_ALONG and UV_ALONG_UNITS. */
FORMULA(UV_ROUND_PLACE);

/* The error of a coordinate on a cap: UV_ROUND_PLACE, divided by the diameter. */
FORMULA(UV_CAP);

/* The rounding of v/|v| in doubles, v having two components: two squares, a sum, a root and a quotient. Needed: 3.5 of
 * 8 u. Unseen: small. */
#define BOUND_UV_ROUND_ROUNDING P2M(50)

/* The error of v/|v|, v being the vector from the axis to the point: UV_CHORD times the error of v over its length, and
 * UV_ROUND_ROUNDING. */
FORMULA(UV_ROUND_TURN);

/* The error of the second coordinate on a side: the error of the height, divided by the shape's length. */
FORMULA(UV_HEIGHT);

/* The rounding in doubles of the position (uv - offset) repeat texels, relative to uv and offset: a difference, two
 * products, and the subtraction of half a texel. Needed: 4 of 8 u. Unseen: small. */
#define BOUND_TEXEL_ROUNDING P2M(50)

/* The rounding of the position in fixed point: the fraction of a pattern is truncated to a unit, which is multiplied by
 * the number of texels. Needed: 1 of 8 U. Unseen: small. */
#define BOUND_TEXEL_UNITS P2M(42)

/* The error of the position in texels: the error of the coordinates and TEXEL_ROUNDING, times repeat and texels. */
FORMULA(TEXEL_PLACE);

/* The rounding of a texel's colour. In doubles: 2 u. In fixed point: half a unit each for a quotient and for its
 * product with the material's colour. Needed: 1.01 of 2 U. Unseen: small. */
#define BOUND_TEXEL_COLOUR P2M(44)

/* The rounding of a bilinear colour. In doubles: 8 u. In fixed point: half a unit for a product of texels, which is
 * then divided by 255, and half a unit each for this quotient and for its product with the material's colour. Needed:
 * 1.04 of 8 U. Unseen: small. */
#define BOUND_TEXEL_BLEND P2M(42)

/* The error of a bilinear colour by that of the position: the sum of the errors of both coordinates, times the largest
 * difference between neighbours among the four texels. Where the position may lie among others, that is 1. */
FORMULA(TEXEL_BLEND_PLACE);

#endif
