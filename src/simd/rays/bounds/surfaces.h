/* surfaces.h - bounds of a point that is met, its normal and its texture: surface_tmpl.h, texture_tmpl.h. */
#ifndef TIA_SIMD_RAYS_BOUNDS_SURFACES_H
#define TIA_SIMD_RAYS_BOUNDS_SURFACES_H

/* ---- points and normals, see surface_tmpl.h ---- */

/* The rounding of the point O + t D by doubles, of |O|1 + t: u of |t D|1 <= sqrt 3 t, and u of the sum. 3.5 of 4 u.
 * Unseen: small. */
#define BOUND_SURFACE_POINT P2M(51)

/* The error of a point P + b G off the surface: that of P, OUTSIDE_NORMAL, and the roundings. */
FORMULA(OUTSIDE);

/* The error of b G: b times that of the normal G. */
FORMULA(OUTSIDE_NORMAL);

/* The error of the way from a sphere's centre to the point, whose direction is the normal: that of the point, as the
 * centre is exact. v3_unit() divides it by the radius. */
FORMULA(ROUND_NORMAL);

/* The error of N.V, the cosine to the viewer: the errors of both directions, as both are 1 long, and COSINE. */
FORMULA(FACING);

/* The error of G.V, whose sign is the side of the surface on which the viewer is: the errors of both directions, and
 * COSINE. */
FORMULA(SIDE);

/* The value above which D.G means that a ray certainly leaves the surface: the errors of D and G, COSINE, and the least
 * cosine required. */
FORMULA(LEAVING);

/* The least cosine with which a ray that goes straight on certainly leaves, where the bias is below LEAVING_BIAS: such
 * a ray starts b behind the point along itself; see struct origin for these angles. Unseen: choice. */
#define BOUND_LEAVING_STEEP P2M(2)

/* The least cosine, as LEAVING_STEEP, where the bias is LEAVING_BIAS or more. Chosen together with LEAVING_STEEP.
 * Unseen: choice. */
#define BOUND_LEAVING_FLAT P2M(6)

/* The bias below which LEAVING_STEEP is taken in place of LEAVING_FLAT. Chosen together with LEAVING_STEEP. Unseen:
 * choice. */
#define BOUND_LEAVING_BIAS P2M(20)

/* The value by which D.G must be below 0 so that a ray certainly returns to the surface: the errors of D and G, and
 * COSINE. */
FORMULA(RETURNING);

/* The error of the mirrored direction: 2 dn |the part of D in the plane of the normals| between two mirrors whose
 * normals differ by dn, see mirrored_at(); and the error of D. */
FORMULA(MIRRORED);

/* The rounding of 2 (N.V) N - V. By doubles: the dot product 5 u, products and differences 3 u in each of three
 * components, twice: 13 u; there R/2 has three halves of v and is normalised. 13 of 128 u. Unseen: small. */
#define BOUND_MIRRORED_ROUNDING P2M(46)

/* The rounding of P - p along an instance's axes by doubles, of |P - p|1: 8.7 u, as INSTANCE_ORIGIN has it. 8.7 of 16
 * u. Unseen: small. */
#define BOUND_LOCAL_POINT (16 * SURE_EPS)

/* The rounding of P - p along an instance's axes there: half a unit in each of three dot products, .87 of 2. The
 * quotients by the scales have as much, in POINT_UNIT: .87 of 1. Unseen: small. */
#define BOUND_LOCAL_UNITS (2 * SURE_UNIT)

/* The rounding of the division by the scales, of the point in the instance's axes: 2.1 of 8 u, as INSTANCE_SCALED has
 * it. Unseen: small. */
#define BOUND_LOCAL_SCALED P2M(50)

/* The error of P - p along an instance's axes: that of the point in the world, LOCAL_POINT and LOCAL_UNITS. */
FORMULA(LOCAL_PLACE);

/* The error of the point in an instance's axes, divided by the scales: LOCAL_PLACE over the least scale. */
FORMULA(LOCAL_OVER_SCALE);

