/* tracer_tmpl.h - a block of pixels: camera rays, then their spawned rays, in packets.
 *
 * Parameters: the doubles of isa/isa.h, the hooks of sure_check.h. Defines: trace(), for lanes.h's table, shade(). */
#ifndef TIA_SIMD_RAYS_TRACER_TMPL_H
#define TIA_SIMD_RAYS_TRACER_TMPL_H

#include "bounce_tmpl.h"

LANE_OP void drop(unsigned *lanes, struct work *w, vm unsure, const struct rays *r)
{
    unsigned gone = *lanes & mbits(unsure);

    give_up(w, gone, r, vset(1));
    *lanes &= ~gone;
}

/* Adds the background or a light in the lanes that meet it, and clears these lanes. */
static void add_far(struct work *w, unsigned *lanes, const struct query *q, const struct rays *r)
{
    const struct sure_scene *s = w->block->scene;
    unsigned sky = *lanes & mbits(vle(vset(INFINITE), q->t)), shining = *lanes & ~mbits(vlt(q->id, vset(LIGHT_ID)));
    double id[LANES], rgb[3][LANES];

    *lanes &= ~(sky | shining);
    if (!(sky | shining))
        return;
    vstore(id, q->id);
    for (int k = 0; k < LANES; k++) {
        const double *from = shining >> k & 1 ? s->lights[(uint32_t)(id[k] - LIGHT_ID)].emission : s->background;
        for (int c = 0; c < 3; c++)
            rgb[c][k] = from[c];
    }
    vd flat[3] = {vload(rgb[0]), vload(rgb[1]), vload(rgb[2])}, top = most3(flat);
    for (int c = 0; c < 3; c++)
        flat[c] = flat[c] * r->weight[c];
    add_colour(w, sky | shining, r->slot, flat, BOUND_OF(COLOUR_FAR, top * r->ew) + BOUND(COLOUR_UNITS) * (1 + top));
}

