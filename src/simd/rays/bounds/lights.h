/* lights.h - bounds of direct lighting, and of mirrors and glass: light_tmpl.h, bounce_tmpl.h. */
#ifndef TIA_SIMD_RAYS_BOUNDS_LIGHTS_H
#define TIA_SIMD_RAYS_BOUNDS_LIGHTS_H

/* ---- a light's samples, see light_tmpl.h ---- */

/* The error of the way from a sphere light's centre to the point: that of the point, and POINT_ROUNDING. */
FORMULA(AIM_DIRECTION);

/* The error of the difference of two of the direction's coordinates: each is within e, so their difference within twice
 * that. */
FORMULA(AIM_ORDER);

/* The error of the axes A and N x A: those of A and of N, both 1 long, and AIM_ROUNDING. */
FORMULA(AIM_AXES);

/* The rounding of N x A. By doubles: two products and a difference, 2 u of 1 in each of three coordinates, 3.5 u;
 * there: half of v each. 3.5 of 16 u. Unseen: small. */
#define BOUND_AIM_ROUNDING P2M(49)

/* The error of the axes of a light that does not turn, which are converted: u of each component, sqrt 3 u. 1.7 of 8 u.
 * Unseen: small. */
#define BOUND_AIM_CONVERTED P2M(50)

/* The error of the way from the point to the light, L - P: that of P, and POINT_ROUNDING. */
FORMULA(SAMPLE_WAY);

/* The rounding of a sample's place along an axis, as a part of its coordinate x: that of the axis; and of x, by doubles
 * 6 u: u_i, a root, a sine and two products; there 2^-51, as 32 n parts of u are rounded once, by 2^-63 over 2^-13. 7
 * of 8 u. Unseen: small. */
#define BOUND_SAMPLE_PLACE P2M(50)

/* The error of a sample's place on an area light: the coordinates x and y, times the errors of the axes and
 * SAMPLE_PLACE. */
FORMULA(SAMPLE_AREA);

/* The rounding of a sample's place on an area light there: half a unit each of a disc's radius and two products, which
 * move it by 1.4 U together, and .87 U of each of two points along axes: 3.2 of 4. Unseen: small. */
#define BOUND_SAMPLE_UNITS (4 * SURE_UNIT)

/* The rounding of a sample's place on a rectangle, as a part of its sides. By doubles: two products and two sums, 4 u;
 * there: 2 u_i - 1 is within 2^-49, as 32 n parts are. 20 of 32 u. Unseen: small. */
#define BOUND_SAMPLE_SIDES P2M(48)

/* The error of a spot light's cosine c: eto and COSINE, which has 6 of its 16 u, so that inner and outer, u each, have
 * room. */
FORMULA(SPOT_COSINE);

/* The least difference of inner and outer: where it is less, a cone's edge is taken for a sharp one. A choice. Unseen:
 * choice. */
#define BOUND_SPOT_NARROW P2M(20)

/* The factor of e/width in the error of (c - outer)/(inner - outer): the width's own conversion is 2 u of 2^-20 at
 * least; the rest is for that and the bound's roundings. */
#define BOUND_SPOT_WIDTH 1.0625

/* The error of a spot light's factor (c - outer)/(inner - outer): that of the cosine c, over the width, times
 * SPOT_WIDTH. */
FORMULA(SPOT);

/* The rounding of a spot light's factor there: a quotient within 2^-59, then rounded to half a unit: 1 of 64. Unseen:
 * small. */
#define BOUND_SPOT_UNITS P2M(40)

/* The rounding of the distance in a light's units there: half a unit; 1 of 4. Unseen: small. */
#define BOUND_FADE_UNITS (2 * SURE_UNIT)

/* The rounding of the distance in a light's units by doubles: a product, as the unit is a power of two: 1 of 8 u.
 * Unseen: small. */
#define BOUND_FADE_ROUNDING P2M(50)

/* The error of the distance in a light's units: that of the distance in those units, FADE_UNITS and FADE_ROUNDING. */
FORMULA(FADE_DISTANCE);

/* The error of constant + linear d + quadratic d^2: its slope between d and d', times the error of d. */
FORMULA(FADE_SUM);

/* The rounding of constant + linear d + quadratic d^2. There: two products of half a unit each, the first times d: (d +
 * 1) 2^-46; by doubles: 4 u of the sum. 1 of 8. Unseen: small. */
#define BOUND_FADE_SUM_ROUNDING P2M(43)

/* The least sum constant + linear d + quadratic d^2 that is decided. A choice. Unseen: choice. */
#define BOUND_FADE_LEAST P2M(6)

