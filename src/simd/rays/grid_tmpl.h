/* grid_tmpl.h - traversal of grids by all rays of a packet at once.
 *
 * Parameters: the doubles of isa/isa.h. Defines: meet_grid(), struct grid_walk.
 *
 * The time of plane number n is A + n B, with A = (corner - o)/d and B = edge/d. Its roundings are 3 u (|corner| +
 * |o|)/|d| for A, 3 u of the grid's size over |d| for n B, and u |t| for the sum. grid_ray_tmpl.h allows 4 u of each,
 * so that `base` and `slope` are the same as there. `off` is the largest such error while the ray is in the grid.
 *
 * A ray leaves the packet if it hardly moves along an axis, if it enters too close to an edge, or if the order of two
 * planes is undecided. grid_ray_tmpl.h continues its walk from there. */
#ifndef TIA_SIMD_RAYS_GRID_TMPL_H
#define TIA_SIMD_RAYS_GRID_TMPL_H

#include "grid_ray_tmpl.h"

struct grid_axis {
    vd a, b, base, slope;
    vd step, last, stride, end; /* step: 1 or -1; last: number of the last cell; stride: distance in memory to the next
                                   cell along the ray; end: number of the plane at which the ray leaves */
    vd cell, plane;             /* numbers of the first cell and of the next plane */
    vm back;
};

struct grid_walk {
    const struct sure_grid *grid;
    struct grid_axis axis[3];
    vd index;                   /* index of the cell in memory */
    vd off;                     /* largest error of a plane's time, along any axis */
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

/* Sets an axis, like set_axis() of grid_ray_tmpl.h. Returns the lanes whose rays move along it. */
LANE_OP vm set_grid_axis(struct grid_axis *x, const struct packet *p, const struct sure_grid *grid, int i,
                         double stride)
{
    const vd o = i == 0 ? p->o.x : i == 1 ? p->o.y : p->o.z, d = i == 0 ? p->d.x : i == 1 ? p->d.y : p->d.z;
    double far = grid->edge * grid->from->size[i];
    vd size = vabs(d),
       round = (vset(__builtin_fabs(grid->corner[i]) + far) + vabs(o)) * BOUND(GRID_PLANE) + BOUND(GRID_UNITS);
    vm moves = vlt(BOUND(GRID_TURN) * p->ed + BOUND(GRID_STEEP), size);
    vd over = 1 / vsel(moves, size - p->ed, vset(1)), inverse = 1 / vsel(moves, d, vset(1));

    x->back = vlt(d, vset(0));
    x->a = (vset(grid->corner[i]) - o) * inverse;
    x->b = vset(grid->edge) * inverse;
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
    return mand(lanes, clear);
}

/* Returns the contents of the lanes' cells, a byte for each lane. */
LANE_OP uint64_t grid_contents(const struct grid_walk *g, vd index)
{
    const uint8_t *cells = g->grid->from->cells;
    int64_t at[LANES];
    vi bits = as_integers(index + vset(4503599627370496.0)); /* adding 2^52 moves the integer to the low bits */
    uint64_t content = 0;

    __builtin_memcpy(at, &bits, sizeof at);
    for (int k = 0; k < LANES; k++)
        content |= (uint64_t)cells[(uint32_t)at[k]] << 8 * k;
    return content;
}

LANE_OP uint64_t bytes_of_lanes(unsigned lanes)
{
    uint64_t bytes = 0;

    for (int k = 0; k < LANES; k++)
        bytes |= (uint64_t)(lanes >> k & 1 ? 255 : 0) << 8 * k;
    return bytes;
}

/* Returns the lanes whose byte is not 0. */
LANE_OP unsigned lanes_of_bytes(uint64_t bytes)
{
    unsigned lanes = 0;

    for (int k = 0; k < LANES; k++)
        lanes |= (unsigned)((bytes >> 8 * k & 255) != 0) << k;
    return lanes;
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
    vd at = vsel(entry->inside, vset(0), entry->in), slack = vsel(entry->inside, vset(0), entry->ein);
    vm clear = lanes;

    g->index = vset(0);
    for (int i = 0; i < 3; i++) {
        struct grid_axis *x = &g->axis[i];
        vd off = BOUND_OF(GRID_PLACE, p->eo + at * p->ed + slack) + (vabs(o[i]) + at) * BOUND(GRID_PLACE_ROUNDING) +
                 BOUND(GRID_PLACE_UNITS);
        clear = mand(clear, mor(enters[i], grid_cell(x, g->grid, i, o[i] + at * d[i], off)));
        x->cell = vsel(enters[i], vsel(x->back, x->last, vset(0)), x->cell);
        x->plane = x->cell + vsel(x->back, vset(0), vset(1));
        x->end = vsel(x->back, vset(0), x->last + 1);
        g->index = g->index + x->cell * (x->stride * x->step);
    }
    g->alone = mor(g->alone, mand(lanes, mnot(clear)));
    g->index = vsel(clear, g->index, vset(0));
    g->here = grid_contents(g, g->index);
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
static __attribute__((noinline)) void end_grids(struct grid_walk *g, const struct grid_step *s)
{
    struct grid_axis *x = g->axis;
    unsigned here = lanes_of_bytes(g->here), went = mbits(g->walking) & ~mbits(mor(mor(s->open, s->over), s->out));
    unsigned other = lanes_of_bytes(s->differs) & went, into = other & lanes_of_bytes(g->here ^ s->differs);
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

/* Takes a step. m is the time of the next plane, and `after` that of the plane after it; if they are no more than 2
 * `off` apart, their order is undecided. A ray's way through the grid does not depend on the contents of cells: so all
 * rays step first, and end_grids() then ends the walks of those that have met different content. */
LANE_OP void step_grids(struct grid_walk *g, vd limit)
{
    struct grid_axis *x = g->axis;
    struct grid_step s;
    vd t[3];

    for (int i = 0; i < 3; i++)
        t[i] = x[i].a + x[i].plane * x[i].b;
    vd less = vmin(t[0], t[1]), more = vmax(t[0], t[1]), m = vmin(less, t[2]), after = vmax(less, vmin(more, t[2]));
    s.at = m;
    s.first = vle(t[0], m);
    s.second = mand(mnot(s.first), vle(t[1], m));
    vm third = mnot(mor(s.first, s.second));
    s.open = vle(after - m, BOUND_OF(GRID_ORDER, 2 * g->off));
    s.over = mand(mnot(s.open), vlt(limit, m - g->off));
    vd plane = of_axis(s.first, s.second, x[0].plane, x[1].plane, x[2].plane);
    vd end = of_axis(s.first, s.second, x[0].end, x[1].end, x[2].end);
    s.out = mand(vle(plane, end), vle(end, plane));
    vm go = mand(g->walking, mnot(mor(mor(s.open, s.over), s.out)));
    s.from = g->index;
    s.to = g->index + of_axis(s.first, s.second, x[0].stride, x[1].stride, x[2].stride);
    g->index = vsel(go, s.to, g->index);
    s.differs = (grid_contents(g, vsel(go, s.to, vset(0))) ^ g->here);
    x[0].plane = vsel(mand(s.first, go), x[0].plane + x[0].step, x[0].plane);
    x[1].plane = vsel(mand(s.second, go), x[1].plane + x[1].step, x[1].plane);
    x[2].plane = vsel(mand(third, go), x[2].plane + x[2].step, x[2].plane);
    if (mbits(go) != mbits(g->walking) || s.differs & g->live)
        end_grids(g, &s);
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
        w.at[i] = (int)lane_of(g->axis[i].plane, k) - (w.d[i] < 0 ? 0 : 1);
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
