/* round.h - what cylinders and cones share: everything but their names. */
#ifndef TIA_SHAPE_ROUND_H
#define TIA_SHAPE_ROUND_H

#include "shape.h"

/* The elements: the side and the caps. */
enum { ROUND_SIDE, ROUND_BASE, ROUND_TOP };

/* The ends of the axis and the radii there: a cylinder when they are equal. One may be 0. */
struct round_ends {
    struct tia_vec3 base, top;
    tia_q16 base_radius, top_radius;
};

void round_prepare(struct shape *shape, const struct round_ends *ends, bool capped);

#endif
