/* grid.c - grids of cubes, traversed cell by cell after Amanatides and Woo, "A fast voxel traversal algorithm" (1987).
 *
 * Cells are counted in integers. The t of a plane between two cells is computed from the plane's coordinate, not from
 * the t of the previous plane. So the steps of the walk are the planes that the ray meets, sorted by t, and rounding
 * cannot make the walk skip or repeat a cell. The walk has at most as many steps as there are planes. An intersection's
 * element is 6 times the cell plus the face, numbered as in box.h. */
#include "box.h"

struct walker {
    const struct tia_grid *grid;
    num_length corner[3], origin[3], edge;
    num_unit direction[3];
    int32_t at[3];      /* the ray's cell */
    num_length next[3]; /* t at which the ray leaves the cell along each axis */
};

static int step_of(const struct walker *w, int axis)
{
    return w->direction[axis] < 0 ? -1 : 1;
}

/* Returns the t of the plane at the lower side of cell `at` of an axis. */
static num_length plane_at(const struct walker *w, int axis, int32_t at)
{
    return num_div(w->corner[axis] + w->edge * (num_length)at - w->origin[axis], w->direction[axis]);
}

static num_length enters_at(const struct walker *w, int axis)
{
    return plane_at(w, axis, w->at[axis] + (w->direction[axis] < 0));
}

static num_length leaves_at(const struct walker *w, int axis)
{
    return w->direction[axis] == 0 ? NUM_LENGTH_MAX : plane_at(w, axis, w->at[axis] + !(w->direction[axis] < 0));
}

static bool has_cell(const struct walker *w, int axis, int32_t at)
{
    return at >= 0 && at < w->grid->size[axis];
}

/* Finds the ray's cell at t along one axis: the cell entered before t and left at t or later. The rounded point is only
 * the first guess. */
static void find_cell(struct walker *w, int axis, num_length t)
{
    int step = step_of(w, axis);
    num_length along = w->origin[axis] + num_times(t, w->direction[axis]) - w->corner[axis];
    int32_t at = along > 0 ? num_floor(num_ratio(along, w->edge)) : 0, last = (int32_t)w->grid->size[axis] - 1;

    w->at[axis] = at > last ? last : at;
    if (w->direction[axis] != 0) {
        while (has_cell(w, axis, w->at[axis] + step) && leaves_at(w, axis) < t)
            w->at[axis] += step;
        while (has_cell(w, axis, w->at[axis] - step) && enters_at(w, axis) >= t)
            w->at[axis] -= step;
    }
    w->next[axis] = leaves_at(w, axis);
}

static uint32_t cell_index(const struct walker *w)
{
    return ((uint32_t)w->at[2] * w->grid->size[1] + (uint32_t)w->at[1]) * w->grid->size[0] + (uint32_t)w->at[0];
}

static void start(struct walker *w, const struct prepared_grid *grid, const struct ray *ray, num_length t)
{
    *w = (struct walker){.grid = grid->grid,
                         .corner = {grid->corner.x, grid->corner.y, grid->corner.z},
                         .origin = {ray->origin.x, ray->origin.y, ray->origin.z},
                         .edge = grid->cell,
                         .direction = {ray->direction.x, ray->direction.y, ray->direction.z}};
    for (int axis = 0; axis < 3; axis++)
        find_cell(w, axis, t);
}

/* Walks from cell to cell until the material of the next cell, or of the empty space outside, differs from that of the
 * first. False if the walk goes beyond `limit`, or leaves the grid from empty cells. */
static bool go(struct walker *w, num_length limit, struct intersection *intersection)
{
    uint32_t cell = cell_index(w);
    unsigned here = w->grid->cells[cell];

    for (;;) {
        int axis = w->next[1] < w->next[0] ? 1 : 0;
        axis = w->next[2] < w->next[axis] ? 2 : axis;
        uint32_t face = 2 * (uint32_t)axis + (step_of(w, axis) > 0);
        intersection->t = w->next[axis];
        intersection->element = 6 * cell + face;
        if (intersection->t > limit || intersection->t >= NUM_LENGTH_MAX)
            return false;
        w->at[axis] += step_of(w, axis);
        if (!has_cell(w, axis, w->at[axis]))
            return here != 0;
        w->next[axis] = leaves_at(w, axis);
        cell = cell_index(w);
        unsigned there = w->grid->cells[cell];
        if (there != here) {
            intersection->element = there ? 6 * cell + (face ^ 1) : intersection->element;
            return true;
        }
    }
}

static struct prepared_box bounds(const struct prepared_grid *grid)
{
    const uint16_t *n = grid->grid->size;
    struct num_point size = {grid->cell * (num_length)n[0], grid->cell * (num_length)n[1],
                             grid->cell * (num_length)n[2]};

    return (struct prepared_box){grid->corner, num_point_add(grid->corner, size)};
}

static bool intersect(const struct shape *shape, const struct ray *ray, num_length limit,
                      struct intersection *intersection)
{
    const struct prepared_grid *grid = &shape->grid;
    struct prepared_box box = bounds(grid);
    struct walker w;
    bool inside;

    if (!box_intersect(&box, ray, NUM_LENGTH_MAX, intersection, &inside) || (!inside && intersection->t > limit))
        return false;
    start(&w, grid, ray, inside ? 0 : intersection->t);
    if (!inside && grid->grid->cells[cell_index(&w)]) {
        intersection->element += 6 * cell_index(&w);
        return true;
    }
    return go(&w, limit, intersection);
}

static void surface_at(const struct shape *shape, struct num_point point, uint32_t element, struct surface *surface)
{
    (void)shape;
    (void)point;
    box_surface(element % 6, surface);
}

static void uv_at(const struct shape *shape, struct num_point point, uint32_t element, num_length uv[2])
{
    const struct prepared_grid *grid = &shape->grid;
    uint32_t cell = element / 6, row = cell / grid->grid->size[0];
    const num_length at[3] = {(num_length)(cell % grid->grid->size[0]), (num_length)(row % grid->grid->size[1]),
                              (num_length)(row / grid->grid->size[1])};
    struct num_point min = {grid->cell * at[0], grid->cell * at[1], grid->cell * at[2]};

    min = num_point_add(min, grid->corner);
    struct prepared_box box = {min, num_point_add(min, (struct num_point){grid->cell, grid->cell, grid->cell})};
    box_uv(&box, point, element % 6, uv);
}

static void prepare(struct shape *shape, const struct tia_scene *scene, const struct tia_shape *given)
{
    const struct tia_grid *grid = &scene->grids[given->grid];

    shape->grid = (struct prepared_grid){grid, num_point_of(grid->corner), num_length_of(grid->cell)};
}

const struct shape_kind SHAPE_KIND(grid) = {prepare, intersect, shape_occludes, surface_at, uv_at, NULL};
