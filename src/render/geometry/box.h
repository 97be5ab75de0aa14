/* box.h - intersections with boxes, for boxes and grids. */
#ifndef TIA_RENDER_GEOMETRY_BOX_H
#define TIA_RENDER_GEOMETRY_BOX_H

#include "shape.h"

/* A ray relative to the two planes of a box across one axis. */
struct box_axis {
    num_length enter, leave; /* distances to the planes along the axis */
    num_unit speed;          /* |d|, the speed of approach */
    bool backward;
};

struct box_axis box_axis(num_length min, num_length max, num_length origin, num_unit direction);

/* Intersects a ray with the box; false: not at 0 <= t <= limit. The element is the face: 2 axis, plus 1 at the maximum.
 * *inside: the ray starts inside, and the intersection is where it leaves the box. */
bool box_intersect(const struct prepared_box *box, const struct ray *ray, num_length limit,
                   struct intersection *intersection, bool *inside);

/* Sets the outward normal of a face. */
void box_surface(uint32_t face, struct surface *surface);
/* Gives the surface coordinates of a point on a face. */
void box_uv(const struct prepared_box *box, struct num_point point, uint32_t face, num_length uv[2]);

#endif
