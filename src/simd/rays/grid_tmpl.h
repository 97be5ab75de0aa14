/* grid_tmpl.h - traversal of grids by all rays of a packet at once.
 *
 * Parameters: the doubles of isa/isa.h. Defines: meet_grid(), struct grid_walk.
 *
 * The time of plane number n is A + n B, with A = (corner - o)/d and B = edge/d. Its roundings are 3 u (|corner| +
 * |o|)/|d| for A, 3 u of the grid's size over |d| for n B, and u |t| for the sum. grid_ray_tmpl.h allows 4 u of each,
 * so that `base` and `slope` are the same as there. `off` is the largest such error while the ray is in the grid.
 *
 * In a corner of an empty cube, a ray leaps to the first plane at which it leaves the cube, and so past as many planes
 * or more at once. Along the other axes it is then between the planes floor(u) and floor(u) + 1, u = (t - A)/B, if u is
 * certainly no integer; else it steps once. A plane's time depends on the plane alone, so that the cell does not depend
 * on the way to it.
 *
 * A ray leaves the packet if it hardly moves along an axis, if it enters too close to an edge, or if the order of two
 * planes is undecided. grid_ray_tmpl.h continues its walk from there. */
#ifndef TIA_SIMD_RAYS_GRID_TMPL_H
#define TIA_SIMD_RAYS_GRID_TMPL_H

#include "bytes_tmpl.h"
#include "grid_ray_tmpl.h"

struct grid_axis {
    vd a, b, base, slope;
    vd ahead, inverse;          /* |B|, 1/|B| */
    vd doubt;                   /* largest error of a number by plane_after() while the ray is in the grid */
    vd step, last, stride, end; /* step: 1 or -1; last: number of the last cell; stride: distance in memory to the next
                                   cell along the ray; end: the plane at which the ray leaves */
    vd cell, plane;             /* number of the first cell; the next plane. Planes' numbers are times `step` here. */
    vm back;
};

struct grid_walk {
    const struct sure_grid *grid;
    struct grid_axis axis[3];
    vd index;                   /* index of the cell in memory */
    vd off;                     /* largest error of a plane's time, along any axis */
    vd octant;                  /* where the cubes of the ray's octant are */
    vd beyond;                  /* number of cells behind this one that are in an empty cube; 0: take a step */
    uint64_t here;              /* content of the cell, a byte for each lane */
    uint64_t live;              /* 255 in the bytes of walking lanes */
    vm walking, alone, started; /* alone: continued by grid_ray_tmpl.h, from the current cell if they are `started` */
    /* result: certain hits, possible hits */
    vm sure, may;
    vd t, e, element;
};

LANE_OP vd of_axis(vm first, vm second, vd a, vd b, vd c)
{
    return vsel(first, a, vsel(second, b, c));
}

LANE_OP vd component(const struct v3 *v, int i)
{
    return i == 0 ? v->x : i == 1 ? v->y : v->z;
}

/* Sets an axis, like set_axis() of grid_ray_tmpl.h. Returns the lanes whose rays move along it. */
LANE_OP vm set_grid_axis(struct grid_axis *x, const struct packet *p, const struct sure_grid *grid, int i,
                         double stride)
{
    const vd o = component(&p->o, i), d = component(&p->d, i), inverse = component(&p->inv, i);
    double far = grid->edge * grid->from->size[i];
    vd size = vabs(d),
       round = (vset(__builtin_fabs(grid->corner[i]) + far) + vabs(o)) * BOUND(GRID_PLANE) + BOUND(GRID_UNITS);
    vm moves = vlt(BOUND(GRID_TURN) * p->ed + BOUND(GRID_STEEP), size);
    vd over = vabs(inverse) * BOUND(GRID_OVER);

    x->back = vlt(d, vset(0));
    x->a = (vset(grid->corner[i]) - o) * inverse;
    x->b = vset(grid->edge) * inverse;
    x->ahead = vabs(x->b);
    x->inverse = size * vset(1 / grid->edge);
    x->base = BOUND_OF(GRID_BASE, (p->eo + round) * over) + BOUND(QUOTIENT_UNIT);
    x->slope = BOUND_OF(GRID_SLOPE, (p->ed + BOUND(GRID_TIME)) * over);
    x->step = vsel(x->back, vset(-1), vset(1));
    x->last = vset((double)grid->from->size[i] - 1);
    x->stride = x->step * stride;
    return moves;
}

