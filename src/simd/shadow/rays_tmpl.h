/* rays_tmpl.h - exact shadow rays by blocks of pixels: the faces near the shaft between a block's visible points and
 * the light are found at once, and each is tested against LANES points together. A sign that doubles leave undecided is
 * that of the integers.
 *
 * Parameters: the doubles of isa/isa.h. Defines: trace_tile(). */
#ifndef TIA_SIMD_SHADOW_RAYS_TMPL_H
#define TIA_SIMD_SHADOW_RAYS_TMPL_H

#include "block_tmpl.h"

#define MANY_RUNS 56 /* in a block, of faces so small that each point is traced by itself more quickly */

/* ---- casters ---- */

static void set_planes(struct shaft_caster *own, const struct tia_occluder *o)
{
    for (unsigned k = own->ready; k < o->ready; k++) {
        const struct tia_occluder_plane *p = &o->plane[k];
        double unit = 1, power = 1;
        (void)two_to(p->unit, &unit);
        (void)two_to(p->m_unit, &power);
        unit *= o->side;
        own->x[k] = (double)p->x * unit;
        own->y[k] = (double)p->y * unit;
        own->c[k] = (double)p->c * unit;
        own->m[k] = (double)p->m * power * o->side;
        own->unit[k] = p->unit ? magnitude(unit) : 0;
    }
    own->ready = o->ready;
}

/* Prepares the planes below `count` of a caster. */
static void make_ready(struct shaft_block *b, struct shaft_caster *own, unsigned count)
{
    struct tia_occluder *o = &b->rays->occluder[own->face % TIA_OCCLUDERS];

    if (own->ready >= count)
        return;
    if (o->face != own->face)
        (void)tia_occluder_init(o, b->rays->flat, b->rays->light, own->face);
    for (unsigned k = 1; k < count; k++)
        tia_occluder_ready(o, k);
    set_planes(own, o);
}

static struct shaft_caster *caster_of(struct shaft_block *b, uint32_t face)
{
    struct shaft_caster *own = &b->caster[face % SHAFT_FACES];
    struct tia_occluder *o = &b->rays->occluder[face % TIA_OCCLUDERS];

    if (own->face == face)
        return own;
    if (o->face != face)
        (void)tia_occluder_init(o, b->rays->flat, b->rays->light, face);
    own->face = face;
    own->planes = o->side ? o->sides + 1 : 0;
    own->ready = 0;
    if (own->planes)
        make_ready(b, own, 1);
    return own;
}

/* Returns the error of a plane's sign anywhere in the block. */
static double error_of(const struct shaft_block *b, const struct shaft_caster *c, unsigned k)
{
    double size = magnitude(c->x[k]) * b->x1 + magnitude(c->y[k]) * b->y1 + magnitude(c->c[k]);

    return BOUND(RAY_SIDE) * (size + magnitude(c->m[k]) * b->sum) + BOUND_OF(RAY_CUT, c->unit[k] * (b->x1 + b->y1));
}

/* Returns the error of a plane, which is prepared; `error` has those that are known, and -1 for others. */
LANE_OP double plane_error(struct shaft_block *b, struct shaft_caster *c, double error[PLANES], unsigned k)
{
    if (k >= c->ready)
        make_ready(b, c, c->planes);
    if (error[k] < 0)
        error[k] = error_of(b, c, k);
    return error[k];
}

/* Returns the lanes of `open` from whose points a caster hides the light; *unsure receives those for which the integers
 * must decide. */
LANE_OP unsigned hidden_lanes(struct shaft_block *b, struct shaft_caster *c, double error[PLANES], int x, int y,
                              unsigned open, unsigned *unsure)
{
    vd s = vload(&b->s[y - b->y0][x - b->x0]), column = lane_numbers() + (double)x;
    unsigned maybe = open, sure = open;

    for (unsigned k = 0; k < c->planes && maybe; k++) {
        double e = plane_error(b, c, error, k);
        vd side = (c->x[k] * column + (c->y[k] * y + c->c[k])) - c->m[k] * s;
        maybe &= mbits(vlt(vset(-e), side));
        sure &= mbits(vlt(vset(e), side));
    }
    *unsure = maybe & ~sure;
    return maybe & sure;
}

/* True if all pixels of the block are certainly on the negative side of a plane. Where they show one face, s is linear,
 * and so is the side. RAY_SIDE covers the roundings of this form, 16 u, too. */
static bool is_beyond(const struct shaft_block *b, const struct shaft_caster *c, unsigned k, double error)
{
    const struct shaft_face *f = &b->seen;
    double x = (c->x[k] - c->m[k] * f->x) / 2, y = (c->y[k] - c->m[k] * f->y) / 2;
    double middle = x * (b->x0 + b->x1 - 1) + y * (b->y0 + b->y1 - 1) + (c->c[k] - c->m[k] * f->c);

    return middle + magnitude(x) * (b->x1 - 1 - b->x0) + magnitude(y) * (b->y1 - 1 - b->y0) < -error;
}

