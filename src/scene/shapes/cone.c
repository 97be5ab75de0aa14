#include "description.h"

_Static_assert(offsetof(struct tia_cone, top_radius) == offsetof(struct tia_cone, base_radius) + sizeof(tia_q16),
               "the radii are two numbers of one field in scene files");

static int check_cone(const struct check *check, const struct tia_shape *shape)
{
    const struct tia_cone *c = &shape->cone;

    REQUIRE(c->base_radius == 0 || c->base_radius >= TIA_RADIUS_MIN, "base_radius", "must be 0 or at least 2^-10");
    REQUIRE(c->top_radius == 0 || c->top_radius >= TIA_RADIUS_MIN, "top_radius", "must be 0 or at least 2^-10");
    REQUIRE(c->base_radius != c->top_radius, "top_radius", "must differ from the base's");
    REQUIRE(tia_check_are_apart(c->base, c->top), "top", "must be at least 2^-10 from the base");
    return TIA_OK;
}

static void add_bounds(struct hull *hull, const struct tia_scene *scene, const struct tia_shape *shape)
{
    const struct tia_cone *c = &shape->cone;

    (void)scene;
    tia_hull_add_ends(hull, c->base, c->top, c->base_radius, c->top_radius);
}

const struct shape_description tia_cone_description = {
    .word = "cone",
    .what = "a cone",
    .fields = {NEEDED(cone, base, VEC3), NEEDED(cone, top, VEC3), FIELD("radii", cone, base_radius, Q16, true),
               FIELD(NULL, cone, top_radius, Q16, false), OPTIONAL(cone, capped, FLAG)},
    .check = check_cone,
    .add_bounds = add_bounds,
};
