/* grid.h - grids, ray by ray and cell by cell, as geometry/grid.c.
 *
 * As there the t of a plane between cells comes from the plane's own coordinate; it is within (eo + what it rounds by +
 * |t| (ed + 4 u)) over |d| less ed. Where a ray passes so close to an edge that the order of two steps is open, all
 * cells that it may come through are looked at: when they have the content of the one it comes from, both steps are
 * taken; otherwise there may be a hit. */
#ifndef TIA_LEVELS_RAYS_GRID_H
#define TIA_LEVELS_RAYS_GRID_H

#include "report.h"

/* One ray in a grid. */
struct cell_walk {
    const struct sure_grid *grid;
    double o[3], d[3], eo, ed, limit;
    double inverse[3], over[3]; /* 1/d, and 1/(|d| - ed); an axis along which it hardly moves has over 0 */
    int at[3];
    /* what it finds */
    bool sure, may;
    double t, e, element;
};

LANE_OP int cells_along(const struct cell_walk *w, int axis)
{
    return w->grid->from->size[axis];
}

LANE_OP double plane_time(const struct cell_walk *w, int axis, int plane, double *e)
{
    double c = w->grid->corner[axis] + w->grid->edge * plane, t = (c - w->o[axis]) * w->inverse[axis];
    double round = (__builtin_fabs(c) + __builtin_fabs(w->o[axis])) * (4 * EPS) + 2 * UNIT;

    *e = (w->eo + round + __builtin_fabs(t) * (w->ed + 4 * EPS)) * w->over[axis] + UNIT;
    return t;
}

/* Outside it is empty. */
LANE_OP unsigned content_at(const struct cell_walk *w, const int at[3])
{
    const struct tia_grid *g = w->grid->from;
    size_t row = (size_t)at[2] * g->size[1] + (size_t)at[1];

    for (int i = 0; i < 3; i++)
        if (at[i] < 0 || at[i] >= g->size[i])
            return 0;
    return g->cells[row * g->size[0] + (size_t)at[0]];
}

LANE_OP double element_at(const struct cell_walk *w, const int at[3], int axis, int face)
{
    const struct tia_grid *g = w->grid->from;

    return 6.0 * (double)(((uint32_t)at[2] * g->size[1] + (uint32_t)at[1]) * g->size[0] + (uint32_t)at[0]) + 2 * axis +
           face;
}

static bool hit_cell(struct cell_walk *w, double t, double e, double element)
{
    w->sure = true;
    w->t = t;
    w->e = e;
    w->element = element;
    return false;
}

static bool may_hit(struct cell_walk *w, double low)
{
    w->may = true;
    w->t = low > 0 ? low : 0;
    return false;
}

/* The cell along one axis of a place within e; of two the one that the ray comes from. False: there are two. */
static bool find_cell(struct cell_walk *w, int axis, double place, double e)
{
    double x = (place - w->grid->corner[axis]) / w->grid->edge,
           more = e / w->grid->edge + __builtin_fabs(x) * SURE_2(50);
    double last = cells_along(w, axis) - 1, low = __builtin_floor(x - more), high = __builtin_floor(x + more);
    double cell = w->d[axis] < 0 ? high : low;

    w->at[axis] = (int)(cell < 0 ? 0 : cell > last ? last : cell);
    return low == high;
}

/* Where the ray enters and leaves the grid's box: the axis along which it does so last; -1: it starts inside. False: it
 * misses, or may miss. */
static bool enter_grid(struct cell_walk *w, int *axis, double *in, double *ein)
{
    double out = NEVER, eout = 0, reach = 0, least = NEVER;

    *in = -NEVER;
    *ein = 0;
    *axis = -1;
    for (int i = 0; i < 3; i++)
        reach += __builtin_fabs(w->grid->corner[i] - w->o[i]) + 2 * w->grid->edge * cells_along(w, i);
    for (int i = 0; i < 3; i++) {
        int n = cells_along(w, i);
        double e0, e1, size = __builtin_fabs(w->d[i]), t0, t1;
        if (!(size > 64 * w->ed + SURE_2(24))) {
            double off = w->eo + reach * (w->ed + size) + (__builtin_fabs(w->o[i]) + reach) * (8 * EPS) + 4 * UNIT;
            double a = w->o[i] - w->grid->corner[i], b = a - w->grid->edge * n;
            w->over[i] = 0;
            if (a < -off || b > off)
                return false;
            if (!find_cell(w, i, w->o[i], off) || a < off || b > -off)
                return may_hit(w, 0);
            continue;
        }
        w->inverse[i] = 1 / w->d[i];
        w->over[i] = 1 / (size - w->ed);
        t0 = plane_time(w, i, w->d[i] < 0 ? n : 0, &e0);
        t1 = plane_time(w, i, w->d[i] < 0 ? 0 : n, &e1);
        if (t0 > *in) {
            *in = t0;
            *axis = i;
        }
        *ein = e0 > *ein ? e0 : *ein;
        out = t1 < out ? t1 : out;
        eout = e1 > eout ? e1 : eout;
        least = t0 - e0 < least ? t0 - e0 : least;
    }
    if (*in - *ein > out + eout || out + eout < 0 || *in - *ein > w->limit)
        return false;
    if (*in + *ein >= out - eout || __builtin_fabs(*in) <= *ein)
        return may_hit(w, *in - *ein);
    if (*in < 0)
        *axis = -1;
    return true;
}

