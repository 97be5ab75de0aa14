#include "description.h"

static int check_plane(const struct check *check, const struct tia_shape *shape)
{
    REQUIRE(!shape->transform, "transform", "must be 0 for a plane");
    REQUIRE(tia_check_is_direction(&shape->plane.normal), "normal", CHECK_LENGTH);
    REQUIRE(tia_check_is_near(check, shape->plane.point, 0), "point", CHECK_FAR);
    return TIA_OK;
}

const struct shape_description tia_plane_description = {
    .word = "plane",
    .what = "a plane",
    .fields = {OPTIONAL(plane, point, VEC3), NEEDED(plane, normal, DIR3)},
    .check = check_plane,
};
