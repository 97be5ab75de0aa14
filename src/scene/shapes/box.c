#include "description.h"

static int check_box(const struct check *check, const struct tia_shape *shape)
{
    const struct tia_box *b = &shape->box;

    REQUIRE(b->min.x < b->max.x && b->min.y < b->max.y && b->min.z < b->max.z, "max", "must be above min");
    return TIA_OK;
}

static void add_bounds(struct hull *hull, const struct tia_scene *scene, const struct tia_shape *shape)
{
    (void)scene;
    tia_hull_add_box(hull, &(struct tia_bounds){shape->box.min, shape->box.max});
}

const struct shape_description tia_box_description = {
    .word = "box",
    .what = "a box",
    .fields = {NEEDED(box, min, VEC3), NEEDED(box, max, VEC3)},
    .check = check_box,
    .add_bounds = add_bounds,
};