/* Finds the cell of a point along an axis; `place` is the coordinate, with the error e. Returns the lanes in which the
 * cell is certain. */
LANE_OP vm grid_cell(struct grid_axis *x, const struct sure_grid *grid, int i, vd place, vd e)
{
    vd at = (place - vset(grid->corner[i])) * (1 / grid->edge),
       more = e * (1 / grid->edge) + vabs(at) * BOUND(GRID_CELL);
    vd low = vfloor(at - more), high = vfloor(at + more);

    x->cell = low;
    return mand(mand(vle(low, high), vle(high, low)), mand(vle(vset(0), low), vle(high, x->last)));
}

/* The entry of rays into the grid's box, see enter_grid(). */
struct grid_entry {
    vd in, ein;
    vm inside, first, second; /* first, second: a ray from outside enters along axis 0, or along axis 1 */
};

/* Returns the lanes whose rays certainly enter the box, or certainly start in it. Lanes that may enter it become
 * `alone`. */
LANE_OP vm enter_grids(struct grid_walk *g, vm lanes, vd limit, struct grid_entry *to)
{
    vd out = vset(INFINITE), eout = vset(0), in[3];
    vm passed = mnone();

    to->ein = vset(0);
    for (int i = 0; i < 3; i++) {
        struct grid_axis *x = &g->axis[i];
        vd most = x->last + 1, t1 = x->a + vsel(x->back, vset(0), most) * x->b, e1 = x->base + vabs(t1) * x->slope;
        in[i] = x->a + vsel(x->back, most, vset(0)) * x->b;
        to->ein = vmax(to->ein, x->base + vabs(in[i]) * x->slope);
        out = vmin(out, t1);
        eout = vmax(eout, e1);
        passed = mor(passed, vlt(t1 + e1, vset(0)));
    }
    to->in = vmax(vmax(in[0], in[1]), in[2]);
    to->first = vle(to->in, in[0]);
    to->second = mand(mnot(to->first), vle(to->in, in[1]));
    to->inside = vlt(to->in, vset(0));
    vd early = to->in - to->ein;
    lanes = mand(lanes, mnot(mor(passed, mor(vlt(out + eout, early), vlt(limit, early)))));
    vm clear = mand(vlt(to->in + to->ein, out - eout), vlt(to->ein, vabs(to->in)));
    g->alone = mor(g->alone, mand(lanes, mnot(clear)));
    g->off = vset(0);
    for (int i = 0; i < 3; i++)
        g->off = vmax(g->off, g->axis[i].base + g->axis[i].slope * (out + eout));
    for (int i = 0; i < 3; i++) {
        struct grid_axis *x = &g->axis[i];
        x->doubt = BOUND_OF(GRID_LEAP, 2 * g->off * x->inverse) +
                   (out + eout + vabs(x->a)) * x->inverse * BOUND(GRID_LEAP_ROUNDING);
    }
    return mand(lanes, clear);
}

/* Returns the contents of cells. */
LANE_OP uint64_t grid_contents(const struct grid_walk *g, vd index)
{
    return grid_bytes(g->grid->from->cells, index);
}

/* Returns the cubes of cells, a byte for each lane. */
LANE_OP uint64_t grid_cubes(const struct grid_walk *g, vd index)
{
    return grid_bytes(g->grid->empty, index + g->octant);
}

/* Returns the numbers of cells behind the corners of cubes. */
LANE_OP vd behind_corners(uint64_t cubes)
{
    return vmax(numbers_of_bytes(cubes) - 1, vset(0));
}

/* Records the hits of rays that pass a plane at t into different content. A hit at t <= e may be behind the origin, so
 * it is only a possible one. */
