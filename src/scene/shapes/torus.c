#include "description.h"

static int check_torus(const struct check *check, const struct tia_shape *shape)
{
    const struct tia_torus *t = &shape->torus;

    REQUIRE(tia_check_is_direction(&t->axis), "axis", CHECK_LENGTH);
    REQUIRE(t->minor >= TIA_RADIUS_MIN, "minor", CHECK_RADIUS);
    REQUIRE((int64_t)t->major - t->minor >= TIA_RADIUS_MIN, "major", "must be at least 2^-10 above minor");
    return TIA_OK;
}

static void add_bounds(struct hull *hull, const struct tia_scene *scene, const struct tia_shape *shape)
{
    const struct tia_torus *t = &shape->torus;
    const int64_t axis[3] = {t->axis.x, t->axis.y, t->axis.z};

    (void)scene;
    tia_hull_add_ring(hull, t->centre, t->major, t->minor, axis);
}

const struct shape_description tia_torus_description = {
    .word = "torus",
    .what = "a torus",
    .fields = {OPTIONAL(torus, centre, VEC3), NEEDED(torus, axis, DIR3), NEEDED(torus, major, Q16),
               NEEDED(torus, minor, Q16)},
    .check = check_torus,
    .add_bounds = add_bounds,
};
