/* cylinder.c - cylinders: cones with equal radii, see round.c. */
#include "round.h"

void shape_cylinder(struct shape *shape, const struct tia_cylinder *cylinder)
{
    const struct round_ends ends = {cylinder->base, cylinder->top, cylinder->radius, cylinder->radius};

    round_prepare(shape, &ends, cylinder->capped);
}
