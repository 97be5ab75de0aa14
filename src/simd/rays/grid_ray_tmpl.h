/* grid_ray_tmpl.h - traversal of a grid by a single ray, cell by cell, as in geometry/grid.c.
 *
 * Parameters: the doubles of isa/isa.h. Defines: start_walk(), finish_walk(), set_axis(), cell_at(), struct cell_walk.
 *
 * As in geometry/grid.c, the t of a plane between cells is computed from the plane's own coordinate. Its error is (eo +
 * the plane's roundings + |t| (ed + 4 u))/(|d| - ed), and the quotient's unit. Where a ray passes an edge so closely
 * that the order of two steps is undecided, all cells that it may pass through are examined. If they all have the
 * content of the current cell, both steps are taken; otherwise there may be a hit. */
#ifndef TIA_SIMD_RAYS_GRID_RAY_TMPL_H
#define TIA_SIMD_RAYS_GRID_RAY_TMPL_H

#include "hit_report_tmpl.h"

/* The walk of a ray through a grid. */
struct cell_walk {
    const struct sure_grid *grid;
    double o[3], d[3], eo, ed, limit;
    double inverse[3], base[3], slope[3]; /* constants of the planes' times, see plane_time() */
    bool moves[3];
    int at[3], step[3];
    double next[3], enext[3]; /* times at which the ray leaves the cell along each axis, and their errors */
    unsigned here;            /* content of the cell */
    /* result: a certain hit, a possible hit */
    bool sure, may;
    double t, e, element;
};

LANE_OP int cells_along(const struct cell_walk *w, int axis)
{
    return w->grid->from->size[axis];
}

/* Sets the constants of plane_time() for an axis; false if the ray hardly moves along it. */
LANE_OP bool set_axis(struct cell_walk *w, int axis)
{
    double size = __builtin_fabs(w->d[axis]), far = w->grid->edge * cells_along(w, axis);
    double round = (__builtin_fabs(w->grid->corner[axis]) + far + __builtin_fabs(w->o[axis])) * BOUND(GRID_PLANE) +
                   BOUND(GRID_UNITS);

    w->step[axis] = w->d[axis] < 0 ? -1 : 1;
    w->moves[axis] = size > BOUND(GRID_TURN) * w->ed + BOUND(GRID_STEEP);
    if (!w->moves[axis])
        return false;
    w->inverse[axis] = 1 / w->d[axis];
    double over = __builtin_fabs(w->inverse[axis]) * BOUND(GRID_OVER);
    w->base[axis] = BOUND_OF(GRID_BASE, (w->eo + round) * over) + BOUND(QUOTIENT_UNIT);
    w->slope[axis] = BOUND_OF(GRID_SLOPE, (w->ed + BOUND(GRID_TIME)) * over);
    return true;
}

LANE_OP double plane_time(const struct cell_walk *w, int axis, int plane, double *e)
{
    double t = (w->grid->corner[axis] + w->grid->edge * plane - w->o[axis]) * w->inverse[axis];

    *e = w->base[axis] + __builtin_fabs(t) * w->slope[axis];
    return t;
}

LANE_OP unsigned cell_at(const struct cell_walk *w, const int at[3])
{
    const struct tia_grid *g = w->grid->from;

    return g->cells[((size_t)at[2] * g->size[1] + (size_t)at[1]) * g->size[0] + (size_t)at[0]];
}

/* Returns the content of a cell; outside the grid it is 0, empty. */
LANE_OP unsigned content_at(const struct cell_walk *w, const int at[3])
{
    for (int i = 0; i < 3; i++)
        if (at[i] < 0 || at[i] >= cells_along(w, i))
            return 0;
    return cell_at(w, at);
}

LANE_OP double element_at(const struct cell_walk *w, const int at[3], int axis, int face)
{
    const struct tia_grid *g = w->grid->from;

    return 6.0 * (double)(((uint32_t)at[2] * g->size[1] + (uint32_t)at[1]) * g->size[0] + (uint32_t)at[0]) + 2 * axis +
           face;
}