/* The least sum that is decided, in errors of the sum: one that is not known within a sixteenth of itself is undecided.
 * Chosen together with FADE_LEAST. Unseen: choice. */
#define BOUND_FADE_KNOWN 16

/* The factor of the error of the sum s, over s^2, in that of 1/s: 1/s - 1/s' = (s' - s)/(s s'), s' >= 15/16 s: 16/15;
 * the rest is for the bound's own roundings. */
#define BOUND_FADE_INVERSE 1.125

/* The error of the factor 1/s: that of s, over s^2, times FADE_INVERSE. The spot light's factor before it multiplies
 * this. */
FORMULA(FADE);

/* The error of a spot light's factor, times the factor 1/s of the distance. */
FORMULA(FADE_SPOT);

/* The largest error of the factor 1/s where it may be 0: there a sum of 2^17 gives 0; by doubles the sum is 2^16 or
 * more then, and 1/s below 2^-16. */
#define BOUND_FADE_FAR P2M(16)

/* The rounding of a light's factor. There: the quotient's half unit, the product's, and 2^-59 of 2^6; by doubles: 2 u
 * of 2^6. 1.05 of 4. Unseen: small. */
#define BOUND_FADE_FACTOR P2M(43)

/* The rounding of the distance, the dot product of the way and its unit vector. By doubles: 5 u; there: 2^-57. 5 of 16
 * u. Unseen: small. */
#define BOUND_DISTANCE_ROUNDING P2M(49)

/* The error of the distance: that of the way, whose unit vector is that of the same way there; DISTANCE_ROUNDING; and
 * half a unit there. */
FORMULA(DISTANCE);

/* The error of the shadow ray's way, from outside the surface to the sample: those of the sample's way and of b G, by
 * which the two differ, POINT_UNITS and POINT_ROUNDING; see aim_shadow(). */
FORMULA(SHADOW_WAY);

/* The error of b G: b times that of the normal. */
FORMULA(SHADOW_NORMAL);

/* The error of N.L, N being the normal that shades: those of both, as both are 1 long, and COSINE. */
FORMULA(LAMBERT);

/* The error of N.L, N being the surface's own normal: those of both, as both are 1 long, and COSINE. */
FORMULA(ABOVE);

/* The error of R.L = 2 (N.V) (N.L) - V.L: those of all four, as all are 1 at most, and HIGHLIGHT_ROUNDING. */
FORMULA(HIGHLIGHT_COSINE);

/* The part of N.V and N.L in HIGHLIGHT_COSINE: twice the errors of both. */
FORMULA(HIGHLIGHT_FACING);

/* The rounding of R.L. By doubles: 5 u for each of the dot products, the rest for their product twice and the
 * difference: 12 of 32 u. Unseen: small. */
#define BOUND_HIGHLIGHT_ROUNDING P2M(48)

/* The error of x^n, x = R.L: n times that of x, as x^n is no steeper than n for x <= 1. */
FORMULA(HIGHLIGHT);

/* The error of the colour times the cosine: that of the cosine times the colour, and that of the colour. */
FORMULA(DIFFUSE);

/* The error of a textured colour, times a cosine of 1 at most; the material's colour, too, is 1 at most. */
FORMULA(DIFFUSE_TEXTURE);

/* The error of the light reflected from an ambient light: that of the colour, times the light's brightness. */
FORMULA(AMBIENT);

/* The least factor of a sample that gives light there, 2^-46: half a unit. Unseen: small. */
#define BOUND_SAMPLE_DARK P2M(46)

/* The error of the reflected part, 2 at most, times the transmission: that of the reflected part, and twice that of the
 * transmission; both times the falloff's factor. */
FORMULA(SAMPLE_LIGHT);

/* The error of the falloff's factor, times the reflected part: 2 at most. */
FORMULA(SAMPLE_FALLOFF);

/* The error of the falloff's factor, times that of the reflected part. 1 of 2. Unseen: small. */
FORMULA(SAMPLE_FALLOFF_MORE);

/* The rounding of a sample's light. There, of the brightness: half a unit each for the colour by lambert, specular by
 * shine, the transmission and the factor: 2 of 8; and of the sum: for the mean and the product with the emission: 1 of
 * 8. A light that fades may multiply the first three by F = 2^6, but then FADE_SUM_ROUNDING has 7/8 of 2^-43 F^2 to
 * spare. By doubles: 6 u of 2, of which COSINE has 10 to spare. */
#define BOUND_SAMPLE_SUM P2M(42)

