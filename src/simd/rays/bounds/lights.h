/* lights.h - bounds of direct lighting, and of mirrors and glass: light_tmpl.h, bounce_tmpl.h. */
#ifndef TIA_SIMD_RAYS_BOUNDS_LIGHTS_H
#define TIA_SIMD_RAYS_BOUNDS_LIGHTS_H

/* ---- a light's samples, see light_tmpl.h ---- */

/* The direction from a light's centre: the error of the point, and a difference. */
FORMULA(AIM_DIRECTION);

/* The smallest of the direction's coordinates: each is within e, so their difference within twice that. */
FORMULA(AIM_ORDER);

/* N x A: the errors of both; both are 1 long. */
FORMULA(AIM_AXES);

/* N x A by doubles: two products and a difference, 2 u of 1 in each of three: 3.5 u; there half of v each. 3.5 of 16 u.
 * Unseen: small. */
#define BOUND_AIM_ROUNDING P2M(49)

/* The axes of a light that stays are converted: u of each component, sqrt 3 u. 1.7 of 8 u. Unseen: small. */
#define BOUND_AIM_CONVERTED P2M(50)

/* L - P: the error of P, and for areas that of the sample's place. */
FORMULA(SAMPLE_WAY);

/* Along an axis x: the axis's own, and x by doubles: u_i, a root, a sine and two products, 6 u, there 2^-51 of it, as
 * 32 n parts of u are rounded once, by 2^-63 over 2^-13. 7 of 8 u. Unseen: small. */
#define BOUND_SAMPLE_PLACE P2M(50)

/* x and y times the errors of the axes and SAMPLE_PLACE. */
FORMULA(SAMPLE_AREA);

/* There: a disc's radius and two products, half a unit each, which move it by 1.4 U together, and two points along
 * axes, .87 U each: 3.2 of 4. Unseen: small. */
#define BOUND_SAMPLE_UNITS (4 * SURE_UNIT)

/* The sides' ends by doubles, two products and two sums: 4 u; there 2 u_i - 1 is within 2^-49, as 32 n parts are: 20 of
 * 32 u. Unseen: small. */
#define BOUND_SAMPLE_SIDES P2M(48)

/* c is within eto; COSINE has 6 of its 16 u, so that inner and outer, u each, have room. */
FORMULA(SPOT_COSINE);

/* The width below which a cone's edge is taken for a sharp one. A choice. Unseen: choice. */
#define BOUND_SPOT_NARROW P2M(20)

/* (c - outer)/(inner - outer): over the width, whose own conversion is 2 u of 2^-20 at least; the rest is for that and
 * the bound's roundings. */
#define BOUND_SPOT_WIDTH 1.0625

/* The error of the cosine, over the width. */
FORMULA(SPOT);

/* There the quotient is within 2^-59, then rounded to half a unit: 1 of 64. Unseen: small. */
#define BOUND_SPOT_UNITS P2M(40)

/* The distance in a light's units: its error, there half a unit; 1 of 4. Unseen: small. */
#define BOUND_FADE_UNITS (2 * SURE_UNIT)

/* By doubles a product and the unit, which is a power of two: 1 of 8 u. Unseen: small. */
#define BOUND_FADE_ROUNDING P2M(50)

/* The distance's own bound in those units, and both roundings. */
FORMULA(FADE_DISTANCE);

/* The slope of constant + linear d + quadratic d^2 between d and d', times the error of d. */
FORMULA(FADE_SUM);

/* There two products of half a unit each, the first times d: (d + 1) 2^-46; by doubles 4 u of the sum: 1 of 8. Unseen:
 * small. */
#define BOUND_FADE_SUM_ROUNDING P2M(43)

/* A smaller sum, or one that is not known within a sixteenth of itself, is undecided: choices. Unseen: choice. */
#define BOUND_FADE_LEAST P2M(6)
#define BOUND_FADE_KNOWN 16 /* chosen together with FADE_LEAST. Unseen: choice. */

/* 1/s - 1/s' = (s' - s)/(s s'), s' >= 15/16 s: 16/15 of it; the rest is for the bound's own roundings. */
#define BOUND_FADE_INVERSE 1.125

/* The error of the factor, times the spot light's factor before it. */
FORMULA(FADE);

/* The error of the spot light's factor, times the factor. */
FORMULA(FADE_SPOT);

/* There a sum of 2^17 gives 0; by doubles it is 2^16 or more then, and 1/s below 2^-16. */
#define BOUND_FADE_FAR P2M(16)

/* There: the quotient's half unit, the product's, and 2^-59 of 2^6; by doubles 2 u of 2^6: 1.05 of 4. Unseen: small. */
#define BOUND_FADE_FACTOR P2M(43)

/* way.to: the error of the way, as to = way/|way| there as well; a dot product, 5 u, and 2^-57 there. 5 of 16 u.
 * Unseen: small. */
#define BOUND_DISTANCE_ROUNDING P2M(49)

/* The error of the way, DISTANCE_ROUNDING, and half a unit there. */
FORMULA(DISTANCE);

/* The way from outside the surface: it differs from the sample's by b G, see aim_shadow(). */
FORMULA(SHADOW_WAY);

/* b times the error of the normal. */
FORMULA(SHADOW_NORMAL);

/* N.L of the normal that shades: the errors of both, as both are 1 long. */
FORMULA(LAMBERT);

/* N.L of the surface's own normal: the errors of both. */
FORMULA(ABOVE);

/* R.L = 2 (N.V) (N.L) - V.L: the errors of all four, as all are 1 at most. */
FORMULA(HIGHLIGHT_COSINE);

