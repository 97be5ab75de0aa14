/* solid.c - solids; check/solid.c has the rules of the expressions themselves. */
#include "scene/solid.h"
#include "description.h"

static int check_solid(const struct check *check, const struct tia_shape *shape)
{
    REQUIRE(shape->solid < check->scene->solid_count, "solid", "must be the index of a solid");
    return TIA_OK;
}

static void add_bounds(struct hull *hull, const struct tia_scene *scene, const struct tia_shape *shape)
{
    const struct tia_bounds box = tia_solid_box(scene, &scene->solids[shape->solid]);

    tia_hull_add_box(hull, &box);
}

const struct shape_description tia_solid_description = {
    .what = "a solid",
    .check = check_solid,
    .add_bounds = add_bounds,
};
