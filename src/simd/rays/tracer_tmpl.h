/* tracer_tmpl.h - a block of pixels: camera rays, then their spawned rays, in packets.
 *
 * Parameters: the doubles of isa/isa.h, the hooks of sure_check.h. Defines: trace(), for lanes.h's table, shade(). */
#ifndef TIA_SIMD_RAYS_TRACER_TMPL_H
#define TIA_SIMD_RAYS_TRACER_TMPL_H

#include "beam_tmpl.h"
#include "bounce_tmpl.h"

LANE_OP void drop(unsigned *lanes, struct work *w, vm unsure, const struct rays *r)
{
    unsigned gone = *lanes & mbits(unsure);

    if (!gone)
        return;
    give_up(w, gone & ~hand_over(w, gone, r), r, vset(1));
    *lanes &= ~gone;
}

/* Sets the emission of the lights that these lanes meet. */
static void set_lights_colour(const struct sure_scene *s, unsigned lanes, const struct query *q, vd rgb[3])
{
    double id[LANES], of[3][LANES];

    vstore(id, q->id);
    for (int c = 0; c < 3; c++)
        vstore(of[c], rgb[c]);
    for (; lanes; lanes &= lanes - 1) {
        int k = __builtin_ctz(lanes);
        for (int c = 0; c < 3; c++)
            of[c][k] = s->lights[(uint32_t)(id[k] - LIGHT_ID)].emission[c];
    }
    for (int c = 0; c < 3; c++)
        rgb[c] = vload(of[c]);
}

/* Adds the background or a light in the lanes that meet it, and clears these lanes. */
static void add_far(struct work *w, unsigned *lanes, const struct query *q, const struct rays *r)
{
    const struct sure_scene *s = w->block->scene;
    unsigned sky = *lanes & mbits(vle(vset(INFINITE), q->t)), shining = *lanes & ~mbits(vlt(q->id, vset(LIGHT_ID)));

    *lanes &= ~(sky | shining);
    if (!(sky | shining))
        return;
    vd flat[3] = {vset(s->background[0]), vset(s->background[1]), vset(s->background[2])};
    if (shining)
        set_lights_colour(s, shining, q, flat);
    vd top = most3(flat);
    for (int c = 0; c < 3; c++)
        flat[c] = flat[c] * r->weight[c];
    add_colour(w, sky | shining, r, flat, BOUND_OF(COLOUR_FAR, top * r->ew) + BOUND(COLOUR_UNITS) * (1 + top));
}

/* Adds emission and direct light; clears the undecided lanes. `known` is NULL, or has the lights that arrive. */
static void add_own(struct work *w, unsigned *lanes, const struct shade *h, const struct rays *r,
                    const struct known_lights *known)
{
    const struct sure_scene *s = w->block->scene;
    struct lit lit;
    uint8_t class[LANES];
    bool bounced = false;

    lit_begin(&lit, &w->block->cancel, &w->lights, known);
    lit.eown = BOUND_OF(COLOUR_FACING, most3(h->flat) * h->efacing) + BOUND(COLOUR_UNITS);
    for (int k = 0; k < LANES; k++) {
        class[k] = w->class[r->slot[k]];
        bounced = bounced || (*lanes >> k & 1 && r->depth[k]);
    }
    lit.room->room.scattered = bounced;
    bool apart = bounced && on_several(h, *lanes);
    for (int c = 0; c < 3; c++)
        lit.own[c] = h->emission[c] + h->flat[c] * vmax(h->facing, vset(0));
    for (uint32_t n = 0; n < s->light_count && !cancelled(lit.cancel, 1); n++)
        add_light(s, n, h, mof(*lanes), apart, class, &w->blocker[n % BLOCKERS], &lit);
    vd top = most3(lit.own);
    vd error = BOUND_OF(COLOUR_OWN, lit.eown * (most3(r->weight) + r->ew)) + BOUND_OF(COLOUR_WEIGHT, top * r->ew) +
               BOUND(COLOUR_UNITS);
    drop(lanes, w, mor(lit.unsure, vlt(vset(BOUND(OWN_UNSURE)), error)), r);
    if (*lanes)
        check_own(&lit);
    for (int c = 0; c < 3; c++)
        lit.own[c] = lit.own[c] * r->weight[c];
    add_colour(w, *lanes, r, lit.own, error);
}

/* Adds the light of the surfaces that rays hit, and spawns the rays that continue from there. */
static void shade(struct work *w, struct rays *r, const struct query *q, unsigned lanes)
{
    struct shade *h = &w->shade;

    find_surfaces(w->block->scene, &r->p, q, lanes, h);
    drop(&lanes, w, h->unsure, r);
    if (!lanes)
        return;
    check_surface(h);
    add_own(w, &lanes, h, r, NULL);
    if (lanes)
        bounce(w, h, lanes, r);
}

