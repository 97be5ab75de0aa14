/* box.h - rays and boxes, for all that is made of boxes. */
#ifndef TIA_RENDER_GEOMETRY_BOX_H
#define TIA_RENDER_GEOMETRY_BOX_H

#include "shape.h"

/* An axis as a ray goes along it. */
struct box_axis {
    num_length enter, leave; /* how far the planes across it are ahead, along the axis */
    num_unit pace;           /* |d|, how fast the ray comes nearer to them */
    bool backward;
};

struct box_axis box_axis(num_length min, num_length max, num_length origin, num_unit direction);

/* Where the ray meets the box, t <= limit: the element is the face, 2 axis + (0 at the minimum, 1 at the
 * maximum). `inside`: it leaves there, and has not entered at 0 or later. */
bool box_intersect(const struct prepared_box *box, const struct ray *ray, num_length limit,
                   struct intersection *intersection, bool *inside);

/* The outward normal of a face, and the surface coordinates in it. */
void box_surface(uint32_t face, struct surface *surface);
void box_uv(const struct prepared_box *box, struct num_point point, uint32_t face, num_length uv[2]);

#endif
