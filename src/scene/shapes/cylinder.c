#include "description.h"

static int check_cylinder(const struct check *check, const struct tia_shape *shape)
{
    const struct tia_cylinder *c = &shape->cylinder;

    REQUIRE(c->radius >= TIA_RADIUS_MIN, "radius", CHECK_RADIUS);
    REQUIRE(tia_check_are_apart(c->base, c->top), "top", "must be at least 2^-10 from the base");
    return TIA_OK;
}

static void add_bounds(struct hull *hull, const struct tia_scene *scene, const struct tia_shape *shape)
{
    const struct tia_cylinder *c = &shape->cylinder;

    (void)scene;
    tia_hull_add_ends(hull, c->base, c->top, c->radius, c->radius);
}

const struct shape_description tia_cylinder_description = {
    .word = "cylinder",
    .what = "a cylinder",
    .fields = {NEEDED(cylinder, base, VEC3), NEEDED(cylinder, top, VEC3), NEEDED(cylinder, radius, Q16),
               OPTIONAL(cylinder, capped, FLAG)},
    .check = check_cylinder,
    .add_bounds = add_bounds,
};