static void shade_hits(struct work *w, struct rays *r)
{
    unsigned lanes = pop_hits(w, r, &w->query); /* sets only the columns of hit_column() */

    if (lanes)
        shade(w, r, &w->query, lanes);
}

static void follow(struct work *w, struct rays *r, unsigned lanes)
{
    struct query *q = &w->query;

    w->lights.room.scattered = false;
    for (int k = 0; k < LANES; k++)
        w->lights.room.scattered = w->lights.room.scattered || (lanes >> k & 1 && r->depth[k]);
    find_nearest(w->block->scene, &w->lights.room, q, &r->p, mof(lanes));
    (void)cancelled(&w->block->cancel, q->work);
    vm sky = mand(vle(vset(INFINITE), q->t), vle(vset(INFINITE), q->low));
    drop(&lanes, w, mnot(mor(sky, vlt(q->t + q->e, q->low))), r);
    if (lanes)
        check_met(r, q);
    add_far(w, &lanes, q, r);
    if (lanes == (1u << LANES) - 1) {
        shade(w, r, q, lanes);
        return;
    }
    push_hits(w, lanes, r, q);
    if (w->hits.count >= LANES)
        shade_hits(w, r);
}

/* Sets rays through the points (x, y) of the image, both coordinates in 0..1. */
static void camera_rays(const struct sure_camera *c, vd x, vd y, struct packet *p)
{
    vd h = vset(c->left) + vset(c->across) * x, v = vset(c->top) - vset(c->upward) * y;
    struct v3 aside = v3_add(v3_scale(v3_set(c->u), h), v3_scale(v3_set(c->v), v));
    double window = __builtin_fabs(c->left) + c->across + __builtin_fabs(c->top) + c->upward;
    vd size = vabs(h) + vabs(v) + vset(window);
    p->from = (struct origin){vset(-1), vset(0), vset(0)};

    if (c->orthographic) {
        p->o = v3_add(v3_set(c->eye), aside);
        p->eo = BOUND_OF(CAMERA_PARALLEL_ORIGIN, size * BOUND(CAMERA_PARALLEL) + BOUND(CAMERA_PARALLEL_UNITS) +
                                                     v3_sum(p->o) * BOUND(POINT_ROUNDING));
        p->d = v3_neg(v3_set(c->n));
        p->ed = vset(BOUND(CONVERTED));
        return;
    }
    p->o = v3_set(c->eye);
    p->eo = vset(BOUND(CAMERA_EYE));
    p->d = v3_unit(
        v3_sub(aside, v3_scale(v3_set(c->n), vset(c->away))),
        BOUND_OF(CAMERA_DIRECTION, (size + __builtin_fabs(c->away)) * BOUND(CAMERA_WAY) + BOUND(CAMERA_WAY_UNITS)),
        &p->ed);
}

/* Sets the cells of pixels that packets take: 4 x 2 neighbours for 8 lanes, 2 x 2 for 4 lanes, or else a row. */
LANE_OP void set_cells(struct sure_block *b)
{
    const int across = LANES < 4 ? 1 : LANES / 2;
    bool fit = LANES >= 4 && b->samples == 1 && b->width % across == 0 && b->height % 2 == 0;

    b->across = fit ? across : b->width;
    b->rows = fit ? 2 : 1;
}

/* Sets the positions of all samples, see ray_camera_ray(). */
static void place_samples(struct work *w, const struct sure_block *b)
{
    const int n = w->block->scene->camera.side;

    for (int slot = 0, pixel = 0; pixel < b->width * b->height; pixel++) {
        int x = b->x + pixel % b->width, y = b->y + pixel / b->width;
        for (int j = 0; j < n; j++)
            for (int i = 0; i < n; i++, slot++) {
                w->place[0][slot] = 2 * n * n * x + 2 * n * i + 2 * j + 1;
                w->place[1][slot] = 2 * n * n * y + 2 * n * j + 2 * n - 2 * i - 1;
            }
    }
}

/* Sets the positions of pixels with one sample each: their centres. Packets that extend beyond a row's end spoil slots
 * of the next row, before these are set. */
static void place_centres(struct work *w, const struct sure_block *b)
{
    const int across = LANES / b->rows;
#define RIGHT(k) 2 * ((k) % across) + 1
#define DOWN(k) 2 * ((k) / across) + 1
    const vd right = {EACH_LANE(RIGHT)}, down = {EACH_LANE(DOWN)};
#undef RIGHT
#undef DOWN

    for (int y = 0; y < b->height; y += b->rows)
        for (int x = 0; x < b->width; x += across) {
            int slot = y * b->width + x * b->rows;
            vstore(&w->place[0][slot], vset(2 * (b->x + x)) + right);
            vstore(&w->place[1][slot], vset(2 * (b->y + y)) + down);
        }
}

