/* ranges.h - the bounds that the rasteriser's formats and filters depend on, each in one place, with its reason. The
 * table in <tia/raster.h> has those of whole quantities. `make prove` puts these numbers into tests/proofs/raster_*.g,
 * which show that they suffice; tests/test_raster_ranges.c draws polygons that reach them, and checks that any beyond
 * are refused.
 *
 * The numbers are bits of absolute values. A corner may be a direction, twice as large; D's components have a pixel's
 * place, of at most 2^13 x 2^13 pixels with 4 x 4 samples. A quantity is a sum of products, bounded term by term, so
 * that no partial sum is larger either. */
#ifndef TIA_RASTER_RANGES_H
#define TIA_RASTER_RANGES_H

#define RASTER_POINT 40  /* a point's coordinate in perspective */
#define RASTER_PIXEL 30  /* D: at most; (2 i + 1 - W) H n^2 and the like, W and H up to 2^13, n up to 4 */
#define RASTER_NORMAL 83 /* q x q: two products of directions */
#define RASTER_EDGE 115  /* (q x q).D: three of those with D */
#define RASTER_PLANE 117 /* N.D, N = sum of h_i (q_j x q_k), h_i 0 or 1: three sums of three */
#define RASTER_DET 126   /* q.(q x q) */
#define RASTER_ORDER 243 /* N.D det */
#define FLAT_POINT 29    /* a point's coordinate where the projection is orthographic, and half of its h */
#define FLAT_NORMAL 61   /* the same for the normal: w is a coordinate, too */
#define FLAT_EDGE 93
#define FLAT_PLANE 125
#define FLAT_DET 93
#define FLAT_ORDER 218

/* Polygons with coordinates up to m need 64 bits where m^2 (|D.x| + |D.y| + |D.w|) is at most 2^NARROW_SQUARE. A normal
 * has at most 2 m^2 in each component. N, linear in each coordinate, is largest where all are m or -m: of three points
 * it is twice the area of a triangle in a square of side 2 m, at most 4 m^2; of a and b with a direction d it is (b -
 * a) x d, at most 4 m^2; and of a with two directions their product. So f = N.D is at most 2^63, and below it as m is
 * one less. test_raster_ranges.c tests all 512 corners of that space, and the triangle that needs all of it. */
#define NARROW_SQUARE 61

/* Error bound of nearness in its units: at the first pixel of a run, and after 8191 steps. If two values differ by more
 * than twice that, the exact ones are ordered in the same way. */
#define DEPTH_ERROR 16393
#define DEPTH_UNSURE (INT32_C(2) * DEPTH_ERROR)

/* Error bound of an edge's position in a row, in 2^-WALKER_BITS of a pixel, after 8192 rows. The first position is
 * below 2^(WALKER_FIRST + 1) pixels, a step below 2^(WALKER_STEP + 1), or the edge is bisected. */
#define WALKER_BITS 31
#define WALKER_FIRST 29
#define WALKER_STEP 16
#define WALKER_ERROR 8198

/* Error bound of a corner's position in the image, for the box around a polygon, in 2^-16 of a pixel. */
#define BOX_MARGIN 2

/* Interpolation: where the weights, cut to 60 bits, add up to at least 2^BLEND_LEAST, the value with BLEND_BITS
 * fraction bits is off by less than BLEND_UNSURE. */
#define BLEND_BITS 20
#define BLEND_LEAST 54
#define BLEND_UNSURE 2

/* The relative error of tia_raster_distance, apart from half a unit, is below 2^-DISTANCE_BITS. */
#define DISTANCE_BITS 58

_Static_assert(DISTANCE_BITS == 58, "as <tia/raster.h> says");
_Static_assert(RASTER_DET < 127 && RASTER_PLANE < 127 && FLAT_PLANE < 127 && FLAT_DET < 127, "these fit 128 bits");
_Static_assert(RASTER_ORDER < 255 && FLAT_ORDER < 255, "these fit 256 bits");
_Static_assert(NARROW_SQUARE + 2 <= 63, "and these 64");

#endif
