/* box.h - rays and boxes, for all that is made of boxes. */
#ifndef TIA_SHAPE_BOX_H
#define TIA_SHAPE_BOX_H

#include "shape.h"

/* An axis as a ray goes along it. */
struct box_axis {
    num_x enter, leave; /* how far the planes across it are ahead, along the axis */
    num_d pace;         /* |d|, how fast the ray comes nearer to them */
    bool backward;
};

struct box_axis box_axis(num_x min, num_x max, num_x origin, num_d direction);

/* Where the ray meets the box, t <= limit: the element is the face, 2 axis + (0 at the minimum, 1 at the
 * maximum). `inside`: it leaves there, and has not entered at 0 or later. */
bool box_meet(const struct prepared_box *box, const struct ray *ray, num_x limit, struct crossing *crossing,
              bool *inside);

/* The outward normal of a face, and the surface coordinates in it. */
void box_surface(uint32_t face, struct surface *surface);
void box_uv(const struct prepared_box *box, struct num_point point, uint32_t face, num_x uv[2]);

#endif
