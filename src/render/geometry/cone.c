/* cone.c - cones, whole and cut off, see round.c. */
#include "round.h"

void shape_cone(struct shape *shape, const struct tia_cone *cone)
{
    const struct round_ends ends = {cone->base, cone->top, cone->base_radius, cone->top_radius};

    round_prepare(shape, &ends, cone->capped);
}
