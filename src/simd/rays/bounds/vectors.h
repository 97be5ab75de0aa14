/* vectors.h - bounds of vectors and of numbers with bounds: vector_tmpl.h, interval_tmpl.h, direction_tmpl.h,
 * power_tmpl.h. A prime marks a fixed-point value. */
#ifndef TIA_SIMD_RAYS_BOUNDS_VECTORS_H
#define TIA_SIMD_RAYS_BOUNDS_VECTORS_H

/* The largest distance between two unit vectors, divided by the sine x < 1/16 of their angle. Proved: rays_forms.g
 * (turned). */
#define BOUND_UNIT_CHORD (1 + P2M(10))

/* The rounding of v/|v|. In doubles: 5 u, proved: rays_forms.g (unit), and u more where v is a difference. In fixed
 * point: 2^-58. Needed: 6.1 of 8 u. Unseen: small. */
#define BOUND_UNIT_ROUNDING (SURE_NORMAL * SURE_EPS)

/* The rounding of the dot product of two unit vectors. In doubles: u each for the conversions of both vectors, a
 * product and two sums, relative to the sum of the products' sizes, which is 1 at most. In fixed point: half of 2^-62,
 * and lengths that differ from 1 by 2^-57. Needed: 5.1 of 16 u. */
#define BOUND_COSINE P2M(49)

/* The error of a fixed-point direction that is converted to doubles: u of each component, so u of its length, which is
 * 1. Needed: 1 of 4 u. */
#define BOUND_CONVERTED P2M(51)

/* The relative rounding of a constant that is converted to a double: u. Unseen: small. */
#define BOUND_GIVEN SURE_EPS

/* The rounding of a + b or a - b. In doubles: u of the sum. In fixed point: none. Needed: 1 of 2 u. Unseen: small. */
#define BOUND_SUM (2 * SURE_EPS)

/* The rounding of a b in doubles: u of the product. Needed: 1 of 2 u. Unseen: small. */
#define BOUND_PRODUCT (2 * SURE_EPS)

/* The rounding of a b in fixed point: half a unit of a length; the unit of a cosine is smaller. Needed: .5 of 1 U.
 * Unseen: small. */
#define BOUND_PRODUCT_UNIT SURE_UNIT

/* The relative rounding of a/b. In doubles: u. In fixed point: 2^-59. Needed: 1.1 of 8 u. Unseen: small. */
#define BOUND_QUOTIENT P2M(50)

/* The least size of a divisor, in multiples of its error: the fixed-point divisor is then at least half as large, and
 * not 0. A choice, as INTERVAL_QUOTIENT holds for any multiple above 1. Unseen: choice. */
#define BOUND_DIVISOR_KNOWN 2

/* The rounding of a/b in fixed point: half a unit. Needed: .5 of 1 U. Unseen: small. */
#define BOUND_QUOTIENT_UNIT SURE_UNIT

/* The rounding of sqrt(a) in doubles: u of the root. Needed: 1 of 4 u. Unseen: small. */
#define BOUND_ROOT (4 * SURE_EPS)

/* The rounding of sqrt(a) in fixed point, where it is truncated to a unit. Needed: 1 of 1 U. Unseen: small. */
#define BOUND_ROOT_UNIT SURE_UNIT

/* The error of a + b, (a + b) - (a' + b'): the errors of both terms. */
FORMULA(INTERVAL_SUM);

/* The error of a b: a b - a' b' = a (b - b') + b (a - a') - (a - a') (b - b'). */
FORMULA(INTERVAL_PRODUCT);

/* The error of a/b: a/b - a'/b' = ((a - a') - (a/b) (b - b'))/b', |b'| >= |b| - e. */
FORMULA(INTERVAL_QUOTIENT);

/* The error of sqrt a: sqrt a - sqrt a' = (a - a')/(sqrt a + sqrt a'), see root_error(). */
FORMULA(INTERVAL_ROOT);

/* The error of a random direction around z, see direction_tmpl.h. In doubles each coordinate is within 2^-50: sine and
 * cosine are off by 2^-51, the rounding of their angle, at most pi/4, adds pi/4 u, and the product with the radius adds
 * u. Fixed-point directions are within 2^-59. Three coordinates are off by sqrt 3 2^-50 < 2^-49 together. Unseen:
 * small. */
#define BOUND_LOCAL P2M(49)

/* The error of z of a random direction around z, as the cosine between the turned direction and its axis: LOCAL, and in
 * fixed point the roundings of the turned direction and of the dot product, each a unit of 2^-59 or less, and of the
 * axis's length, 2^-57. Needed: 1.02 of 2 times 2^-49. */
#define BOUND_LOCAL_COSINE P2M(48)

/* The error of x^e, see power_tmpl.h: 2.1e-14 in doubles, by polynomials, and 1.7e-14 in fixed point. Needed: 3.8e-14
 * of 5.7e-14. */
#define BOUND_POWER P2M(44)

/* The least x by which the slope of x^n is known, in multiples of n times the error of x. Chosen together with
 * POWER_GROWTH. Unseen: choice. */
#define BOUND_POWER_KNOWN 4

/* The least x by which the slope of x^n is known. A choice. Unseen: choice. */
#define BOUND_POWER_LEAST P2M(20)

/* The growth of x^(n - 1) within the error of x: exp(1/4) = 1.2841, as 4 n e < x. Unseen: hidden. */
#define BOUND_POWER_GROWTH 1.3

/* The slope of x^n, divided by n: POWER_GROWTH x^n/x, where x^n is within POWER. Unseen: hidden. */
FORMULA(POWER_STEEP);

/* The largest turn of a frame around an axis, in multiples of the axis's error e <= 1: sqrt 2 1.05, see around().
 * Larger e leave the lane undecided, see v3_unit(). Needed: 1.485 of 1.5. */
#define BOUND_AROUND_TURN 1.5

/* The error of a direction around an axis with the error e: AROUND_TURN e, and the error of the direction around z,
 * since a rotation preserves lengths. AROUND_ROUNDING is added for the roundings. Unseen: small. */
FORMULA(AROUND);

/* The rounding of a direction around an axis. In doubles: k = 1/(1 + |z|) has a relative error of 2 u. So x^2 k <= 1
 * and 1 - x^2 k are off by 4 u, and x y k <= 1/2 is off by 2 u. A coordinate is a sum of three products whose sizes add
 * up to 1 at most, so its own roundings are 3 u. The errors of the factors add sqrt(16 + 4) u: less than 8 u in each
 * coordinate, sqrt 3 of that for the direction. In fixed point: halves of 2^-62 and 2^-59 of a quotient. Needed: 14 of
 * 16 u. Unseen: small. */
#define BOUND_AROUND_ROUNDING P2M(49)

#endif
