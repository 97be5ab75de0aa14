/* cylinder.c - cylinders: cones with equal radii, see round.c. */
#include "round.h"

static void prepare(struct shape *shape, const struct tia_scene *scene, const struct tia_shape *given)
{
    const struct tia_cylinder *c = &given->cylinder;
    struct round_ends ends = {c->base, c->top, c->radius, c->radius, round_fine(scene, given)};

    ends.fine.top_radius = ends.fine.base_radius;
    round_prepare(&shape->cone, &ends, c->capped);
}

const struct shape_kind SHAPE_KIND(cylinder) = {prepare,       round_intersect, shape_occludes,
                                                round_surface, round_uv,        round_chord};