LANE_OP void grid_hit(struct grid_walk *g, vm lanes, vd t, vd e, vd element)
{
    vm ahead = mand(lanes, vlt(e, t)), near = mand(lanes, mnot(vlt(e, t)));

    g->sure = mor(g->sure, ahead);
    g->may = mor(g->may, near);
    g->t = vsel(ahead, t, vsel(near, vset(0), g->t));
    g->e = vsel(lanes, e, g->e);
    g->element = vsel(lanes, element, g->element);
}

/* Finds the first cells, and the hits of rays that enter the grid in a filled one. */
LANE_OP void start_grids(struct grid_walk *g, const struct packet *p, vm lanes, const struct grid_entry *entry)
{
    const vd o[3] = {p->o.x, p->o.y, p->o.z}, d[3] = {p->d.x, p->d.y, p->d.z};
    const vm enters[3] = {mand(entry->first, mnot(entry->inside)), mand(entry->second, mnot(entry->inside)),
                          mnot(mor(entry->inside, mor(entry->first, entry->second)))};
    const double cells = (double)g->grid->from->size[0] * g->grid->from->size[1] * g->grid->from->size[2];
    vd at = vsel(entry->inside, vset(0), entry->in), slack = vsel(entry->inside, vset(0), entry->ein);
    vm clear = lanes;

    g->index = g->octant = vset(0);
    for (int i = 0; i < 3; i++) {
        struct grid_axis *x = &g->axis[i];
        vd off = BOUND_OF(GRID_PLACE, p->eo + at * p->ed + slack) + (vabs(o[i]) + at) * BOUND(GRID_PLACE_ROUNDING) +
                 BOUND(GRID_PLACE_UNITS);
        clear = mand(clear, mor(enters[i], grid_cell(x, g->grid, i, o[i] + at * d[i], off)));
        x->cell = vsel(enters[i], vsel(x->back, x->last, vset(0)), x->cell);
        x->plane = vsel(x->back, -x->cell, x->cell + 1);
        x->end = vsel(x->back, vset(0), x->last + 1);
        g->index = g->index + x->cell * (x->stride * x->step);
        g->octant = g->octant + vsel(x->back, vset((double)(1 << i) * cells), vset(0));
    }
    g->alone = mor(g->alone, mand(lanes, mnot(clear)));
    g->index = vsel(clear, g->index, vset(0));
    g->here = grid_contents(g, g->index);
    g->beyond = g->grid->empty ? behind_corners(grid_cubes(g, g->index)) : vset(0);
    vm hit = mand(mof(lanes_of_bytes(g->here)), mand(clear, mnot(entry->inside)));
    vm back =
        mor(mor(mand(enters[0], g->axis[0].back), mand(enters[1], g->axis[1].back)), mand(enters[2], g->axis[2].back));
    vd side = of_axis(entry->first, entry->second, vset(0), vset(2), vset(4)) + vsel(back, vset(1), vset(0));
    grid_hit(g, hit, entry->in, entry->ein, 6 * g->index + side);
    g->walking = mand(clear, mnot(hit));
    g->started = g->walking;
    g->live = bytes_of_lanes(mbits(g->walking));
}

/* A step of each ray: to the next plane, and to the cell behind it. */
struct grid_step {
    vm first, second; /* the step is along axis 0, or along axis 1 */
    vd at, from, to;  /* time of the step; indices in memory of the cells before and behind the plane */
    vm open, over, out;
    uint64_t differs; /* a byte for each lane: the bits in which the contents of the two cells differ */
};

