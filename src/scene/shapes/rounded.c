#include "description.h"

static int check_rounded(const struct check *check, const struct tia_shape *shape)
{
    const struct tia_rounded *b = &shape->rounded;
    int64_t least = 2 * (int64_t)b->radius;

    REQUIRE(b->radius >= TIA_RADIUS_MIN, "radius", CHECK_RADIUS);
    REQUIRE((int64_t)b->max.x - b->min.x >= least && (int64_t)b->max.y - b->min.y >= least &&
                (int64_t)b->max.z - b->min.z >= least,
            "max", "must be at least twice the radius above min");
    return TIA_OK;
}

/* The shape is the hull of the balls in its corners. */
static void add_bounds(struct hull *hull, const struct tia_scene *scene, const struct tia_shape *shape)
{
    const struct tia_rounded *b = &shape->rounded;
    tia_q16 r = b->radius;

    (void)scene;
    for (int i = 0; i < 8; i++) {
        struct tia_vec3 corner = {i & 1 ? b->max.x - r : b->min.x + r, i & 2 ? b->max.y - r : b->min.y + r,
                                  i & 4 ? b->max.z - r : b->min.z + r};
        tia_hull_add_sphere(hull, corner, r);
    }
}

const struct shape_description tia_rounded_description = {
    .word = "rounded",
    .what = "a rounded box",
    .fields = {NEEDED(rounded, min, VEC3), NEEDED(rounded, max, VEC3), NEEDED(rounded, radius, Q16)},
    .check = check_rounded,
    .add_bounds = add_bounds,
};
