#include "description.h"

static bool is_on_line(const struct tia_vec3 p[3])
{
    const int64_t a[3] = {(int64_t)p[1].x - p[0].x, (int64_t)p[1].y - p[0].y, (int64_t)p[1].z - p[0].z};
    const int64_t b[3] = {(int64_t)p[2].x - p[0].x, (int64_t)p[2].y - p[0].y, (int64_t)p[2].z - p[0].z};
    return tia_check_is_on_line(a, b);
}

static int check_triangle(const struct check *check, const struct tia_shape *shape)
{
    REQUIRE(!is_on_line(shape->triangle.corner), "corners", "must not be on one line");
    return TIA_OK;
}

static void add_bounds(struct hull *hull, const struct tia_scene *scene, const struct tia_shape *shape)
{
    (void)scene;
    for (int i = 0; i < 3; i++)
        tia_hull_add_point(hull, shape->triangle.corner[i]);
}

const struct shape_description tia_triangle_description = {
    .word = "triangle",
    .what = "a triangle",
    .fields = {FIELD("a", triangle, corner[0], VEC3, true), FIELD("b", triangle, corner[1], VEC3, true),
               FIELD("c", triangle, corner[2], VEC3, true)},
    .check = check_triangle,
    .add_bounds = add_bounds,
};
