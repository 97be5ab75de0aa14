/* lights.h - bounds of direct lighting, and of mirrors and glass: sample_tmpl.h, light_tmpl.h, bounce_tmpl.h. P is the
 * lit point, G the geometric and N the shading normal, V the direction to the viewer, L that to the light, and b the
 * distance from the surface at which new rays start. */
#ifndef TIA_SIMD_RAYS_BOUNDS_LIGHTS_H
#define TIA_SIMD_RAYS_BOUNDS_LIGHTS_H

/* ---- a light's samples, see sample_tmpl.h and light_tmpl.h ---- */

/* The error of the vector from a sphere light's centre to the point: the error of the point, and POINT_ROUNDING. */
FORMULA(AIM_DIRECTION);

/* The error of the difference of two of the direction's coordinates: twice the error of the direction. */
FORMULA(AIM_ORDER);

/* The error of the axes A and N x A: the errors of A and N, which are 1 long, and AIM_ROUNDING. */
FORMULA(AIM_AXES);

/* The rounding of N x A. In doubles: two products and a difference, 2 u in each of three coordinates, 3.5 u together.
 * In fixed point: half of 2^-62 in each. Needed: 3.5 of 16 u. Unseen: small. */
#define BOUND_AIM_ROUNDING P2M(49)

/* The error of the axes of a light that does not turn, which are converted: u of each component, so u of their length.
 * Needed: 2.5 of 8 u, of which SAMPLE_PLACE needs 1.5. Unseen: small. */
#define BOUND_AIM_CONVERTED P2M(50)

/* The error of the vector from the point to the light's centre: the error of the point, and POINT_ROUNDING. */
FORMULA(SAMPLE_WAY);

/* The relative rounding of a sample's coordinate x along an axis. In doubles: 5.5 u for u_i, a root, a sine and three
 * products. In fixed point: u_i is a multiple of 1/(32 n) >= 2^-13, which is rounded by 2^-63, so its root has a
 * relative error of 2^-51, 4 u. Needed: 9.5 of 8 u; AIM_CONVERTED or AIM_ROUNDING, which are multiplied by x as well,
 * cover the other 1.5 u. Unseen: small. */
#define BOUND_SAMPLE_PLACE P2M(50)

/* The error of a sample's place on an area light: its coordinates x and y, times the error of the axes and
 * SAMPLE_PLACE. */
FORMULA(SAMPLE_AREA);

/* The rounding of a sample's place on an area light in fixed point: half a unit each of a disc's radius and two
 * products, 1.4 U together, and .87 U for each of two points along axes. Needed: 3.2 of 4 U. Unseen: small. */
#define BOUND_SAMPLE_UNITS (4 * SURE_UNIT)

/* The rounding of a sample's place on a rectangle, relative to its sides. In doubles: 6 u for u_i, a difference, a
 * product and two sums. In fixed point: 2 u_i - 1 is within 2^-49, as in SAMPLE_PLACE. Needed: 22 of 32 u. Unseen:
 * small. */
#define BOUND_SAMPLE_SIDES P2M(48)

/* The error of a spot light's cosine c: the error of the direction, and COSINE. The cosine needs 5.1 of COSINE's 16 u;
 * the rest covers the conversions of inner and outer, u each. */
FORMULA(SPOT_COSINE);

/* The least difference of inner and outer. Where it is less, the cone's edge is treated as sharp. A choice. Unseen:
 * choice. */
#define BOUND_SPOT_NARROW P2M(20)

/* The factor of e/width in the error of (c - outer)/(inner - outer): 1, plus 2^-32 for the conversion of the width, 2 u
 * of at least 2^-20. The rest covers the roundings of the bound itself. */
#define BOUND_SPOT_WIDTH 1.0625

/* The error of a spot light's factor (c - outer)/(inner - outer): the error of the cosine c over the width, times
 * SPOT_WIDTH. */
FORMULA(SPOT);

/* The rounding of a spot light's factor in fixed point: a quotient within 2^-59, rounded to half a unit. Needed: .5 of
 * 32 U. Unseen: small. */
#define BOUND_SPOT_UNITS P2M(40)

