/* cone.c - cones and truncated cones, see round.c. */
#include "round.h"

static void prepare(struct shape *shape, const struct tia_scene *scene, const struct tia_shape *given)
{
    const struct tia_cone *c = &given->cone;
    const struct round_ends ends = {c->base, c->top, c->base_radius, c->top_radius, round_fine(scene, given)};

    round_prepare(&shape->cone, &ends, c->capped);
}

const struct shape_kind SHAPE_KIND(cone) = {prepare,       round_intersect, shape_occludes,
                                            round_surface, round_uv,        round_chord};