static bool may_hit(struct cell_walk *w, double low)
{
    w->may = true;
    w->t = low > 0 ? low : 0;
    return false;
}

static bool hit_cell(struct cell_walk *w, double t, double e, double element)
{
    if (t <= e)
        return may_hit(w, 0);
    w->sure = true;
    w->t = t;
    w->e = e;
    w->element = element;
    return false;
}

/* Sets the cell of a point along one axis, where `place` is the point's coordinate and e its error. If the point may be
 * in either of two cells, sets the one that the ray comes from. Returns false in that case, and if the point may be
 * outside the grid. */
static bool find_cell(struct cell_walk *w, int axis, double place, double e)
{
    double x = (place - w->grid->corner[axis]) / w->grid->edge,
           more = e / w->grid->edge + __builtin_fabs(x) * BOUND(GRID_RAY_CELL);
    double last = cells_along(w, axis) - 1, low = __builtin_floor(x - more), high = __builtin_floor(x + more);
    double cell = w->d[axis] < 0 ? high : low;

    w->at[axis] = (int)(cell < 0 ? 0 : cell > last ? last : cell);
    return low == high && low >= 0 && high <= last;
}

/* Finds the time *in, with the error *ein, at which the ray enters the grid's box. *axis receives the axis of the slab
 * that it enters last; -1 if it starts inside. Returns false if the ray certainly misses, and also, with w->may set, if
 * it may miss. */
static bool enter_grid(struct cell_walk *w, int *axis, double *in, double *ein)
{
    double out = INFINITE, eout = 0, reach = 0;
    bool passed = false;

    *in = -INFINITE;
    *ein = 0;
    *axis = -1;
    for (int i = 0; i < 3; i++)
        reach += __builtin_fabs(w->grid->corner[i] - w->o[i]) + 2 * w->grid->edge * cells_along(w, i);
    for (int i = 0; i < 3; i++) {
        int n = cells_along(w, i);
        double e0, e1, t0, t1;
        if (!set_axis(w, i)) {
            double off = BOUND_OF(GRID_LEVEL, w->eo + reach * (w->ed + __builtin_fabs(w->d[i]))) +
                         (__builtin_fabs(w->o[i]) + reach) * BOUND(GRID_PLACE_ROUNDING) + BOUND(GRID_LEVEL_UNITS);
            double a = w->o[i] - w->grid->corner[i], b = a - w->grid->edge * n;
            if (a < -off || b > off)
                return false;
            if (!find_cell(w, i, w->o[i], off) || a < off || b > -off)
                return may_hit(w, 0);
            continue;
        }
        t0 = plane_time(w, i, w->d[i] < 0 ? n : 0, &e0);
        t1 = plane_time(w, i, w->d[i] < 0 ? 0 : n, &e1);
        if (t0 > *in) {
            *in = t0;
            *axis = i;
        }
        *ein = e0 > *ein ? e0 : *ein;
        out = t1 < out ? t1 : out;
        eout = e1 > eout ? e1 : eout;
        passed = passed || t1 + e1 < 0;
    }
    if (passed || *in - *ein > out + eout || *in - *ein > w->limit)
        return false;
    if (*in + *ein >= out - eout || __builtin_fabs(*in) <= *ein)
        return may_hit(w, *in - *ein);
    if (*in < 0)
        *axis = -1;
    return true;
}

