/* pictures.h - bounds of camera rays, throughputs, colours and pixels: tracer_tmpl.h, paths.h, pixels_tmpl.h,
 * path_state_tmpl.h. */
#ifndef TIA_SIMD_RAYS_BOUNDS_PICTURES_H
#define TIA_SIMD_RAYS_BOUNDS_PICTURES_H

/* The rounding of a place in the image by doubles: 4 u of h, v and the window, whose four numbers and x are converted
 * or divided, for a product and a sum; 3 u for the axes, converted, a product and a sum. 7 of 64 u. Unseen: small. */
#define BOUND_CAMERA_PARALLEL P2M(47)

/* The rounding of a place in the image there: half a unit each of h and v, .71 U, and .87 U of each of two points along
 * axes: 2.45 of 8. Unseen: small. */
#define BOUND_CAMERA_PARALLEL_UNITS (8 * SURE_UNIT)

/* The error of the origin of a parallel ray: CAMERA_PARALLEL, CAMERA_PARALLEL_UNITS, and POINT_ROUNDING of the sum with
 * the eye. */
FORMULA(CAMERA_PARALLEL_ORIGIN);

/* The error of the eye, whose coordinates are multiples of 2^-32 below 2^17, and converted exactly. 0 of 8 u. */
#define BOUND_CAMERA_EYE P2M(50)

/* The rounding of the way to a place in the image by doubles: as CAMERA_PARALLEL, 7 u; and 4 u of the depth by the
 * normal: converted both, a product and a difference. 7 of 16 u. Unseen: small. */
#define BOUND_CAMERA_WAY P2M(49)

/* The rounding of the way to a place in the image there: 2.45 U as CAMERA_PARALLEL_UNITS has, and .87 U of the depth's
 * point: 3.3 of 4. */
#define BOUND_CAMERA_WAY_UNITS (4 * SURE_UNIT)

/* The error of the way to a place in the image: CAMERA_WAY of its parts, and CAMERA_WAY_UNITS. */
FORMULA(CAMERA_DIRECTION);

/* The error of a fixed-point origin that is converted: u of each coordinate. 1 of 1. Unseen: small. */
#define BOUND_FIRST_ORIGIN P2M(53)

/* The error of a fixed-point direction that is converted: u of its length. 1 of 2. Unseen: small. */
#define BOUND_FIRST_DIRECTION P2M(52)

/* ---- throughputs and colours, see tracer_tmpl.h and paths.h ---- */

/* The rounding of a sample's sum. There: half a unit each of a colour, of its product with the throughput and of the
 * sum: 1 of 8; by doubles: 2 u of the sum. */
#define BOUND_COLOUR_UNITS P2M(42)

/* The error of the background or a light, times the throughput: the colour is exact, so that it is the error of the
 * throughput, times the colour. */
FORMULA(COLOUR_FAR);

/* The error of emission and direct light, times the most that the throughput may be. */
FORMULA(COLOUR_OWN);

/* The error of the throughput, times the emission and direct light. */
FORMULA(COLOUR_WEIGHT);

/* The error of the cosine to the viewer, times the largest component of facing light. */
FORMULA(COLOUR_FACING);

/* The error of a ray that is given up and may add `most`: half of that, as it adds half, give or take as much. */
FORMULA(COLOUR_GIVEN_UP);

/* The most that a ray may add when it is given up. A choice: most levels of a pixel stay as they are. */
#define BOUND_GIVEN_UP P2M(8)

/* The throughput below which rays are not followed there, 2^-16; this is that limit, not an error. */
#define BOUND_FAINT P2M(16)

/* The rounding of the throughput's product there: half a unit; 1 of 64. */
#define BOUND_FAINT_UNITS P2M(40)

/* The error of the throughput that is compared with FAINT: its own, and FAINT_UNITS. */
FORMULA(FAINT_MARGIN);

/* The factor of the most that a ray may bring: 17 + 256 sums of products, u each, are 2^-44 of it; the rest keeps it
 * above what bounds add. */
#define BOUND_BRIGHTEST 1.0625

/* The errors of the 17 + 256 fixed-point sums: half a unit each, 2^-38. 1 of 256. Unseen: small. */
#define BOUND_BRIGHTEST_UNITS P2M(30)

/* The rounding of a path's light, as a part of it: 1024 bounces with three additions each, of doubles, are off by 3072
 * u of the sum. 3 of 4. Unseen: small. */
#define BOUND_SUMMED P2M(41)

/* ---- pixels, see pixels_tmpl.h ---- */

/* The rounding of a sample that is drawn there and converted: u of 1 at most. 1 of 8 u. Unseen: small. */
#define BOUND_EXACT_SAMPLE P2M(50)

/* The rounding of a pixel's mean. There: a sum of quotients by the samples, cut to a unit each, 16 U at most; by
 * doubles: 17 u. 1 of 2. */
#define BOUND_PIXEL_MEAN P2M(40)

/* The rounding of a level before it is cut, mean n + threshold, by doubles: two roundings of 63 at most, 2^-46. 1 of
 * 64. Unseen: small. */
#define BOUND_PIXEL_LEVEL P2M(40)

/* The error of the samples' mean; PIXEL_MEAN is added. */
FORMULA(PIXEL_ERROR);

#endif