/* Sets the classes of the samples' pixels, if any light has a pattern for each class. */
static void set_classes(struct work *w, const struct sure_block *b)
{
    for (int slot = 0; slot < SURE_SLOTS; slot++)
        w->class[slot] = 0;
    for (int slot = 0; b->scene->areas && slot < b->width * b->height * b->samples; slot++) {
        struct sure_place p = sure_place_of(b, slot / b->samples);
        w->class[slot] = (uint8_t)ray_pixel_class(b->x + p.x, b->y + p.y);
    }
}

/* Begins a block, without its samples. */
LANE_OP void work_begin(struct work *w, struct sure_block *b)
{
    const struct sure_camera *c = &b->scene->camera;

    w->block = b;
    w->unit[0] = 1.0 / (2 * c->side * c->side * c->width);
    w->unit[1] = 1.0 / (2 * c->side * c->side * c->height);
    w->in_order = true;
    w->queue.count = w->hits.count = b->rest_count = 0;
    for (int i = 0; i < BLOCKERS; i++)
        w->blocker[i] = TIA_NO_OBJECT;
}

/* Begins a block: sets the colours of all samples to 0. */
static void work_open(struct work *w, struct sure_block *b)
{
    work_begin(w, b);
    if (b->samples == 1)
        place_centres(w, b);
    else
        place_samples(w, b);
    set_classes(w, b);
    for (int i = 0; i < SURE_SLOTS; i++) {
        b->colour[0][i] = b->colour[1][i] = b->colour[2][i] = b->error[i] = w->rays[i] = 0;
        b->unsure[i] = false;
    }
}

/* Sets the slots of a packet of camera rays, of which `count` are wanted; returns its lanes. */
LANE_OP unsigned first_slots(const struct work *w, int from, int count, struct rays *r)
{
    const unsigned all = (1u << LANES) - 1;

    r->run = w->in_order;
    for (int k = 0; k < LANES; k++) {
        r->slot[k] = w->in_order ? (uint32_t)(from + k) : w->order[k < count ? from + k : from + count - 1];
        r->depth[k] = r->layers[k] = r->media[k].count = r->route[k].count = 0;
    }
    return count < LANES ? all >> (LANES - count) : all;
}

static unsigned first_rays(const struct work *w, int from, int count, struct rays *r)
{
    unsigned lanes = first_slots(w, from, count - from, r);

    r->weight[0] = r->weight[1] = r->weight[2] = vset(1);
    r->ew = vset(0);
#define PLACE_X(k) w->place[0][r->slot[k]]
#define PLACE_Y(k) w->place[1][r->slot[k]]
    vd x = r->run ? vload(&w->place[0][from]) : (vd){EACH_LANE(PLACE_X)};
    vd y = r->run ? vload(&w->place[1][from]) : (vd){EACH_LANE(PLACE_Y)};
#undef PLACE_X
#undef PLACE_Y
    camera_rays(&w->block->scene->camera, x * vset(w->unit[0]), y * vset(w->unit[1]), &r->p);
    check_camera(w->block, r);
    return lanes;
}

/* Shades a packet of hits or traces a packet of rays, whichever queue is longer. */
static void go_on_with(struct work *w, struct rays *r)
{
    unsigned lanes;

    if (w->hits.count > w->queue.count) {
        shade_hits(w, r);
        return;
    }
    lanes = pop(w, r);
    if (lanes)
        follow(w, r, lanes);
}

/* Draws the first `count` samples, in w->order or that of their slots. `begin` shades the hits of a packet of camera
 * rays, or queues them. */
LANE_OP void draw(struct work *w, const struct sure_block *b, int count,
                  void (*begin)(struct work *w, struct rays *r, unsigned lanes))
{
    const struct cancel *cancel = &b->cancel;
    struct rays *r = &w->packet;

    for (int from = 0; from < count && !cancel->stopped; from += LANES) {
        unsigned lanes = first_rays(w, from, count, r);
        begin(w, r, lanes);
        while (w->queue.count > QUEUE_FULL && !cancel->stopped)
            go_on_with(w, r);
    }
    while ((w->queue.count || w->hits.count) && !cancel->stopped)
        go_on_with(w, r);
}

static void trace(struct sure_block *b, void *memory)
{
    struct work *w = memory;

    set_cells(b);
    if (sees_background(b)) {
        store_background(b);
        return;
    }
    work_open(w, b);
    draw(w, b, b->width * b->height * b->samples, follow);
}

#endif