/* The rounding of the distance in a light's units in fixed point: half a unit. Needed: .5 of 2 U. Unseen: small. */
#define BOUND_FADE_UNITS (2 * SURE_UNIT)

/* The relative rounding of the distance in a light's units in doubles: none, as the unit is a power of two. Needed: 0
 * of 8 u. Unseen: small. */
#define BOUND_FADE_ROUNDING P2M(50)

/* The error of the distance in a light's units: that of the distance, times the unit, FADE_UNITS and FADE_ROUNDING. */
FORMULA(FADE_DISTANCE);

/* The error of constant + linear d + quadratic d^2: its slope between d and d', times the error of d. */
FORMULA(FADE_SUM);

/* The rounding of constant + linear d + quadratic d^2, relative to itself + d + 1. In doubles: 4 u of the sum. In fixed
 * point: two products of half a unit each, the first of which is multiplied by d: (d + 1) 2^-46. Needed: .52 of 4 U.
 * Unseen: small. */
#define BOUND_FADE_SUM_ROUNDING P2M(43)

/* The least sum constant + linear d + quadratic d^2 that is decided. A choice. Unseen: choice. */
#define BOUND_FADE_LEAST P2M(6)

/* The least sum that is decided, in multiples of its error. Chosen together with FADE_LEAST. Unseen: choice. */
#define BOUND_FADE_KNOWN 16

/* The factor of the error of the sum s, over s^2, in the error of 1/s: 1/s - 1/s' = (s' - s)/(s s'), s' >= 15/16 s, so
 * 16/15. The rest covers the roundings of the bound itself. */
#define BOUND_FADE_INVERSE 1.125

/* The error of the factor 1/s: the error of s over s^2, times FADE_INVERSE. It is multiplied by the spot light's
 * factor. */
FORMULA(FADE);

/* The error of a spot light's factor, times the distance's factor 1/s. */
FORMULA(FADE_SPOT);

/* The largest error of the factor 1/s where the fixed-point code may set it to 0, as it does where s is 2^17 or more.
 * In doubles s is then 2^16 or more, and 1/s below 2^-16. */
#define BOUND_FADE_FAR P2M(16)

/* The rounding of a light's factor, which is at most 2^6. In doubles: 2 u of 2^6, which are half a unit. In fixed
 * point: half a unit each for the quotient and the product, and 2^-59 of 2^6. Needed: 1.51 of 4 U. Unseen: small. */
#define BOUND_FADE_FACTOR P2M(43)

/* The relative rounding of the distance, the dot product of the vector to the light and its unit vector. In doubles: 5
 * u for the unit vector, a product and two sums. In fixed point: 2^-57. Needed: 8.1 of 16 u. Unseen: small. */
#define BOUND_DISTANCE_ROUNDING P2M(49)

/* The error of the distance: the error of the vector, whose unit vector is that of the same vector in fixed point;
 * DISTANCE_ROUNDING; and half a unit in fixed point. */
FORMULA(DISTANCE);

/* The error of the vector from the shadow ray's origin to the sample: the errors of the sample's vector and of b G, by
 * which the two differ, POINT_UNITS and POINT_ROUNDING; see aim_shadow(). */
FORMULA(SHADOW_WAY);

/* The error of b G: b times the error of G. */
FORMULA(SHADOW_NORMAL);

/* The error of N.L: the errors of N and L, which are 1 long, and COSINE. */
FORMULA(LAMBERT);

/* The error of G.L: the errors of G and L, which are 1 long, and COSINE. */
FORMULA(ABOVE);

/* The error of R.L = 2 (N.V) (N.L) - V.L: HIGHLIGHT_FACING for the first product, the errors of V and L, and
 * HIGHLIGHT_ROUNDING. */
FORMULA(HIGHLIGHT_COSINE);

/* The part of N.V and N.L in HIGHLIGHT_COSINE: twice the errors of both, as both are at most 1. */
FORMULA(HIGHLIGHT_FACING);

/* The rounding of R.L in doubles: 5 u for V.L, 2 u for the doubled product, and 3 u for the difference, which is at
 * most 3. Needed: 10 of 32 u. Unseen: small. */
#define BOUND_HIGHLIGHT_ROUNDING P2M(48)

