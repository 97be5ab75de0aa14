/* ranges.h - the bounds on which the rasteriser's formats and filters depend, with their reasons. The table in
 * <tia/raster.h> has the bounds of whole quantities. `make prove` inserts these numbers into tests/proofs/raster_*.g,
 * which prove that they suffice; tests/test_raster_ranges.c draws polygons that reach them, and checks that polygons
 * beyond them are out of range.
 *
 * The numbers are lengths of absolute values in bits. A corner that is a direction may be twice as large as a point.
 * Quantities are sums of products, bounded term by term, so no partial sum is larger either. */
#ifndef TIA_RASTER_RANGES_H
#define TIA_RASTER_RANGES_H

#define RASTER_POINT 40  /* coordinate of a point in perspective */
#define RASTER_PIXEL 30  /* component of D: at most (2 i + 1 - W) H n^2 or the like; W and H up to 2^13, n up to 4 */
#define RASTER_NORMAL 83 /* q x q: two products of directions */
#define RASTER_EDGE 115  /* (q x q).D: three products of a normal with D */
#define RASTER_PLANE 117 /* N.D, N = sum of h_i (q_j x q_k), h_i 0 or 1: three products of a sum of three with D */
#define RASTER_DET 126   /* q.(q x q) */
#define RASTER_ORDER 243 /* N.D det */
#define FLAT_POINT 29    /* orthographic views: coordinate of a point, and half of its h */
#define FLAT_NORMAL 61   /* normal in orthographic views, where w is a coordinate, too */
#define FLAT_EDGE 93
#define FLAT_PLANE 125
#define FLAT_DET 93
#define FLAT_ORDER 218

/* For polygons with coordinates of at most m, 64 bits suffice if m^2 (|D.x| + |D.y| + |D.w|) is at most
 * 2^NARROW_SQUARE. Each component of a side's normal is at most 2 m^2. The plane's N is linear in each coordinate, so
 * it is largest where all coordinates are m or -m. For three points, a component of N is twice the area of a triangle
 * in a square of side 2 m: at most 4 m^2. For points a and b and a direction d, it is a component of (b - a) x d: at
 * most 4 m^2. For a point and two directions, it is a component of the directions' cross product. So f = N.D is at most
 * 2^63, and below 2^63 since the grid's limit is smaller than m by one. test_raster_ranges.c tests all 512 combinations
 * of m and -m, and the triangle that needs all 64 bits. */
#define NARROW_SQUARE 61

/* Error bound of nearness, in its units, over a run of up to 8191 steps. Two values that differ by more than
 * DEPTH_UNSURE are in the same order as the exact ones. */
#define DEPTH_ERROR 16393
#define DEPTH_UNSURE (INT32_C(2) * DEPTH_ERROR)

/* WALKER_ERROR is the error bound of an edge's position in a row, in 2^-WALKER_BITS of a pixel, after 8192 rows. An
 * edge is bisected unless its first position is below 2^(WALKER_FIRST + 1) pixels and its step below 2^(WALKER_STEP +
 * 1). */
#define WALKER_BITS 31
#define WALKER_FIRST 29
#define WALKER_STEP 16
#define WALKER_ERROR 8198

/* Error bound of a corner's position in the image, for the box around a polygon, in 2^-16 of a pixel. */
#define BOX_MARGIN 2

/* Interpolation: if the sum of the weights, cut to 60 bits, is at least 2^BLEND_LEAST, the error of the value is below
 * BLEND_UNSURE units of 2^-BLEND_BITS. */
#define BLEND_BITS 20
#define BLEND_LEAST 54
#define BLEND_UNSURE 2

/* The relative error of tia_raster_distance, apart from half a unit, is below 2^-DISTANCE_BITS. */
#define DISTANCE_BITS 58

_Static_assert(DISTANCE_BITS == 58, "as distance.h says");
_Static_assert(RASTER_DET < 127 && RASTER_PLANE < 127 && FLAT_PLANE < 127 && FLAT_DET < 127, "these fit 128 bits");
_Static_assert(RASTER_ORDER < 255 && FLAT_ORDER < 255, "these fit 256 bits");
_Static_assert(NARROW_SQUARE + 2 <= 63, "and these 64");

#endif