/* The rounding of n_i/s_i, before it is divided by the least scale. By doubles: an inverse and a product, 2 u of n;
 * there: 2^-57. 2.1 of 8 u. Unseen: small. */
#define BOUND_WORLD_SCALED P2M(50)

/* The error of the normal n_i/s_i before it is normalised: that of n and WORLD_SCALED, over the least scale. */
FORMULA(WORLD_NORMAL);

/* The rounding of the normal m_x A + m_y B + m_z C in the world. By doubles: the axes, products and two sums, 4 u in
 * each of three components: 7 u; and it stays as long as the axes make it, 2 u, while it is normalised there. 9 of 32
 * u. Unseen: small. */
#define BOUND_WORLD_ROUNDING P2M(48)

/* The rounding of the length of the ray's part across a cylinder's axis: a root of two squares of dot products of 4 u;
 * 6 of 8 u. Unseen: small. */
#define BOUND_SIDE_ACROSS P2M(50)

/* The error of the point across the axis: `across` times that of the point, see side_normals(). */
FORMULA(SIDE_NORMAL);

/* The rounding of the point across the axis by doubles: 2 of 4 u of the point, and 4 of 8 u of the way from the base,
 * as side_normals() has it. Unseen: small. */
#define BOUND_SIDE_POINT P2M(51)

/* The rounding of the point across the axis there: half a unit in each of two dot products, .71 of 2. Unseen: small. */
#define BOUND_SIDE_UNITS (2 * SURE_UNIT)

/* The rounding of a side's normal a0 (x c) + a1 (y c) - axis s. By doubles: axes, products and two sums, 5 u in each of
 * three components; there three halves of v, and it is normalised. 8.7 of 32 u. Unseen: small. */
#define BOUND_SIDE_ROUNDING P2M(48)

/* The error of a face's areas as seen along its main axis, ew but for their roundings: the corners move by ep together,
 * and an area by its edge times ep: by no more than ew for the two areas at the first corner, twice that for the third.
 */
FORMULA(SMOOTH_AREA);

/* The rounding of a face's areas by doubles, of far^2: an area a d - b c has two differences, a product and a
 * difference, 4 u of far^2, as |a| + |b| and |c| + |d| are far at most; the sum of three, of sizes 2 far^2 together,
 * has 12 u of far^2, of which a part w <= 1 takes w. There areas are exact. 16 of 16 u; the 32/31 that a quotient by
 * less than the sum takes is in what TRIANGLE_AHEAD has to spare, 15 u of the extent, which the point is off by.
 * Unseen: small. */
#define BOUND_SMOOTH_ROUNDING P2M(49)

/* The rounding of a part, an area over the sum of the three. By doubles: an inverse and a product; there areas are cut
 * to 62 bits, and the quotient is within 2^-59. 2 of 8 u. Unseen: small. */
#define BOUND_SMOOTH_PART P2M(50)

/* The error of a part, an area over the sum: ew over the sum, as the area and the sum move by ew. */
FORMULA(SMOOTH_SHARE);

/* The least part that is certainly not below 0 there: twice the error of a part. Unseen: small. */
FORMULA(SMOOTH_CLEAR);

/* The largest change of a part, in ew, as the fixed-point code clamps negative weights to 0 and renormalises by 1 + N,
 * N being the sum clamped away. The certified parts are not below -ew, as the ray meets the face. So a part of which 0
 * is left changes by ew at most. Another, w <= 1, moves by D and then changes by (D - N w)/(1 + N) in all. If only the
 * first corner's part is below 0, N is at most ew and the two moves of the others, D among them, which leaves 2 ew; if
 * only the other one's is, N is at most 2 ew: 3 ew. If both are, w becomes 1 where it was 1 less the two, whose sum is
 * between -2 ew and D. */
#define BOUND_SMOOTH_CUT 3

/* The number of times that the sum of the areas must exceed ew: it is known within 1/32 then, so that its inverse is
 * off by 32/31 of that, what the three roundings of parts and the areas' 16 u leave. A choice. Unseen: choice. */
#define BOUND_SMOOTH_KNOWN 32

