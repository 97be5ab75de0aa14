#include "description.h"

static int check_sphere(const struct check *check, const struct tia_shape *shape)
{
    REQUIRE(shape->sphere.radius >= TIA_RADIUS_MIN, "radius", CHECK_RADIUS);
    return TIA_OK;
}

static void add_bounds(struct hull *hull, const struct tia_scene *scene, const struct tia_shape *shape)
{
    (void)scene;
    tia_hull_add_sphere(hull, shape->sphere.centre, shape->sphere.radius);
}

const struct shape_description tia_sphere_description = {
    .word = "sphere",
    .what = "a sphere",
    .fields = {OPTIONAL(sphere, centre, VEC3), NEEDED(sphere, radius, Q16)},
    .check = check_sphere,
    .add_bounds = add_bounds,
};
