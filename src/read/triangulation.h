/* triangulation.h - triangulation of a polygon in space, convex or not. */
#ifndef TIA_READ_TRIANGULATION_H
#define TIA_READ_TRIANGULATION_H

#include <tia/vec.h>

/* Largest number of corners: ear clipping takes time quadratic in it, milliseconds for 4096. */
#define POLYGON_MAX 4096

struct polygon_corner {
    struct tia_vec3 point; /* set by the caller; the triangulation uses the rest */
    int32_t x, y;          /* projected so that the polygon runs counterclockwise */
    uint32_t prev, next;   /* neighbours among the corners not cut off yet */
    int8_t orientation;    /* 1: left turn, a convex corner; 0: straight on or back; -1: right turn */
    int8_t ear;            /* 1: can be cut off; 0: cannot; -1: unknown */
};

struct polygon {
    struct polygon_corner *corners;
    uint32_t left, at; /* number of corners left; the corner at which the search for an ear continues */
    uint32_t not_convex, flat, candidates; /* numbers of corners left: orientation < 1; orientation = 0; ear != 0 */
};

/* Begins to triangulate a polygon by ear clipping: count - 2 triangles, whose corners are in the polygon's order. The
 * triangles of a simple polygon cover it exactly, and none is degenerate. Any other polygon (collinear corners, edges
 * that touch or cross) gives the same number of triangles in the same bounded time. count is 3..POLYGON_MAX. The
 * polygon is projected to the coordinate plane in which its area is largest, so its corners need not be coplanar. */
void tia_polygon_begin(struct polygon *polygon, struct polygon_corner *corners, uint32_t count);

/* Writes the indices of the next triangle's corners. Returns false if there are no more triangles. */
bool tia_polygon_next(struct polygon *polygon, uint32_t triangle[3]);

#endif