/* The error of the sum of the corners' normals by their parts, before it is normalised: the errors of parts add up to
 * 0, as the sum of parts stays, so that the common part of the normals does not count, only how far the other two
 * corners' normals are from the first's, times the errors of their own parts. */
FORMULA(SMOOTH_NORMAL);

/* The rounding of the sum of three normals by their parts: the normal's conversion, two products, two sums: 6 u in each
 * of three components. 10.4 of 64 u. Unseen: small. */
#define BOUND_SMOOTH_SUM P2M(47)

/* ---- textures, see texture_tmpl.h ---- */

/* The rounding of v.a, a point along an axis, by doubles, of |v|1: a difference, the axis, a product and two sums: 5 of
 * 16 u. Unseen: small. */
#define BOUND_UV_ALONG P2M(49)

/* The rounding of v.a, a point along an axis, there: half a unit, 1 of 4. Unseen: small. */
#define BOUND_UV_ALONG_UNITS (2 * SURE_UNIT)

/* The rounding of a coordinate of 0..1 there: a quotient's or an angle's half unit, 1 of 4. A sphere's second
 * coordinate has twice an angle's: 2 of 4. */
#define BOUND_UV_UNITS (2 * SURE_UNIT)

/* The rounding of a coordinate that is one quotient there: half a unit. 1 of 2. */
#define BOUND_UV_UNIT SURE_UNIT

/* The rounding of a coordinate of 0..1 by doubles: a sum, a scale and a product, or a quotient: 3 of 8 u. Unseen:
 * small. */
#define BOUND_UV_ROUNDING P2M(50)

/* The error of a plane's or a disc's coordinate: those of the point and of its dot product with an axis, times the
 * scale; a plane's scale is a power of two. */
FORMULA(UV_FLAT);

/* The rounding of a point from a box's corner by doubles, of |at|1, |min|1 and |size|1: 3 u, as these are subtracted; a
 * grid's min is a product and a sum, 2 u more. 5 of 8 u. There the differences are exact. Unseen: small. */
#define BOUND_UV_BOX_ROUNDING P2M(50)

/* The error of a coordinate on a box's face: those of the point and of its roundings, over the least side. */
FORMULA(UV_BOX);

/* The error of a face's area as seen along its main axis: that of SMOOTH_AREA; SMOOTH_ROUNDING is added for the areas'
 * roundings. */
FORMULA(UV_FACE_AREA);

/* The number of times that the sum of a face's areas must exceed their error, else the face is too small: parts are
 * known within a sixteenth. A choice, like SMOOTH_KNOWN. Unseen: choice. */
#define BOUND_UV_FACE_KNOWN 16

/* The error of a barycentric coordinate: three times that of a part, as one may be cut to 0, see SMOOTH_CUT. */
FORMULA(UV_FACE);

/* The rounding of the sum of three given coordinates by their parts, of the coordinates: 1 - a - b has two differences,
 * then a product and two sums: 5 of 16 u. Unseen: small. */
#define BOUND_UV_FACE_SUM P2M(49)

/* The error of a mesh's own coordinates: that of the parts, times the distances of the corners' coordinates from the
 * first's. */
FORMULA(UV_MESH);

/* The largest change of an angle, over 2 pi, in e/|v|, v being a vector that is off by e: .1592 asin x/x <= .1596 for x
 * = e/|v| < 1/16; the rest is for the bound's own roundings. */
#define BOUND_ANGLE_TURN 0.1875

/* The rounding of an angle, over 2 pi. tia_atan2 takes 60 steps that cut a unit of 2^-62 each from a vector of 3/4 of
 * the length s: 2^-55.7 over 2 pi s, once by doubles and once there, of which ANGLE_TURN has e/s with e of 2^-50 or
 * more; its result is within 2^-55, and the components that it is given by doubles within u. 1.3 of 8 u. Unseen: small.
 */
#define BOUND_ANGLE_ROUNDING P2M(50)

/* The error of an angle, over 2 pi: ANGLE_TURN times e over the vector's length, and ANGLE_ROUNDING. */
FORMULA(ANGLE);

