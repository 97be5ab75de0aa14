/* box.h - intersections with boxes, for boxes and grids. */
#ifndef TIA_RENDER_GEOMETRY_BOX_H
#define TIA_RENDER_GEOMETRY_BOX_H

#include "shape.h"

/* A ray relative to the two planes of a box that are perpendicular to one axis. */
struct box_axis {
    num_length enter, leave; /* distances to the planes, measured along the axis */
    num_unit speed;          /* |d|, the speed of approach */
    bool backward;
};

struct box_axis box_axis(num_length min, num_length max, num_length origin, num_unit direction);

/* Intersects a ray with the box; false if no intersection has 0 <= t <= limit. The element is the face: twice the axis,
 * plus 1 for the maximum. *inside is set if the ray starts inside; the intersection is then where the ray leaves the
 * box. */
bool box_intersect(const struct prepared_box *box, const struct ray *ray, num_length limit,
                   struct intersection *intersection, bool *inside);

/* Sets the outward normal of a face. */
void box_surface(uint32_t face, struct surface *surface);
/* Gives the surface coordinates of a point on a face. */
void box_uv(const struct prepared_box *box, struct num_point point, uint32_t face, num_length uv[2]);

#endif
