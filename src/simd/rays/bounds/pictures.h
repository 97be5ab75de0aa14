/* pictures.h - bounds of camera rays, throughputs, colours and pixels: tracer_tmpl.h, paths_tmpl.h, pixels_tmpl.h,
 * path_state_tmpl.h, lights.c, samples.c, sure_tile.c. */
#ifndef TIA_SIMD_RAYS_BOUNDS_PICTURES_H
#define TIA_SIMD_RAYS_BOUNDS_PICTURES_H

/* The rounding in doubles of a position in the image, relative to |h|, |v| and the window: 5 u for h and v, by
 * conversions of the window's numbers, the quotient x as a product with a rounded inverse, a product and a sum; 3 u for
 * the axes, a conversion, a product and a sum. Needed: 8 of 64 u. Unseen: small. */
#define BOUND_CAMERA_PARALLEL P2M(47)

/* The rounding of a position in the image in fixed point: half a unit each for h and v, .71 U, and .87 U for each of
 * two points along axes. Needed: 2.45 of 8 U. Unseen: small. */
#define BOUND_CAMERA_PARALLEL_UNITS (8 * SURE_UNIT)

/* The error of the origin of a parallel ray: CAMERA_PARALLEL, CAMERA_PARALLEL_UNITS, and POINT_ROUNDING of the sum with
 * the eye. */
FORMULA(CAMERA_PARALLEL_ORIGIN);

/* The error of the eye: none, as its coordinates are multiples of 2^-32 below 2^17 and converted exactly. Needed: 0 of
 * 8 u. */
#define BOUND_CAMERA_EYE P2M(50)

/* The rounding in doubles of the vector to a position in the image: 8 u, as CAMERA_PARALLEL; and 4 u of the depth times
 * the normal, by two conversions, a product and a difference. Needed: 8 of 16 u. Unseen: small. */
#define BOUND_CAMERA_WAY P2M(49)

/* The rounding of the vector to a position in the image in fixed point: 2.45 U, as CAMERA_PARALLEL_UNITS, and .87 U for
 * the point at the depth. Needed: 3.3 of 4 U. */
#define BOUND_CAMERA_WAY_UNITS (4 * SURE_UNIT)

/* The error of the vector to a position in the image: CAMERA_WAY times the sizes of its parts, and CAMERA_WAY_UNITS. */
FORMULA(CAMERA_DIRECTION);

/* The rounding in doubles of a side's normal, relative to the square of the sizes of the corners' parts: a corner is
 * off by 8 u of these, as CAMERA_WAY. So the difference of two products of corners' coordinates is off by 2 (16 + 1) u
 * and, with its own rounding, by 36 u in each of the three coordinates, sqrt 3 of that in all. Needed: 63 of 128 u.
 * Unseen: small. */
#define BOUND_BEAM_NORMAL P2M(46)

/* The change of N.(P - eye) by the normal's error, BEAM_NORMAL times the largest |P - eye|. Unseen: small. */
FORMULA(BEAM_SIDE);

/* The error of a fixed-point origin that is converted to doubles: u of each coordinate. Needed: 1 of 1 u. Unseen:
 * small. */
#define BOUND_FIRST_ORIGIN P2M(53)

/* The error of a fixed-point vector along a camera ray that is converted to doubles, relative to |v|1: u of each
 * coordinate. Needed: 1 of 2 u. Unseen: small. */
#define BOUND_FIRST_WAY P2M(52)

/* ---- throughputs and colours, see tracer_tmpl.h and paths_tmpl.h ---- */

/* The rounding of a term of a sample's sum. In fixed point: half a unit each for a colour and for its product with the
 * throughput, while the sum is exact. In doubles: 2 u of the sum. Needed: 1 of 8 U. */
#define BOUND_COLOUR_UNITS P2M(42)

/* The error of the background or a light, times the throughput: the error of the throughput, times the colour, which is
 * exact. */
FORMULA(COLOUR_FAR);

/* The error of emission and direct light, times the largest value of the throughput within its error. */
FORMULA(COLOUR_OWN);

/* The error of the throughput, times the emission and direct light. */
FORMULA(COLOUR_WEIGHT);

/* The error of the cosine to the viewer, times the largest component of facing light. */
FORMULA(COLOUR_FACING);

/* The error of a ray that is given up and would have added between 0 and `most`: half of `most`, as half of `most` is
 * added. */
FORMULA(COLOUR_GIVEN_UP);

/* The most that a given-up ray may add to a channel. A choice: most levels of a pixel are still certain with such an
 * error. */
#define BOUND_GIVEN_UP P2M(8)

/* The largest error with which light of a surface is added to a sample. Light with larger errors would leave more
 * pixels open, each of which takes longer than the fixed-point path from this surface on. A choice. Unseen: choice. */
#define BOUND_OWN_UNSURE P2M(9)

/* The throughput below which the fixed-point code does not follow rays, 2^-16: that limit itself, not an error. */
#define BOUND_FAINT P2M(16)

/* The rounding of the throughput's product in fixed point: half a unit. Needed: .5 of 32 U. */
#define BOUND_FAINT_UNITS P2M(40)

/* The error of the throughput that is compared with FAINT: the error of the throughput, and FAINT_UNITS. */
FORMULA(FAINT_MARGIN);

/* The factor for the roundings of the largest colour of a ray: u for each of 17 + 256 sums of products, together 2^-44.
 * The rest keeps the result above any colour plus its error. */
#define BOUND_BRIGHTEST 1.0625

/* The errors of the 17 + 256 fixed-point sums: half a unit each, 2^-38 together. Needed: 2^-38 of 2^-30. Unseen: small.
 */
#define BOUND_BRIGHTEST_UNITS P2M(30)

/* The relative rounding of a path's light: 1024 bounces with three additions of doubles each. Needed: 3072 of 4096 u.
 * Unseen: small. */
#define BOUND_SUMMED P2M(41)

/* ---- pixels, see pixels_tmpl.h ---- */

/* The rounding of a sample that the fixed-point code draws, and that is converted to a double: u of at most 1. Needed:
 * 1 of 8 u. Unseen: small. */
#define BOUND_EXACT_SAMPLE P2M(50)

/* The rounding of the light along a ray that the fixed-point code follows, relative to 1 and to this light: u for its
 * conversion to a double, and u of the sum with the sample's other parts; sums above 1 count as 1. Needed: 2 of 8 u.
 * Unseen: small. */
#define BOUND_EXACT_REST P2M(50)

/* The rounding of a pixel's mean. In doubles: 17 u. In fixed point: a sum of at most 16 quotients by the number of
 * samples, each truncated to a unit. Needed: 16.1 of 32 U. */
#define BOUND_PIXEL_MEAN P2M(40)

/* The rounding of a level before it is truncated, mean n + threshold, in doubles: two roundings of at most 63, 2^-46.
 * Needed: .5 of 32 U. Unseen: small. */
#define BOUND_PIXEL_LEVEL P2M(40)

/* The error of the samples' mean; PIXEL_MEAN is added for its roundings. */
FORMULA(PIXEL_ERROR);

#endif