/* The largest |y| at which the angle of a vector with x below 0 may lie on the other side of its jump at y = 0: e, as y
 * is off by no more than the vector. */
FORMULA(ANGLE_SEAM);

/* The number of times that a vector's length must exceed its error: directions that are off by more than a sixteenth
 * have no angle. A choice. Unseen: choice. */
#define BOUND_ANGLE_KNOWN 16

/* The least length of a vector that has an angle, 2^-12. Chosen together with ANGLE_KNOWN. Unseen: choice. */
#define BOUND_ANGLE_LEAST P2M(12)

/* The largest error of v/|v| in e/|v|, v being known within e, a sixteenth of its length, as UNIT_CHORD has it. */
#define BOUND_UV_CHORD 1.0625

/* The rounding of v/|v|, v being the way from a sphere's centre. By doubles: the difference, a root and a quotient: 5
 * u; there: 2^-58. 5 of 16 u. Unseen: small. */
#define BOUND_UV_SPHERE_ROUNDING P2M(49)

/* The rounding of sqrt(x^2 + z^2), of at least 2^-12. There: halves of v in both squares, and the root is cut: 2
 * v/2^-12 = 2^-49; by doubles: 3 u. 19 of 128 u. Unseen: small. */
#define BOUND_UV_POLE P2M(46)

/* The error of a sphere's coordinates: the errors of both angles, the second one's doubled, and UV_UNITS. */
FORMULA(UV_SPHERE);

/* The error of a sphere's second coordinate, which is twice an angle: twice that angle's. */
FORMULA(UV_SPHERE_HEIGHT);

/* The error of v/|v|, v being the way from a sphere's centre: that of v over its length, times UV_CHORD, and
 * UV_SPHERE_ROUNDING. */
FORMULA(UV_SPHERE_TURN);

/* The error of the way from a cylinder's or a cone's base along the axes: that of the point, UV_ALONG and
 * UV_ALONG_UNITS. */
FORMULA(UV_ROUND_PLACE);

/* The error of a coordinate on a cap: UV_ROUND_PLACE, over the diameter. */
FORMULA(UV_CAP);

/* The rounding of v/|v|, v having two components, by doubles: two squares, a sum, a root and a quotient, 3.5 of 8 u.
 * Unseen: small. */
#define BOUND_UV_ROUND_ROUNDING P2M(50)

/* The error of v/|v|, v being the way across the axis: that of v over its length, times UV_CHORD, and
 * UV_ROUND_ROUNDING. */
FORMULA(UV_ROUND_TURN);

/* The error of the second coordinate on a side: that of the height, over the shape's length. */
FORMULA(UV_HEIGHT);

/* The rounding of the place (uv - offset) repeat texels by doubles, of uv and offset: a difference, two products, and
 * half a texel that is subtracted: 4 of 8 u. Unseen: small. */
#define BOUND_TEXEL_ROUNDING P2M(50)

/* The rounding of the place there: the part of a pattern is cut to a unit, times the texels: 1 of 8. Unseen: small. */
#define BOUND_TEXEL_UNITS P2M(42)

/* The error of the place in texels: that of the coordinates, and TEXEL_ROUNDING, times repeat and texels. */
FORMULA(TEXEL_PLACE);

/* The rounding of a texel's colour. There: a quotient and its product with the material's colour, half a unit each; by
 * doubles: 2 u. 1 of 2. Unseen: small. */
#define BOUND_TEXEL_COLOUR P2M(44)

/* The rounding of a bilinear colour. There: three differences of texels, whose product is rounded by half a unit of
 * 1/255; the quotient and the product with the material's colour, half of one each; by doubles: 8 u. 1.04 of 8. Unseen:
 * small. */
#define BOUND_TEXEL_BLEND P2M(42)

/* The error of a bilinear colour by that of the place: the sum of both coordinates' errors, as the colour is no steeper
 * than from 0 to 1 within a texel either way. */
FORMULA(TEXEL_BLEND_PLACE);

#endif