/* Ends the walks that meet different content, leave the grid, pass the limit, or continue in grid_ray_tmpl.h. */
static __attribute__((noinline)) void end_grids(struct grid_walk *g, const struct grid_step *s, vm stays)
{
    struct grid_axis *x = g->axis;
    unsigned here = lanes_of_bytes(g->here), went = mbits(g->walking) & ~mbits(mor(mor(s->open, s->over), s->out));
    unsigned other = lanes_of_bytes(s->differs) & went & ~mbits(stays),
             into = other & lanes_of_bytes(g->here ^ s->differs);
    unsigned outside = mbits(s->out) & mbits(g->walking) & ~mbits(mor(s->open, s->over)),
             hit = other | (outside & here);

    g->alone = mor(g->alone, mand(s->open, g->walking));
    g->walking = mof(went & ~other);
    g->live = bytes_of_lanes(went & ~other);
    if (!hit)
        return;
    vd e = of_axis(s->first, s->second, x[0].base, x[1].base, x[2].base) +
           vabs(s->at) * of_axis(s->first, s->second, x[0].slope, x[1].slope, x[2].slope);
    vm back = mor(mor(mand(s->first, x[0].back), mand(s->second, x[1].back)),
                  mand(mnot(mor(s->first, s->second)), x[2].back));
    unsigned far = (into & mbits(back)) | (~into & ~mbits(back)); /* hits on a cell's face at the axis's maximum */
    vd side = of_axis(s->first, s->second, vset(0), vset(2), vset(4)) +
              vsel(mof(far & ((1u << LANES) - 1)), vset(1), vset(0));
    grid_hit(g, mof(hit), s->at, e, 6 * vsel(mof(into), s->to, s->from) + side);
}

/* Returns the plane that follows the time m along an axis that a ray does not leave the cube along. Clears *certain
 * in the lanes where another plane may. */
LANE_OP vd plane_after(const struct grid_axis *x, vd m, vm *certain)
{
    vd u = (m - x->a) * x->inverse, low = vfloor(u), in = u - low;

    *certain = mand(*certain, mand(vlt(x->doubt, in), vlt(in + x->doubt, vset(1))));
    return low + 1;
}

/* Sets what is beyond the cells that the lanes `go` have reached; lanes that neither step nor leap step next.
 * Returns the bits in which the content of these cells differs. */
LANE_OP uint64_t arrive(struct grid_walk *g, vm go, vd to)
{
    vd index = vsel(go, to, vset(0));
    uint64_t empty;

    if (!g->grid->empty)
        return grid_contents(g, index) ^ g->here;
    empty = grid_cubes(g, index);
    g->beyond = vsel(go, behind_corners(empty), vset(0));
    if ((g->here & g->live) == 0 && !any_empty_byte(empty, g->live))
        return 0;
    return grid_contents(g, index) ^ g->here;
}

/* Takes a step, or `leaps`. m is the time of the next plane, and `after` that of the plane after it; if they are no
 * more than 2 `off` apart, their order is undecided. A ray's way through the grid does not depend on the contents of
 * cells: so all rays step first, and end_grids() then ends the walks of those that have met different content. */
LANE_OP void step_or_leap(struct grid_walk *g, vd limit, bool leaps)
{
    struct grid_axis *x = g->axis;
    struct grid_step s;
    vd t[3], plane[3];

    for (int i = 0; i < 3; i++) {
        plane[i] = leaps ? vmin(x[i].plane + g->beyond, x[i].end) : x[i].plane;
        t[i] = x[i].a + plane[i] * x[i].ahead;
    }
    vd less = vmin(t[0], t[1]), more = vmax(t[0], t[1]), m = vmin(less, t[2]), after = vmax(less, vmin(more, t[2]));
    s.at = m;
    s.first = vle(t[0], m);
    s.second = mand(mnot(s.first), vle(t[1], m));
    vm third = mnot(mor(s.first, s.second)), far = leaps ? vlt(vset(0), g->beyond) : mnone(), stays = mnone();
    const vm along[3] = {s.first, s.second, third};
    s.open = mand(vle(after - m, BOUND_OF(GRID_ORDER, 2 * g->off)), mnot(far));
    s.over = mand(mnot(s.open), vlt(limit, m - g->off));
    for (int i = 0; i < 3; i++) {
        vm certain = mnot(mnone());
        vd next = leaps ? vsel(far, plane_after(&x[i], m, &certain), x[i].plane) : x[i].plane;
        stays = mor(stays, mand(mand(far, mnot(along[i])), mnot(certain)));
        plane[i] = vsel(along[i], plane[i], next);
    }
    vd last = of_axis(s.first, s.second, plane[0], plane[1], plane[2]);
    s.out = mand(mnot(stays), vle(of_axis(s.first, s.second, x[0].end, x[1].end, x[2].end), last));
    vm go = mand(g->walking, mnot(mor(mor(s.open, s.over), mor(s.out, stays))));
    s.from = s.to = g->index;
    for (int i = 0; i < 3; i++) {
        plane[i] = plane[i] + vsel(along[i], vset(1), vset(0));
        s.to = s.to + (plane[i] - x[i].plane) * x[i].stride;
        x[i].plane = vsel(go, plane[i], x[i].plane);
    }
    g->index = vsel(go, s.to, g->index);
    s.differs = arrive(g, go, s.to);
    unsigned ended = mbits(g->walking) & ~(mbits(go) | (mbits(stays) & ~mbits(s.over)));
    if (ended || s.differs & g->live)
        end_grids(g, &s, stays);
}