/* Finds the first cell. Returns false if the walk ends before it starts, with the result in *w. */
static bool start_walk(struct cell_walk *w)
{
    double t, e;
    bool clear = true;
    int axis;

    if (!enter_grid(w, &axis, &t, &e))
        return false;
    double at = axis < 0 ? 0 : t, slack = axis < 0 ? 0 : e;
    for (int i = 0; i < 3; i++) {
        double place = w->o[i] + at * w->d[i];
        double off = BOUND_OF(GRID_PLACE, w->eo + at * w->ed + slack) +
                     (__builtin_fabs(w->o[i]) + at) * BOUND(GRID_PLACE_ROUNDING) + BOUND(GRID_PLACE_UNITS);
        if (i == axis)
            w->at[i] = w->d[i] < 0 ? cells_along(w, i) - 1 : 0;
        else if (w->moves[i])
            clear = find_cell(w, i, place, off) && clear;
    }
    if (!clear) {
        /* the first cell is undecided: unless all 27 cells around are empty, there may be a hit; the walk starts in the
         * cell that the ray comes from */
        for (int k = 0; k < 27; k++) {
            const int near[3] = {w->at[0] + k % 3 - 1, w->at[1] + k / 3 % 3 - 1, w->at[2] + k / 9 - 1};
            if (content_at(w, near))
                return may_hit(w, at - slack);
        }
        return true;
    }
    if (axis >= 0 && content_at(w, w->at))
        return hit_cell(w, t, e, element_at(w, w->at, axis, w->d[axis] < 0));
    return true;
}

/* True if all cells that the ray may pass through by steps along the axes in `open`, in any order, have the content
 * `here`. */
static bool all_alike(const struct cell_walk *w, unsigned open, unsigned here)
{
    for (unsigned set = open; set; set = (set - 1) & open) {
        int at[3];
        for (int i = 0; i < 3; i++)
            at[i] = w->at[i] + (set >> i & 1 ? w->step[i] : 0);
        if (content_at(w, at) != here)
            return false;
    }
    return true;
}

LANE_OP void find_next(struct cell_walk *w, int axis)
{
    w->next[axis] = INFINITE;
    w->enext[axis] = 0;
    if (w->moves[axis])
        w->next[axis] = plane_time(w, axis, w->at[axis] + (w->step[axis] > 0), &w->enext[axis]);
}

/* Takes the steps along all axes in `open` if the cells that they may pass through are alike; otherwise there may be a
 * hit. Returns false if the walk is over. */
static bool step_through(struct cell_walk *w, unsigned open, double low)
{
    bool inside = true;

    if (!all_alike(w, open, w->here))
        return may_hit(w, low);
    for (int i = 0; i < 3; i++) {
        w->at[i] += open >> i & 1 ? w->step[i] : 0;
        inside = inside && w->at[i] >= 0 && w->at[i] < cells_along(w, i);
        find_next(w, i);
    }
    return inside;
}

/* Takes one step. Returns false if the walk is over. */
LANE_OP bool step_cell(struct cell_walk *w)
{
    const double *t = w->next, *e = w->enext;
    int axis = t[1] < t[0] ? 1 : 0;
    unsigned open = 0;

    axis = t[2] < t[axis] ? 2 : axis;
    double late = t[axis] + e[axis], early = late;
    for (int i = 0; i < 3; i++) {
        open |= (unsigned)(t[i] - e[i] <= late) << i;
        early = t[i] - e[i] < early ? t[i] - e[i] : early;
    }
    if (early > w->limit)
        return false;
    if (open & (open - 1))
        return step_through(w, open, early);
    int from[3] = {w->at[0], w->at[1], w->at[2]}, face = w->step[axis] > 0;
    w->at[axis] += w->step[axis];
    bool inside = w->at[axis] >= 0 && w->at[axis] < cells_along(w, axis);
    unsigned there = inside ? cell_at(w, w->at) : 0;
    if (there != w->here)
        return hit_cell(w, t[axis], e[axis],
                        there ? element_at(w, w->at, axis, !face) : element_at(w, from, axis, face));
    if (inside)
        find_next(w, axis);
    return inside;
}

/* Walks from the current cell to the end. */
static void finish_walk(struct cell_walk *w)
{
    for (int i = 0; i < 3; i++)
        find_next(w, i);
    while (step_cell(w)) {
    }
}

#endif