/* The part of N.V and N.L in HIGHLIGHT_COSINE, twice. */
FORMULA(HIGHLIGHT_FACING);

/* By doubles the dot products 5 u each, their product twice and the difference: 12 u; of 32. Unseen: small. */
#define BOUND_HIGHLIGHT_ROUNDING P2M(48)

/* x^n is no steeper than n for x <= 1. */
FORMULA(HIGHLIGHT);

/* Colour by cosine: the error of the cosine times the colour, and that of the colour. */
FORMULA(DIFFUSE);

/* The error of a textured colour, times a cosine of 1 at most; the material's colour, too, is 1 at most. */
FORMULA(DIFFUSE_TEXTURE);

/* The error of the colour, times an ambient light's brightness. */
FORMULA(AMBIENT);

/* A sample that gives less than 2^-46 gives nothing there: half a unit. Unseen: small. */
#define BOUND_SAMPLE_DARK P2M(46)

/* The reflected part, 2 at most, times the transmission: the error of either, times the falloff's factor. */
FORMULA(SAMPLE_LIGHT);

/* The error of the factor, times the reflected part: 2 at most. */
FORMULA(SAMPLE_FALLOFF);

/* The error of the factor, times that of the reflected part. 1 of 2. Unseen: small. */
FORMULA(SAMPLE_FALLOFF_MORE);

/* There, of the brightness: colour by lambert, specular by shine, the transmission and the factor have half a
 * unit each; and of the sum: the mean and the product with the emission. 2 of 8; 1 of 8. A light that fades may
 * multiply the first three by F = 2^6, but then FADE_SUM_ROUNDING has 7/8 of 2^-43 F^2 to spare. By doubles 6 u of 2,
 * of which COSINE has 10 to spare. */
#define BOUND_SAMPLE_SUM P2M(42)

/* A product of light that passes: half a unit there; 1 of 2. By doubles u. Unseen: small. */
#define BOUND_THROUGH_UNIT SURE_UNIT

/* ---- mirrors and glass, see bounce_tmpl.h ---- */

/* 2 e/(a' + b') and a' + b' >= 15/16 (a + b): 2.14 e/(a + b); the rest is for the bound's own roundings. */
#define BOUND_FRESNEL_QUOTIENT 2.25

/* The least a + b with a known quotient: 2^-16, and 16 e. Unseen: choice. */
#define BOUND_FRESNEL_LEAST P2M(16)
#define BOUND_FRESNEL_KNOWN 16 /* chosen together with FRESNEL_LEAST. Unseen: choice. */

/* (a - b)/(a + b) by doubles: 3 u of 1, and of a and b 3 u over 2^-16: those are c/4 and a root, whose roundings are in
 * er and ex; there 2^-59 and half of v over 2^-16. 3 of 128 u. Unseen: small. */
#define BOUND_FRESNEL_ROUNDING P2M(46)

/* Fresnel's equations, see reflectance_of(). */
FORMULA(FRESNEL);

/* q^2 - (1 - c^2)/16: (2 |c| + ec) ec of c^2. */
FORMULA(REFRACT_INSIDE);

/* By doubles q and its square 5 u, c^2 and two differences 4 u; there 2^-58 and halves of v: 9 of 128 u. */
#define BOUND_REFRACT_ROUNDING P2M(46)

/* The root: |sqrt a - sqrt b| <= |a - b|/sqrt a; by doubles u, there cut to v. 1 of 128 u. */
FORMULA(REFRACT_ROOT);

/* c/4: exact parts of the error of c. */
FORMULA(REFRACT_COSINE);

/* (Rs^2 + Rp^2)/2: |a^2 - a'^2| <= (2 |a| + e) e, and half of that is below (|a| + e) e. */
FORMULA(REFRACT_FRESNEL);

/* The errors of q^2 c and root/4 together. */
FORMULA(REFRACT_PARALLEL);

/* The errors of c/4 and root together. */
FORMULA(REFRACT_ACROSS);

/* (c/4 - root) N - V/4: the error of N times the bend, that of the bend, and that of V. */
FORMULA(REFRACT_DIRECTION);

/* A product and a difference in each of three, and the bend's difference: 5 of 64 u. There halves of v and an integer
 * quotient. Unseen: small. */
#define BOUND_REFRACT_DIRECTION_ROUNDING P2M(47)

/* The error of the throughput, times the most that is reflected: mirror and refraction are 1 each at most, so that it
 * may be 2 and grow with every bounce. */
FORMULA(REFLECTED_WEIGHT);

/* The error of Fresnel's part, times the throughput, as refraction is 1 at most; REFRACT_ROUNDING in it has the half
 * unit there of refraction's part. */
FORMULA(REFLECTED_FRESNEL);

/* The error of the throughput, times the refracted part, which is 1 at most. */
FORMULA(REFRACTED_WEIGHT);

/* As REFLECTED_FRESNEL. */
FORMULA(REFRACTED_FRESNEL);

/* The throughput's product there: half a unit; 1 of 16. Refraction's part has half of one, which REFRACT_ROUNDING has,
 * times the throughput. Unseen: small. */
#define BOUND_WEIGHT_UNITS P2M(42)

/* By doubles a product, a sum or difference and a product: 3 of 4 u of the throughput, which is 2^16 at most. Unseen:
 * small. */
#define BOUND_WEIGHT_ROUNDING P2M(51)

/* Straight on: the error of the point, and b times that of the viewer. */
FORMULA(STRAIGHT_ON);

/* For samples: b times the error of the viewer. */
FORMULA(STRAIGHT_ON_TURN);

#endif