/* Adds emission and direct light; clears the undecided lanes. */
static void add_own(struct work *w, unsigned *lanes, const struct shade *h, const struct rays *r)
{
    const struct sure_scene *s = w->block->scene;
    struct lit lit = {.cancel = &w->block->cancel,
                      .room = &w->lights,
                      .unsure = mnone(),
                      .eown = BOUND_OF(COLOUR_FACING, most3(h->flat) * h->efacing) + BOUND(COLOUR_UNITS)};
    uint8_t class[LANES];
    bool bounced = false;

    for (int k = 0; k < LANES; k++) {
        class[k] = w->class[r->slot[k]];
        bounced = bounced || (*lanes >> k & 1 && r->depth[k]);
    }
    bool apart = bounced && on_several(h, *lanes);
    for (int c = 0; c < 3; c++)
        lit.own[c] = h->emission[c] + h->flat[c] * vmax(h->facing, vset(0));
    for (uint32_t n = 0; n < s->light_count && !cancelled(lit.cancel, 1); n++)
        add_light(s, n, h, mof(*lanes), apart, class, &w->blocker[n % BLOCKERS], &lit);
    drop(lanes, w, lit.unsure, r);
    if (*lanes)
        check_own(&lit);
    vd top = most3(lit.own);
    for (int c = 0; c < 3; c++)
        lit.own[c] = lit.own[c] * r->weight[c];
    add_colour(w, *lanes, r->slot, lit.own,
               BOUND_OF(COLOUR_OWN, lit.eown * (most3(r->weight) + r->ew)) + BOUND_OF(COLOUR_WEIGHT, top * r->ew) +
                   BOUND(COLOUR_UNITS));
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
    add_own(w, &lanes, h, r);
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
    if (w->hit_count >= LANES)
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

/* Returns the place of a pixel in the order of packets: 8 lanes take 4 x 2 neighbouring pixels, 4 lanes 2 x 2. */
LANE_OP int place_in_packets(const struct sure_block *b, int x, int y)
{
    const int across = LANES < 4 ? 1 : LANES / 2;

    if (LANES < 4 || b->width % across || b->height % 2)
        return y * b->width + x;
    return (y / 2 * (b->width / across) + x / across) * LANES + y % 2 * across + x % across;
}

/* Sets the positions of a pixel's samples, see ray_camera_ray(). */
LANE_OP void place_samples(struct work *w, int slot, int x, int y)
{
    const int n = w->block->scene->camera.side;

    for (int j = 0; j < n; j++)
        for (int i = 0; i < n; i++, slot++) {
            w->place[0][slot] = 2 * n * n * x + 2 * n * i + 2 * j + 1;
            w->place[1][slot] = 2 * n * n * y + 2 * n * j + 2 * n - 2 * i - 1;
        }
}

/* Sets the positions of all samples, their order in packets and the classes of their pixels. */
static void place_pixels(struct work *w, const struct sure_block *b)
{
    for (int y = 0, i = 0; y < b->height; y++)
        for (int x = 0; x < b->width; x++) {
            int place = b->samples == 1 ? place_in_packets(b, x, y) : i;
            uint8_t class = (uint8_t)ray_pixel_class(b->x + x, b->y + y);
            place_samples(w, i, b->x + x, b->y + y);
            for (int end = i + b->samples; i < end; i++) {
                w->order[place++] = (uint16_t)i;
                w->class[i] = class;
            }
        }
}

/* Begins a block: sets the colours of all samples to 0. */
static void work_open(struct work *w, struct sure_block *b)
{
    w->block = b;
    w->count = w->hit_count = 0;
    for (int i = 0; i < BLOCKERS; i++)
        w->blocker[i] = TIA_NO_OBJECT;
    place_pixels(w, b);
    for (int i = 0; i < SURE_SLOTS; i++) {
        b->colour[0][i] = b->colour[1][i] = b->colour[2][i] = b->error[i] = w->rays[i] = 0;
        b->unsure[i] = false;
    }
}

static unsigned first_rays(const struct work *w, int from, int count, struct rays *r)
{
    const struct sure_camera *c = &w->block->scene->camera;
    const double parts = 2 * c->side * c->side;
    unsigned lanes = 0;

    for (int k = 0; k < LANES; k++) {
        r->slot[k] = w->order[from + k < count ? from + k : count - 1];
        r->depth[k] = r->layers[k] = r->media[k].count = 0;
        lanes |= (unsigned)(from + k < count) << k;
    }
    r->weight[0] = r->weight[1] = r->weight[2] = vset(1);
    r->ew = vset(0);
#define PLACE_X(k) w->place[0][r->slot[k]]
#define PLACE_Y(k) w->place[1][r->slot[k]]
    camera_rays(c, (vd){EACH_LANE(PLACE_X)} / vset(parts * c->width),
                (vd){EACH_LANE(PLACE_Y)} / vset(parts * c->height), &r->p);
#undef PLACE_X
#undef PLACE_Y
    check_camera(w->block, r);
    return lanes;
}

/* Shades a packet of hits or traces a packet of rays, whichever queue is longer. */
static void go_on_with(struct work *w, struct rays *r)
{
    unsigned lanes;

    if (w->hit_count > w->count) {
        shade_hits(w, r);
        return;
    }
    lanes = pop(w, r);
    if (lanes)
        follow(w, r, lanes);
}

static void trace(struct sure_block *b, void *memory)
{
    const struct cancel *cancel = &b->cancel;
    int count = b->width * b->height * b->samples;
    struct work *w = memory;
    struct rays *r = &w->packet;

    work_open(w, b);
    for (int from = 0; from < count && !cancel->stopped; from += LANES) {
        unsigned lanes = first_rays(w, from, count, r);
        follow(w, r, lanes);
        while (w->count > QUEUE_FULL && !cancel->stopped)
            go_on_with(w, r);
    }
    while ((w->count || w->hit_count) && !cancel->stopped)
        go_on_with(w, r);
}

#endif