static void step_grids(struct grid_walk *g, vd limit)
{
    step_or_leap(g, limit, false);
}

static void leap_grids(struct grid_walk *g, vd limit)
{
    step_or_leap(g, limit, true);
}

/* Continues the walk of a single lane to its end. */
static void walk_alone(struct grid_walk *g, const struct query *q, int k)
{
    const struct packet *p = q->p;
    const vd o[3] = {p->o.x, p->o.y, p->o.z}, d[3] = {p->d.x, p->d.y, p->d.z};
    struct cell_walk w = {
        .grid = g->grid, .eo = lane_of(p->eo, k), .ed = lane_of(p->ed, k), .limit = lane_of(q->limit, k)};
    bool started = mbits(g->started) >> k & 1;
    double found[3][LANES];

    for (int i = 0; i < 3; i++) {
        w.o[i] = lane_of(o[i], k);
        w.d[i] = lane_of(d[i], k);
    }
    for (int i = 0; i < 3 && started; i++) {
        (void)set_axis(&w, i);
        w.at[i] = (int)lane_of(g->axis[i].plane * g->axis[i].step, k) - (w.d[i] < 0 ? 0 : 1);
    }
    if (started || start_walk(&w)) {
        w.here = cell_at(&w, w.at);
        finish_walk(&w);
    }
    g->sure = mor(g->sure, mof((unsigned)w.sure << k));
    g->may = mor(g->may, mof((unsigned)w.may << k));
    vstore(found[0], g->t);
    vstore(found[1], g->e);
    vstore(found[2], g->element);
    found[0][k] = w.t;
    found[1][k] = w.e;
    found[2][k] = w.element;
    g->t = vload(found[0]);
    g->e = vload(found[1]);
    g->element = vload(found[2]);
}

static __attribute__((noinline)) void meet_grid(struct query *q, const struct sure_grid *grid, struct grid_walk *g)
{
    const struct packet *p = q->p;
    const struct tia_grid *from = grid->from;
    const double stride[3] = {1, from->size[0], (double)from->size[0] * from->size[1]};
    struct grid_entry entry;
    vm moves = q->active;

    g->grid = grid;
    g->sure = g->may = g->started = mnone();
    g->t = g->e = g->element = vset(0);
    for (int i = 0; i < 3; i++)
        moves = mand(moves, set_grid_axis(&g->axis[i], p, grid, i, stride[i]));
    g->alone = mand(q->active, mnot(moves));
    vm enter = enter_grids(g, moves, q->limit, &entry);
    if (any(enter)) {
        start_grids(g, p, enter, &entry);
        while (any(g->walking))
            if (any(vlt(vset(0), g->beyond)))
                leap_grids(g, q->limit);
            else
                step_grids(g, q->limit);
    }
    for (int k = 0; mbits(g->alone) >> k; k++)
        if (mbits(g->alone) >> k & 1)
            walk_alone(g, q, k);
    vd bound = BOUND_OF(POINT, g->e + p->eo + g->t * p->ed + BOUND(POINT_UNIT));
    report_hit(
        q, (struct hit_report){
               .sure = g->sure, .may = g->may, .t = g->t, .e = g->e, .ep = bound, .low = g->t, .element = g->element});
}

#endif
