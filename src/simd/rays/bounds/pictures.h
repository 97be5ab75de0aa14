/* pictures.h - bounds of camera rays, throughputs, colours and pixels: tracer_tmpl.h, paths.h, pixels_tmpl.h,
 * path_state_tmpl.h. */
#ifndef TIA_SIMD_RAYS_BOUNDS_PICTURES_H
#define TIA_SIMD_RAYS_BOUNDS_PICTURES_H

/* The image's place by doubles: the window's four numbers and x are converted or divided, a product and a sum, 4 u of
 * h, v and the window; times the axes, converted, a product and a sum, 3 u. 7 of 64 u. Unseen: small. */
#define BOUND_CAMERA_PARALLEL P2M(47)

/* There: h and v half a unit each, .71 U, and along two axes .87 U each: 2.45 of 8. Unseen: small. */
#define BOUND_CAMERA_PARALLEL_UNITS (8 * SURE_UNIT)

/* Origins of parallel rays: CAMERA_PARALLEL, CAMERA_PARALLEL_UNITS, and the sum with the eye. */
FORMULA(CAMERA_PARALLEL_ORIGIN);

/* The eye's coordinates are multiples of 2^-32 below 2^17, and converted exactly. 0 of 8 u. */
#define BOUND_CAMERA_EYE P2M(50)

/* As CAMERA_PARALLEL, 7 u, and the depth by the normal: converted both, a product and a difference, 4 u. 7 of 16 u.
 * Unseen: small. */
#define BOUND_CAMERA_WAY P2M(49)

/* There: 2.45 U as above and .87 U of the depth's point: 3.3 of 4. */
#define BOUND_CAMERA_WAY_UNITS (4 * SURE_UNIT)

/* The way to the image's place. */
FORMULA(CAMERA_DIRECTION);

/* A fixed-point origin, converted: u of each coordinate. 1 of 1. Unseen: small. */
#define BOUND_FIRST_ORIGIN P2M(53)

/* A fixed-point direction, converted: u of its length. 1 of 2. Unseen: small. */
#define BOUND_FIRST_DIRECTION P2M(52)

/* ---- throughputs and colours, see tracer_tmpl.h and paths.h ---- */

/* A sample's sum: products and sums there have half a unit each, of a colour, of its product with the throughput and of
 * the sum: 1 of 8; by doubles 2 u of it. */
#define BOUND_COLOUR_UNITS P2M(42)

/* Colour by throughput: the error of either, times the other. */
FORMULA(COLOUR_FAR);

/* Emission and direct light, by the throughput: its error, times the most that the throughput may be. */
FORMULA(COLOUR_OWN);

/* The error of the throughput, times the colour. */
FORMULA(COLOUR_WEIGHT);

/* The cosine to the viewer, by the error of the cosine. */
FORMULA(COLOUR_FACING);

/* A ray that may add `most` adds half of that, give or take as much. */
FORMULA(COLOUR_GIVEN_UP);

/* The most that rays may add when they are given up. A choice: most levels of a pixel stay as they are. */
#define BOUND_GIVEN_UP P2M(8)

/* Rays below 2^-16 are not followed there; this is that limit, not an error. */
#define BOUND_FAINT P2M(16)

/* The throughput's product there: half a unit; 1 of 64. */
#define BOUND_FAINT_UNITS P2M(40)

/* FAINT_UNITS and the error of the throughput. */
FORMULA(FAINT_MARGIN);

/* The most that a ray may bring: 17 + 256 sums of products, u each, are 2^-44 of it; the rest keeps it above what
 * bounds add. */
#define BOUND_BRIGHTEST 1.0625

/* Errors of as many fixed-point sums: half a unit each, 2^-38. 1 of 256. Unseen: small. */
#define BOUND_BRIGHTEST_UNITS P2M(30)

/* 1024 bounces with three additions each, of doubles, are off by 3072 u of the sum. 3 of 4. Unseen: small. */
#define BOUND_SUMMED P2M(41)

/* ---- pixels, see pixels_tmpl.h ---- */

/* A sample that is drawn there is converted: u of 1 at most. 1 of 8 u. Unseen: small. */
#define BOUND_EXACT_SAMPLE P2M(50)

/* A mean there is a sum of quotients by the samples, cut to a unit each, 16 U at most; by doubles 17 u: 1 of 2. */
#define BOUND_PIXEL_MEAN P2M(40)

/* mean n + threshold by doubles: two roundings of 63 at most, 2^-46. 1 of 64. Unseen: small. */
#define BOUND_PIXEL_LEVEL P2M(40)

/* The error of the samples' mean. */
FORMULA(PIXEL_ERROR);

#endif
