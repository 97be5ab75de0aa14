/* vectors.h - bounds of vectors and of numbers with bounds: vector_tmpl.h, interval_tmpl.h, direction_tmpl.h,
 * power_tmpl.h. */
#ifndef TIA_SIMD_RAYS_BOUNDS_VECTORS_H
#define TIA_SIMD_RAYS_BOUNDS_VECTORS_H

/* The largest distance of two unit vectors whose angle has the sine x < 1/16, over x. Proved: rays_forms.g (turned). */
#define BOUND_UNIT_CHORD (1 + P2M(10))

/* The roundings of v/|v| by a double and by num_normalise. Proved by doubles: rays_forms.g (unit), 5 u; there: 2^-58.
 * Unseen: small. */
#define BOUND_UNIT_ROUNDING (SURE_NORMAL * SURE_EPS)

/* The rounding of a dot product of two unit vectors. By doubles: 4 u of the sum of the products' sizes, which is 1 at
 * most, for the conversion of one vector's components, a product and two sums; u for the other vector's conversion.
 * There: half of v, and lengths that are 2^-57 off 1. 6 u of 16. */
#define BOUND_COSINE P2M(49)

/* The error of a fixed-point direction that is converted: u of each component, so u of its length, which is 1. 1 of 4
 * u; where its axis is turned by a fixed-point rotation of another kind, that is the same number there. */
#define BOUND_CONVERTED P2M(51)

/* The rounding of a given number that is converted, as a part of it: half a unit in the last place. Unseen: small. */
#define BOUND_GIVEN SURE_EPS

/* The rounding of a + b or a - b: u of the sum, which is exact there. 1 of 2 u. Unseen: small. */
#define BOUND_SUM (2 * SURE_EPS)

/* The rounding of a b by doubles: u of the product. 1 of 2 u. Unseen: small. */
#define BOUND_PRODUCT (2 * SURE_EPS)

/* The rounding of a b there: half a unit, of lengths; cosines have finer ones. 1 of 2. Unseen: small. */
#define BOUND_PRODUCT_UNIT SURE_UNIT

/* The rounding of a/b, as a part of the quotient. By doubles: u; there: 2^-59. 1.1 of 8 u. Unseen: small. */
#define BOUND_QUOTIENT P2M(50)

/* The least divisor that is divided by, in its errors: it is known to half of itself, so that it is not 0. A choice:
 * the quotient's bound holds of any. Unseen: choice. */
#define BOUND_DIVISOR_KNOWN 2

/* The rounding of a/b there: half a unit. 1 of 2. Unseen: small. */
#define BOUND_QUOTIENT_UNIT SURE_UNIT

/* The rounding of sqrt(a) by doubles: u of the root. 1 of 4 u. Unseen: small. */
#define BOUND_ROOT (4 * SURE_EPS)

/* The rounding of sqrt(a) there, which is cut to a unit. Unseen: small. */
#define BOUND_ROOT_UNIT SURE_UNIT

/* The error of a + b, (a + b) - (a' + b'): that of each of the terms. */
FORMULA(INTERVAL_SUM);

/* The error of a b: a b - a' b' = a (b - b') + b (a - a') - (a - a') (b - b'). */
FORMULA(INTERVAL_PRODUCT);

/* The error of a/b: a/b - a'/b' = ((a - a') - (a/b) (b - b'))/b', |b'| >= |b| - e. */
FORMULA(INTERVAL_QUOTIENT);

/* The error of sqrt a: sqrt a - sqrt a' = (a - a')/(sqrt a + sqrt a') <= e/sqrt a. */
FORMULA(INTERVAL_ROOT);

/* The error of a random direction around z, each coordinate within 2^-50 of the exact one, as direction_tmpl.h derives:
 * sine and cosine are off by 2^-51, the share of an eighth of a turn turns them by pi/4 2^-53, and the product with the
 * radius adds u; fixed-point directions are within 2^-59. The length of three such errors is sqrt 3 2^-50 < 2^-49.
 * Unseen: small. */
#define BOUND_LOCAL P2M(49)

/* The error of x^e by polynomials, see power_tmpl.h: by doubles 2.1e-14, there 1.7e-14, of 5.7e-14. */
#define BOUND_POWER P2M(44)

/* The error of a direction around an axis that is within e: sqrt(14 + 14 + 1) e < 6 e, see around(); and that of the
 * direction around z, as turning keeps lengths. Its roundings are AROUND_ROUNDING. Unseen: small. */
FORMULA(AROUND);

/* The rounding of a direction around an axis. By doubles: k = 1/(1 + |z|) is off by 2 u of itself, x^2 k and x y k by 4
 * u, 1 - x^2 k by 5 u; the sums of three products of these with numbers of 1 at most by 3 u more of sqrt 3: below 8 u a
 * coordinate, sqrt 3 of that together. There: seven halves of v. 14 u of 16. Unseen: small. */
#define BOUND_AROUND_ROUNDING P2M(49)

#endif