/* The error of x^n, x = R.L: the slope of x^n times the error of x, see power_turn(). */
FORMULA(HIGHLIGHT);

/* The error of the colour times the cosine: the error of the cosine times the colour, and DIFFUSE_TEXTURE. */
FORMULA(DIFFUSE);

/* The error of a textured colour, times a cosine and a material's colour of at most 1. */
FORMULA(DIFFUSE_TEXTURE);

/* The error of the reflected part of an ambient light: the error of the colour, times the light's brightness. */
FORMULA(AMBIENT);

/* The factor below which a sample gives no light in fixed point: half a unit, as smaller factors are rounded to 0.
 * Unseen: small. */
#define BOUND_SAMPLE_DARK P2M(46)

/* The error of the reflected part, at most 2, times the transmission: that of the reflected part, and twice that of the
 * transmission. Both are multiplied by the falloff's factor. */
FORMULA(SAMPLE_LIGHT);

/* The error of the falloff's factor, times the reflected part, which is at most 2. */
FORMULA(SAMPLE_FALLOFF);

/* The error of the falloff's factor, times that of the reflected part. Needed: 1 of 2. Unseen: small. */
FORMULA(SAMPLE_FALLOFF_MORE);

/* The rounding of a sample's light, relative to the light's brightness, and that of the sum. Relative to the
 * brightness, in fixed point: half a unit each for the colour times lambert, specular times shine, the transmission and
 * the factor; in doubles: 6 u of 2. Needed: 2.05 of 8 U. A light that fades may multiply the first three by F = 2^6,
 * but then 7/8 of FADE_SUM_ROUNDING, 7/8 of 2^-43 F^2, is not needed and covers them. Of the sum, in fixed point: half
 * a unit each for the mean and the product with the emission. Needed: 1 of 8 U. */
#define BOUND_SAMPLE_SUM P2M(42)

/* The rounding of a product of transmitted light. In doubles: u. In fixed point: half a unit. Needed: .51 of 1 U.
 * Unseen: small. */
#define BOUND_THROUGH_UNIT SURE_UNIT

/* ---- area lights as a whole, see area_tmpl.h, area_sum_tmpl.h and the files of shafts ---- */

/* The least distance of a light that is taken as a whole, in multiples of its reach R. A choice, on which AREA_COSINE
 * and SHAFT_SQUARE depend. Unseen: choice. */
#define BOUND_AREA_NEAR 2

/* The least distance of such a light. A choice: quotients stay finite. Unseen: choice. */
#define BOUND_AREA_LEAST P2M(30)

/* The rounding of a cosine n.(W + x A + y B)/|W + x A + y B| in doubles. With R <= |W|/2, R being at least |x A + y B|
 * and |x| |A| and |y| |B| at most R each, or sqrt 2 R together on a disc: the sizes of the numerator's terms add up to
 * sqrt 3 1.71 |W|, and the divisor is |W|/2 or more, so 6 roundings are 36 u. The terms of the square add up to
 * (1.71)^2 W^2, and the square is W^2/4 or more; its 6 roundings are 72 u, 36 u of the root. The inverse root adds 8 u,
 * the product u. A mirrored V in place of n has the length 1 but for its own error. Needed: 81 of 256 u. Unseen: small.
 * */
#define BOUND_AREA_COSINE P2M(45)

/* The least cosine of a shadow ray to G, over which it certainly leaves the surface, as LEAVING. Here it is taken from
 * the height of the sample over O and its distance from P, which is half of that from O or more. The error of ABOVE is
 * half as large, and the least value. Unseen: small. */
FORMULA(AREA_LEAVING);

/* The error of a highlight that is left out: 2^-24, and the roundings of x = 2^(-24/n), the least R.L that may have
 * more, and of x^n. Needed: 1.001 of 2 times 2^-24. Unseen: small. */
#define BOUND_AREA_FAINT P2M(23)

/* The largest distance of the fixed-point shadow ray from the segment O S: the errors of O and of S - O. */
FORMULA(SHAFT_APART);

/* The rounding of S - O, of its direction and of the ray's length, relative to |S - O|. In doubles: 4 u for S - O. In
 * fixed point: 2^-58 of the direction, and 8.1 u of DISTANCE_ROUNDING. Needed: 13 of 32 u. Unseen: small. */