/* True if a face certainly hides the light from no pixel of the block. */
static bool hides_nothing(struct shaft_block *b, struct shaft_caster *c, double error[PLANES])
{
    bool beyond = false;

    for (unsigned k = 0; k < c->planes && !beyond && b->only; k++)
        beyond = is_beyond(b, c, k, plane_error(b, c, error, k));
    return beyond || !c->planes;
}

/* Tests a face against all open pixels. */
static void test_face(struct shaft_block *b, uint32_t face)
{
    const struct tia_raster_target *t = &b->rays->tile->target;
    struct shaft_caster *c = caster_of(b, face);
    double error[PLANES] = {-1, -1, -1, -1, -1};

    if (hides_nothing(b, c, error))
        return;
    for (int y = b->y0; y < b->y1; y++)
        for (int column = 0; column < SHAFT_COLUMNS && b->open[y - b->y0] >> column; column += LANES) {
            unsigned open = b->open[y - b->y0] >> column & ((1u << LANES) - 1), unsure;
            unsigned hidden = open ? hidden_lanes(b, c, error, b->x0 + column, y, open, &unsure) : (unsure = 0);
            const uint32_t *own = &t->face[target_index(t, b->x0 + column, y)];
            for (; unsure; unsure &= unsure - 1) {
                int k = __builtin_ctz(unsure);
                if (own[k] != face && tia_shadow_rays_hides(b->rays, face, b->x0 + column + k, y))
                    hidden |= 1u << k;
            }
            b->open[y - b->y0] &= ~(hidden << column);
            b->last = hidden ? face : b->last;
        }
}

static bool is_done(const struct shaft_block *b)
{
    uint32_t any = 0;

    for (int y = 0; y < b->y1 - b->y0; y++)
        any |= b->open[y];
    return !any || cancelled(b->rays->cancel, 1);
}

/* Tests the faces near the shaft, until no pixel is open. */
static void test_faces(struct shaft_block *b)
{
    const struct tia_casters *casters = b->rays->casters;
    uint32_t stack[TIA_BVH_DEPTH_MAX + 2], depth = 0;

    if (b->last != TIA_NO_FACE)
        test_face(b, b->last);
    for (uint32_t i = 0; i < casters->unbounded_count; i++)
        test_face(b, casters->unbounded[i]);
    if (casters->tree.node_count)
        stack[depth++] = 0;
    while (depth && !is_done(b)) {
        const uint32_t at = stack[--depth];
        const struct tia_bvh_node *node = &casters->tree.nodes[at];
        if (!meets(&b->shaft, &node->bounds))
            continue;
        for (uint32_t i = 0; i < node->count; i++)
            test_face(b, casters->tree.items[node->index + i]);
        if (!node->count) {
            stack[depth++] = at + 1;
            stack[depth++] = node->index;
        }
    }
}

static void trace_block(struct shaft_block *b)
{
    const struct tia_raster_target *t = &b->rays->tile->target;

    if (set_points(b) > MANY_RUNS) {
        for (int y = b->y0; y < b->y1; y++)
            for (uint32_t open = b->open[y - b->y0]; open; open &= open - 1)
                tia_shadow_rays_pixel(b->rays, b->x0 + __builtin_ctz(open), y);
        return;
    }
    set_box(b);
    if (is_done(b))
        return;
    set_shaft(b);
    test_faces(b);
    for (int y = b->y0; y < b->y1; y++)
        for (uint32_t open = b->open[y - b->y0]; open; open &= open - 1)
            b->rays->tile->lit[target_index(t, b->x0 + __builtin_ctz(open), y)] |= UINT64_C(1) << b->rays->sample;
}

static void trace_tile(struct tia_shadow_rays *rays)
{
    const struct tia_raster_target *t = &rays->tile->target;
    struct shaft_block b = {.rays = rays, .last = TIA_NO_FACE};

    for (int i = 0; i < SHAFT_FACES; i++)
        b.caster[i].face = b.face[i].face = TIA_NO_FACE;
    for (int y = t->area.y; y < target_bottom(t); y += SHAFT_ROWS)
        for (int x = t->area.x; x < target_right(t) && !cancelled(rays->cancel, SHAFT_COLUMNS * SHAFT_ROWS);
             x += SHAFT_COLUMNS) {
            b.x0 = x;
            b.y0 = y;
            b.x1 = least_int(x + SHAFT_COLUMNS, target_right(t));
            b.y1 = least_int(y + SHAFT_ROWS, target_bottom(t));
            trace_block(&b);
        }
}

#endif
