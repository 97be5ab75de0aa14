/* grid.c - cubes in rows, walked cell by cell as by Amanatides and Woo, "A fast voxel traversal
 * algorithm" (1987).
 *
 * Cells are counted in integers, and the t of a plane between them comes from the plane's coordinate, not
 * from the t of the plane before it: so the planes that a ray meets, sorted by t, are the steps of its
 * walk, and no rounding makes it skip a cell or see one twice. The walk ends after as many steps as there
 * are planes. Element: 6 times the cell, plus the face as a box has it. */
#include "box.h"

struct walker {
    const struct tia_grid *grid;
    num_x corner[3], origin[3], edge;
    num_d direction[3];
    int at[3];     /* the cell */
    num_x next[3]; /* where the ray leaves it along each axis */
};

static int step_of(const struct walker *w, int axis)
{
    return w->direction[axis] < 0 ? -1 : 1;
}

/* Where the ray meets the plane below cell `at` of an axis. */
static num_x plane_at(const struct walker *w, int axis, int at)
{
    return num_over(w->corner[axis] + w->edge * (num_x)at - w->origin[axis], w->direction[axis]);
}

static num_x enters_at(const struct walker *w, int axis)
{
    return plane_at(w, axis, w->at[axis] + (w->direction[axis] < 0));
}

static num_x leaves_at(const struct walker *w, int axis)
{
    return w->direction[axis] == 0 ? NUM_X_MOST : plane_at(w, axis, w->at[axis] + !(w->direction[axis] < 0));
}

static bool has_cell(const struct walker *w, int axis, int at)
{
    return at >= 0 && at < w->grid->size[axis];
}

/* The cell of an axis where the ray is at t: it has been entered before t, and is left at t or later. What
 * rounding makes of the point itself is only a first guess. */
static void find_cell(struct walker *w, int axis, num_x t)
{
    int step = step_of(w, axis), last = w->grid->size[axis] - 1;
    num_x along = w->origin[axis] + num_times(t, w->direction[axis]) - w->corner[axis];
    int32_t at = along > 0 ? num_floor(num_ratio(along, w->edge)) : 0;

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

static void start(struct walker *w, const struct prepared_grid *grid, const struct ray *ray, num_x t)
{
    *w = (struct walker){.grid = grid->grid,
                         .corner = {grid->corner.x, grid->corner.y, grid->corner.z},
                         .origin = {ray->origin.x, ray->origin.y, ray->origin.z},
                         .edge = grid->cell,
                         .direction = {ray->direction.x, ray->direction.y, ray->direction.z}};
    for (int axis = 0; axis < 3; axis++)
        find_cell(w, axis, t);
}

/* From one cell to the next until what fills them changes. */
static bool go(struct walker *w, num_x limit, struct crossing *crossing)
{
    uint32_t cell = cell_index(w);
    unsigned here = w->grid->cells[cell];

    for (;;) {
        int axis = w->next[1] < w->next[0] ? 1 : 0;
        axis = w->next[2] < w->next[axis] ? 2 : axis;
        uint32_t face = 2 * (uint32_t)axis + (step_of(w, axis) > 0);
        crossing->t = w->next[axis];
        crossing->element = 6 * cell + face;
        if (crossing->t > limit || crossing->t >= NUM_X_MOST)
            return false;
        w->at[axis] += step_of(w, axis);
        if (!has_cell(w, axis, w->at[axis]))
            return here != 0;
        w->next[axis] = leaves_at(w, axis);
        cell = cell_index(w);
        unsigned there = w->grid->cells[cell];
        if (there != here) {
            crossing->element = there ? 6 * cell + (face ^ 1) : crossing->element;
            return true;
        }
    }
}

static struct prepared_box bounds(const struct prepared_grid *grid)
{
    const uint16_t *n = grid->grid->size;
    struct num_point size = {grid->cell * (num_x)n[0], grid->cell * (num_x)n[1], grid->cell * (num_x)n[2]};

    return (struct prepared_box){grid->corner, num_point_add(grid->corner, size)};
}

static bool intersect(const struct shape *shape, const struct ray *ray, num_x limit, struct crossing *crossing)
{
    const struct prepared_grid *grid = &shape->grid;
    struct prepared_box box = bounds(grid);
    struct walker w;
    bool inside;

    if (!box_meet(&box, ray, NUM_X_MOST, crossing, &inside) || (!inside && crossing->t > limit))
        return false;
    start(&w, grid, ray, inside ? 0 : crossing->t);
    if (!inside && grid->grid->cells[cell_index(&w)]) {
        crossing->element += 6 * cell_index(&w);
        return true;
    }
    return go(&w, limit, crossing);
}

static void surface_at(const struct shape *shape, struct num_point point, uint32_t element, struct surface *surface)
{
    (void)shape;
    (void)point;
    box_surface(element % 6, surface);
}

static void uv_at(const struct shape *shape, struct num_point point, uint32_t element, num_x uv[2])
{
    const struct prepared_grid *grid = &shape->grid;
    uint32_t cell = element / 6, row = cell / grid->grid->size[0];
    const num_x at[3] = {(num_x)(cell % grid->grid->size[0]), (num_x)(row % grid->grid->size[1]),
                         (num_x)(row / grid->grid->size[1])};
    struct num_point min = {grid->cell * at[0], grid->cell * at[1], grid->cell * at[2]};

    min = num_point_add(min, grid->corner);
    struct prepared_box box = {min, num_point_add(min, (struct num_point){grid->cell, grid->cell, grid->cell})};
    box_uv(&box, point, element % 6, uv);
}

const struct shape_kind shape_grid_kind = {intersect, shape_occludes, surface_at, uv_at};

void shape_grid(struct shape *shape, const struct tia_grid *grid)
{
    shape->kind = &shape_grid_kind;
    shape->grid = (struct prepared_grid){grid, num_point_of(grid->corner), num_x_of(grid->cell)};
}
