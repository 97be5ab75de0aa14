/* polygon.h - a polygon in space, convex or not, as triangles. */
#ifndef TIA_SRC_READ_POLYGON_H
#define TIA_SRC_READ_POLYGON_H

#include <tia/vec.h>

/* Ears are searched in a time that grows with the square of the corners: 4096 take milliseconds. */
#define POLYGON_MAX 4096

struct polygon_corner {
    struct tia_vec3 point; /* the caller's; all that follows is the triangulation's */
    int32_t x, y;          /* projected: the polygon runs counterclockwise */
    uint32_t prev, next;   /* among those not cut off yet */
    int8_t turn;           /* 1: to the left, the corner is convex; 0: straight on or back; -1: to the right */
    int8_t ear;            /* 1: may be cut off; 0: may not; -1: not known */
};

struct polygon {
    struct polygon_corner *corners;
    uint32_t left, at;                     /* corners not cut off; where the search goes on */
    uint32_t not_convex, flat, candidates; /* those with turn < 1, turn = 0, ear != 0 */
};

/* Ear clipping: count - 2 triangles, each of three corners in the polygon's order. Those of a simple
 * polygon cover it exactly and none is flat; whatever else - corners on one line, edges that touch or cross - there are
 * as many and the time is as bounded. count is 3..POLYGON_MAX; corners that do not lie in a plane are taken as
 * they appear in the axes' plane in which the polygon is largest. */
void tia_polygon_begin(struct polygon *polygon, struct polygon_corner *corners, uint32_t count);

/* False when there are no more. */
bool tia_polygon_next(struct polygon *polygon, uint32_t triangle[3]);

#endif