/* Finds the first cell; false: it is known already, or nobody can say. */
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
        double off = w->eo + at * w->ed + slack + (__builtin_fabs(w->o[i]) + at) * (8 * EPS) + 2 * UNIT;
        if (i == axis)
            w->at[i] = w->d[i] < 0 ? cells_along(w, i) - 1 : 0;
        else if (w->over[i] > 0)
            clear = find_cell(w, i, place, off) && clear;
    }
    if (!clear) {
        /* the cells around must all be empty: the first step is then taken from the one before */
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

/* Of the axes in `open`, all orders: whether each cell on the way has the content of this one. */
static bool all_alike(const struct cell_walk *w, unsigned open, unsigned here)
{
    for (unsigned set = open; set; set = (set - 1) & open) {
        int at[3];
        for (int i = 0; i < 3; i++)
            at[i] = w->at[i] + (set >> i & 1 ? (w->d[i] < 0 ? -1 : 1) : 0);
        if (content_at(w, at) != here)
            return false;
    }
    return true;
}

/* One step; false: the walk is over. */
static bool step_cell(struct cell_walk *w)
{
    double t[3] = {NEVER, NEVER, NEVER}, e[3] = {0, 0, 0};
    unsigned here = content_at(w, w->at), open = 0;
    int axis = 0;

    for (int i = 0; i < 3; i++) {
        if (w->over[i] > 0)
            t[i] = plane_time(w, i, w->at[i] + !(w->d[i] < 0), &e[i]);
        axis = t[i] < t[axis] ? i : axis;
    }
    if (t[axis] - e[axis] > w->limit)
        return false;
    for (int i = 0; i < 3; i++)
        open |= (unsigned)(t[i] - e[i] <= t[axis] + e[axis]) << i;
    if (open & (open - 1)) {
        if (!all_alike(w, open, here))
            return may_hit(w, t[axis] - e[axis]);
        for (int i = 0; i < 3; i++)
            w->at[i] += open >> i & 1 ? (w->d[i] < 0 ? -1 : 1) : 0;
    } else {
        int from[3] = {w->at[0], w->at[1], w->at[2]}, face = w->d[axis] > 0;
        w->at[axis] += w->d[axis] < 0 ? -1 : 1;
        unsigned there = content_at(w, w->at);
        if (there != here)
            return hit_cell(w, t[axis], e[axis],
                            there ? element_at(w, w->at, axis, !face) : element_at(w, from, axis, face));
    }
    for (int i = 0; i < 3; i++)
        if (w->at[i] < 0 || w->at[i] >= cells_along(w, i))
            return false;
    return true;
}

static __attribute__((noinline)) void meet_grid(struct query *q, const struct sure_grid *grid)
{
    const struct pack *p = q->p;
    const vd from[9] = {p->o.x, p->o.y, p->o.z, p->d.x, p->d.y, p->d.z, p->eo, p->ed, q->limit};
    double t[LANES], e[LANES], element[LANES], lanes[9][LANES];
    unsigned active = mbits(q->active), sure = 0, may = 0;

    for (int i = 0; i < 9; i++)
        vstore(lanes[i], from[i]);
    for (int k = 0; k < LANES; k++) {
        struct cell_walk w = {.grid = grid, .eo = lanes[6][k], .ed = lanes[7][k], .limit = lanes[8][k]};
        t[k] = e[k] = element[k] = 0;
        if (!(active >> k & 1))
            continue;
        for (int i = 0; i < 3; i++) {
            w.o[i] = lanes[i][k];
            w.d[i] = lanes[3 + i][k];
        }
        if (start_walk(&w))
            while (step_cell(&w)) {
            }
        sure |= (unsigned)w.sure << k;
        may |= (unsigned)w.may << k;
        t[k] = w.t;
        e[k] = w.e;
        element[k] = w.element;
    }
    vd at = vload(t), off = vload(e), bound = off + p->eo + at * p->ed + UNIT;
    report(
        q,
        (struct report){
            .sure = mof(sure), .may = mof(may), .t = at, .e = off, .ep = bound, .low = at, .element = vload(element)});
}

#endif
