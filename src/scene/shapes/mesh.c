/* mesh.c - instances of meshes; check/mesh.c has the rules of the meshes themselves. */
#include "description.h"

static int check_mesh(const struct check *check, const struct tia_shape *shape)
{
    REQUIRE(shape->mesh < check->scene->mesh_count, "mesh", "must be the index of a mesh");
    return TIA_OK;
}

static void add_bounds(struct hull *hull, const struct tia_scene *scene, const struct tia_shape *shape)
{
    struct cancel never = {0};
    const struct tia_bounds box = tia_bounds_of_mesh(&scene->meshes[shape->mesh], &never);

    tia_hull_add_box(hull, &box);
}

const struct shape_description tia_mesh_description = {
    .what = "an instance",
    .check = check_mesh,
    .add_bounds = add_bounds,
};
