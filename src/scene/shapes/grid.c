/* grid.c - instances of grids; check/mesh.c has the rules of the grids themselves. */
#include "description.h"

/* Returns the end of a grid along an axis. The end fits Q16.16; the grid's size may not. */
static tia_q16 end_of(tia_q16 corner, uint16_t size, tia_q16 cell)
{
    return (tia_q16)(corner + (int64_t)size * cell);
}

static int check_grid(const struct check *check, const struct tia_shape *shape)
{
    REQUIRE(shape->grid < check->scene->grid_count, "grid", "must be the index of a grid");
    return TIA_OK;
}

static void add_bounds(struct hull *hull, const struct tia_scene *scene, const struct tia_shape *shape)
{
    const struct tia_grid *g = &scene->grids[shape->grid];
    const uint16_t *n = g->size;
    struct tia_vec3 c = g->corner;

    tia_hull_add_box(
        hull,
        &(struct tia_bounds){c, {end_of(c.x, n[0], g->cell), end_of(c.y, n[1], g->cell), end_of(c.z, n[2], g->cell)}});
}

const struct shape_description tia_grid_description = {
    .what = "an instance",
    .check = check_grid,
    .add_bounds = add_bounds,
};
