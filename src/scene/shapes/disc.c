#include "description.h"

static int check_disc(const struct check *check, const struct tia_shape *shape)
{
    REQUIRE(tia_check_is_direction(&shape->disc.normal), "normal", CHECK_LENGTH);
    REQUIRE(shape->disc.radius >= TIA_RADIUS_MIN, "radius", CHECK_RADIUS);
    return TIA_OK;
}

static void add_bounds(struct hull *hull, const struct tia_scene *scene, const struct tia_shape *shape)
{
    const struct tia_dir3 *n = &shape->disc.normal;
    const int64_t normal[3] = {n->x, n->y, n->z};

    (void)scene;
    tia_hull_add_disc(hull, shape->disc.centre, shape->disc.radius, normal);
}

const struct shape_description tia_disc_description = {
    .word = "disc",
    .what = "a disc",
    .fields = {OPTIONAL(disc, centre, VEC3), NEEDED(disc, normal, DIR3), NEEDED(disc, radius, Q16)},
    .check = check_disc,
    .add_bounds = add_bounds,
};