/* The rounding of a product of light that passes. There: half a unit; 1 of 2. By doubles: u. Unseen: small. */
#define BOUND_THROUGH_UNIT SURE_UNIT

/* ---- mirrors and glass, see bounce_tmpl.h ---- */

/* The factor of e/(a + b) in the error of a reflectance: 2 e/(a' + b') and a' + b' >= 15/16 (a + b): 2.14; the rest is
 * for the bound's own roundings. */
#define BOUND_FRESNEL_QUOTIENT 2.25

/* The least a + b by which a reflectance is computed, 2^-16. A choice. Unseen: choice. */
#define BOUND_FRESNEL_LEAST P2M(16)

/* The least a + b by which a reflectance is computed, in e: 16 e, added to FRESNEL_LEAST and chosen together with it.
 * Unseen: choice. */
#define BOUND_FRESNEL_KNOWN 16

/* The rounding of a reflectance, (a - b)/(a + b). By doubles: 3 u of 1; there: 2^-59. 3 of 128 u. The roundings of a
 * and b, c/4 and a root, are in er and ex: 3 u of them by doubles and half of v there, over 2^-16. Unseen: small. */
#define BOUND_FRESNEL_ROUNDING P2M(46)

/* The error of a reflectance of Fresnel's equations: that of a and b together, over a + b, times FRESNEL_QUOTIENT, see
 * reflectance_of(). */
FORMULA(FRESNEL);

/* The error of q^2 - (1 - c^2)/16 by that of c: (2 |c| + ec) ec for c^2, over 16. */
FORMULA(REFRACT_INSIDE);

/* The roundings of REFRACT_INSIDE's value. By doubles: 5 u for q and its square, 4 u for c^2 and two differences;
 * there: 2^-58 and halves of v. 9 of 128 u. */
#define BOUND_REFRACT_ROUNDING P2M(46)

/* The error of the root of REFRACT_INSIDE's value: |sqrt a - sqrt b| <= |a - b|/sqrt a. Its rounding, by doubles u,
 * there cut to v, is in REFRACT_ROUNDING: 1 of 128 u. */
FORMULA(REFRACT_ROOT);

/* The error of c/4: a quarter of the error of c, exactly. */
FORMULA(REFRACT_COSINE);

/* The error of (Rs^2 + Rp^2)/2: |a^2 - a'^2| <= (2 |a| + e) e, and half of that is below (|a| + e) e. */
FORMULA(REFRACT_FRESNEL);

/* The errors of q^2 c and root/4 together. */
FORMULA(REFRACT_PARALLEL);

/* The errors of c/4 and root together. */
FORMULA(REFRACT_ACROSS);

/* The error of the refracted direction, (c/4 - root) N - V/4: that of N times the bend, those of c/4 and root, and a
 * quarter of that of V. */
FORMULA(REFRACT_DIRECTION);

/* The rounding of the refracted direction. By doubles: a product and a difference in each of three coordinates, and the
 * bend's difference: 5 of 64 u; there: halves of v and an integer quotient. Unseen: small. */
#define BOUND_REFRACT_DIRECTION_ROUNDING P2M(47)

/* The error of a reflected ray's throughput: that of the throughput before, times the most that is reflected: mirror
 * and refraction are 1 each at most, so that it may be 2 and grow with every bounce. */
FORMULA(REFLECTED_WEIGHT);

/* The error of Fresnel's part, times the throughput, as refraction is 1 at most; REFRACT_ROUNDING in it has the half
 * unit there of refraction's part. */
FORMULA(REFLECTED_FRESNEL);

/* The error of a refracted ray's throughput: that of the throughput before, times the refracted part, which is 1 at
 * most. */
FORMULA(REFRACTED_WEIGHT);

/* As REFLECTED_FRESNEL, for the refracted ray. */
FORMULA(REFRACTED_FRESNEL);

/* The rounding of a throughput's product there: half a unit; 1 of 16. The half unit of refraction's part, times the
 * throughput, is in REFRACT_ROUNDING. Unseen: small. */
#define BOUND_WEIGHT_UNITS P2M(42)

/* The rounding of a throughput's product by doubles: a product, a sum or difference and a product: 3 of 4 u of the
 * throughput, which is 2^16 at most. Unseen: small. */
#define BOUND_WEIGHT_ROUNDING P2M(51)

/* The error of the origin of a ray that goes straight on: that of the point, and b times that of the viewer. */
FORMULA(STRAIGHT_ON);

/* The part of the viewer's direction in STRAIGHT_ON, for samples: b times its error. */
FORMULA(STRAIGHT_ON_TURN);

#endif