#define BOUND_SHAFT_ROUNDING P2M(48)

/* The rounding of a point on the fixed-point ray and of its length: POINT_UNITS and LENGTH_UNIT. Needed: 3 of 4 U.
 * Unseen: small. */
#define BOUND_SHAFT_UNITS (4 * SURE_UNIT)

/* SHAFT_APART in the axes of an instance: the error of O there, that of the direction over the length of the segment,
 * and SHAFT_APART over the least scale for the ray's end. The second is taken twice, for the length k of directions.
 * Unseen: small. */
FORMULA(SHAFT_PLACED);

/* The error of heights over a plane: SHAFT_APART and the roundings as in PLANE_BEHIND, for both ends. */
FORMULA(SHAFT_PLANE);

/* The rounding in doubles of the numbers by which a shaft is compared with a ball: (C - O)^2, (C - O).V, V^2 and R^2,
 * relative to |C - O|1^2 + |V|1^2. Each has three products, two sums, and 4 u of its vectors; they are multiplied by s
 * <= 1, 2 s and s^2. A discriminant has two products more. Needed: 40 of 512 u. Unseen: small. */
#define BOUND_SHAFT_SQUARE P2M(44)

/* The relative margin of comparisons of products, and of a tube's distances: b b with a c, which are 4 u off; factors'
 * own errors are covered by SHAFT_SQUARE. The sizes of a triple product add up to |Q - O|1 |V|1, and it is 8 u off.
 * Needed: 8 u of 2^13 u. Unseen: small. */
#define BOUND_SHAFT_TOUCH P2M(40)

/* The distance by which r' is larger than the root of r^2 and the error of the discriminant: the errors of the distance
 * t of a hit, which are SHAFT_APART, the error of the direction over |C - O|, and the like for the ray's length. The
 * error of the discriminant, which makes r' larger by as much, is added. Unseen: small. */
FORMULA(SHAFT_BALL);

/* The distance by which a ball or a tube around a shape is larger: twice SHAFT_APART, the roundings of the numbers by
 * which it is compared, see SLABS_FLOATS, which is far larger, and SHAFT_SHAPE. */
FORMULA(SHAFT_AROUND);

/* The distance by which roundings move an intersection out of a shape: less than 2^-30, see slabs_tmpl.h. Needed: 1 of
 * 4 times 2^-30. Unseen: small. */
#define BOUND_SHAFT_SHAPE P2M(28)

/* The relative margin of the square of a ray's distance from an axis. The error d of the triple product is 8 u of |Q -
 * O|1 |V|1. t^2 is off by 2 |t| d + d^2, below 2^-20 t^2 + 2^21 d^2; the latter is 2^-79 of the squares' product, far
 * less than SHAFT_SQUARE of it. Unseen: small. */
#define BOUND_SHAFT_TUBE P2M(20)

/* The constant part of the bound of a face's area over all samples: that of rays, times the length of the segment, and
 * as much for |x A + y B|. Unseen: small. */
FORMULA(SHAFT_PAIR_OFF);

/* The part of this bound that grows with the face. That of directions and origins is as in PAIR_EDGE. The roundings of
 * floats, v = 2^-24, are relative to M, c times far times the size of V and x A + y B: the sizes of the terms of a
 * vector g add up to 2 M, g is off by 8 v M, and its product by 8 v M more. The third area has the errors of two such
 * vectors, 10 v M for the difference, 20 v M for the product, and 8 v M for the sums of its range. Needed: 54 of 8
 * times 25 v, PAIR_AREA being 25 v. Unseen: small. */
FORMULA(SHAFT_PAIR);

/* ---- mirrors and glass, see bounce_tmpl.h ---- */

/* The factor of e/(a + b) in the error of a reflectance: 2 e/(a' + b'), a' + b' >= 15/16 (a + b), so 2.14. The rest
 * covers the roundings of the bound itself. */
#define BOUND_FRESNEL_QUOTIENT 2.25

/* The least a + b by which a reflectance is computed. A choice. Unseen: choice. */
#define BOUND_FRESNEL_LEAST P2M(16)

