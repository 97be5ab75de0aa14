/* scatter.h - bounds of the directions in which surfaces scatter light: scatter_tmpl.h. N is the surface's normal, R
 * the mirrored direction, L that of the light, n the exponent of a glossy lobe, p = (R.L)^n. */
#ifndef TIA_SIMD_RAYS_BOUNDS_SCATTER_H
#define TIA_SIMD_RAYS_BOUNDS_SCATTER_H

/* ---- lobes ---- */

/* The factor of e/s in the relative error of a chance a/s, e being the error of s: s/(s - e), so 16/15, as s > 16 e.
 * The rest covers the roundings of the bound itself. Unseen: hidden. */
#define BOUND_CHANCE_QUOTIENT 1.125

/* The least diffuse part with which chances are decided, in multiples of its error e. Chosen together with
 * CHANCE_QUOTIENT. Unseen: choice. */
#define BOUND_CHANCE_KNOWN 16

/* The relative rounding of a chance a/s. In doubles: three sums and a quotient, 4 u. In fixed point: 2^-59. Needed: 4.1
 * of 8 u. Unseen: small. */
#define BOUND_CHANCE_ROUNDING P2M(50)

/* The rounding of a textured colour's largest channel in fixed point, beside the error of the texel: half a unit.
 * Needed: .5 of 1 U. Unseen: small. */
#define BOUND_CHANCE_UNIT SURE_UNIT

/* The error of a chance, a share of the sum s: the share, times CHANCE_QUOTIENT e/s and CHANCE_ROUNDING. Only the last
 * term of s, the colour, has an error, e. Unseen: hidden. */
FORMULA(CHANCE);

/* The error of R.L: the errors of both directions, as in FACING, and COSINE. Unseen: hidden. */
FORMULA(LOBE_COSINE);

/* The error of p = (R.L)^n: the slope of the power times LOBE_COSINE, see power_turn(); POWER is added for the
 * roundings. */
FORMULA(LOBE_POWER);

/* The rounding of a glossy lobe's light in fixed point: half a unit of the height, times specular, and half a unit each
 * for the products with specular and with the cosine. Needed: 1 + most/2 of 3 (1 + most) U. Unseen: small. */
#define BOUND_LOBE_UNITS (3 * SURE_UNIT)

/* The error of the density of a glossy lobe: the error of p times (n + 1)/2 and the lobe's chance. Its roundings in
 * doubles, 2 u of a height of at most 5001, are covered by POWER, which has 170 u more than needed. */
FORMULA(LOBE_DENSITY);

/* The error of the density of a glossy lobe by that of its chance, which is multiplied by (n + 1)/2 p. */
FORMULA(LOBE_SPREAD);

/* The error of the density of a diffuse lobe by that of its chance, which is multiplied by a cosine. */
FORMULA(DIFFUSE_SPREAD);

/* The rounding of the density of a glossy lobe in fixed point: half a unit of the height. Derived with LOBE_DENSITY.
 * Needed: .5 of 2 U. Unseen: small. */
#define BOUND_LOBE_DENSITY_UNITS (2 * SURE_UNIT)

/* The error of the colour times the cosine by that of a textured colour. */
FORMULA(DIFFUSE_COLOUR);

/* The rounding of the colour times the cosine in fixed point: half a unit. Derived with DIFFUSE_COLOUR. Needed: .5 of
 * 2 U. Unseen: small. */
#define BOUND_DIFFUSE_UNITS (2 * SURE_UNIT)

/* The rounding of the density of a diffuse lobe, its chance times the cosine. In doubles: u for the product. In fixed
 * point: 2^-61. Needed: 1.1 of 4 u. Unseen: small. */
#define BOUND_DIFFUSE_DENSITY_ROUNDING P2M(51)

/* The error of the density of a diffuse lobe: the error of the cosine, times the chance. */
FORMULA(DIFFUSE_DENSITY);

/* ---- reflectance over density, see reflectance_error() ---- */

/* The factor of the numerator over D^2 in reflectance_error(): D/(D - e), and D > 16 e, so 16/15. The rest covers the
 * roundings of the bound itself. */
#define BOUND_SHARE_QUOTIENT 1.125

/* The least density that is used as a divisor, in multiples of its error. Chosen together with SHARE_QUOTIENT. Unseen:
 * choice. */
#define BOUND_SHARE_KNOWN 16

/* The least density that is decided; the range of fixed-point densities ends at 2^-126. A choice, as is the largest
 * density, 10^15. Unseen: choice. */
#define BOUND_SHARE_LEAST P2M(40)

/* The relative rounding of reflectance over density. In doubles: 4 u for the reflectance, three products and a sum; 4 u
 * for the density, two products and two sums; 2 u for an inverse and a product. In fixed point: 2^-59. Needed: 10.1 of
 * 16 u. Unseen: small. */
#define BOUND_SHARE_ROUNDING P2M(49)

/* The rounding of reflectance over density in fixed point: half a unit. Needed: .5 of 1 U. Unseen: small. */
#define BOUND_SHARE_UNIT SURE_UNIT

/* The error of reflectance over density by that of p, times the density. */
FORMULA(SHARE_POWER);

/* The error of reflectance over density by that of the cosine, times the density. */
FORMULA(SHARE_COSINE);

/* The error of the reflectance other than by p and the cosine. */
FORMULA(SHARE_REFLECTED);

/* The error of the density other than by p and the cosine, times reflectance over density. */
FORMULA(SHARE_DENSITY);

#endif