/* The factor of e that is added to FRESNEL_LEAST. Chosen together with FRESNEL_LEAST. Unseen: choice. */
#define BOUND_FRESNEL_KNOWN 16

/* The rounding of a reflectance (a - b)/(a + b). In doubles: 3 u. In fixed point: 2^-59. Needed: 3.1 of 128 u. The
 * roundings of a and b themselves, 3 u in doubles and half of 2^-62 in fixed point, are in their errors, which include
 * REFRACT_ROUNDING. Unseen: small. */
#define BOUND_FRESNEL_ROUNDING P2M(46)

/* The error of a reflectance by Fresnel's equations: the sum of the errors of a and b, over a + b, times
 * FRESNEL_QUOTIENT, see reflectance_of(). */
FORMULA(FRESNEL);

/* The error of q^2 - (1 - c^2) `part`^2 by that of c: (2 |c| + ec) ec for c^2, times `part`^2; `part` is 1/4 or 1/16.
 */
FORMULA(REFRACT_INSIDE);

/* The rounding of q^2 - (1 - c^2) `part`^2. In doubles: 5 u for q and its square, 4 u for c^2 and two differences. In
 * fixed point: 2^-58 and halves of 2^-62. Needed: 9.1 of 128 u. */
#define BOUND_REFRACT_ROUNDING P2M(46)

/* The error of the root of REFRACT_INSIDE's value, see root_error(). REFRACT_ROUNDING is added for the rounding of the
 * root, u in doubles, and 2^-62, to which it is truncated, in fixed point. */
FORMULA(REFRACT_ROOT);

/* The error of c `part`: exactly the error of c, times `part`. */
FORMULA(REFRACT_COSINE);

/* The error of (Rs^2 + Rp^2)/2: |a^2 - a'^2| <= (2 |a| + e) e, and half of that is below (|a| + e) e. */
FORMULA(REFRACT_FRESNEL);

/* The sum of the errors of q^2 c and root `part`. */
FORMULA(REFRACT_PARALLEL);

/* The sum of the errors of c `part` and root. */
FORMULA(REFRACT_ACROSS);

/* The error of the refracted direction bend N - `part` V, bend = c `part` - root: |bend| times the error of N, the
 * errors of c `part` and root, and `part` times the error of V. */
FORMULA(REFRACT_DIRECTION);

/* The rounding of the refracted direction. In doubles: u for bend, and 2 u for a product and a difference in each of
 * three coordinates. In fixed point: halves of 2^-62 and an integer quotient. Needed: 5 of 64 u. Unseen: small. */
#define BOUND_REFRACT_DIRECTION_ROUNDING P2M(47)

/* The error of a reflected ray's throughput by that of the throughput before, times the largest reflected part. Mirror
 * and refraction are at most 1 each, so the reflected part may be 2, and throughputs may grow with every bounce. */
FORMULA(REFLECTED_WEIGHT);

/* The error of Fresnel's part, times the throughput, as refraction is at most 1. The error includes REFRACT_ROUNDING,
 * which covers the half unit of the fixed-point product with refraction. */
FORMULA(REFLECTED_FRESNEL);

/* The error of a refracted ray's throughput by that of the throughput before, times the refracted part, which is at
 * most 1. */
FORMULA(REFRACTED_WEIGHT);

/* As REFLECTED_FRESNEL, for the refracted ray. */
FORMULA(REFRACTED_FRESNEL);

/* The rounding of a throughput's product in fixed point: half a unit. REFRACT_ROUNDING covers the half unit of
 * refraction's part, times the throughput. Needed: .5 of 8 U. Unseen: small. */
#define BOUND_WEIGHT_UNITS P2M(42)

/* The rounding of a throughput's product in doubles, relative to the throughput, which is 2^16 at most: a product, a
 * sum or difference, and a product. Needed: 3 of 4 u. Unseen: small. */
#define BOUND_WEIGHT_ROUNDING P2M(51)

/* The error of the origin of a ray that goes straight on: the error of the point, and b times the error of V. */
FORMULA(STRAIGHT_ON);

/* The part of V in STRAIGHT_ON for samples: b times its error. */
FORMULA(STRAIGHT_ON_TURN);

#endif
