/* paths_tmpl.h - the rays of a block: queues of rays and hits, and sums of the light that they add.
 *
 * Parameters: the doubles of isa/isa.h, the hooks of sure_check.h. Defines: push(), pop(), push_hits(), pop_hits(),
 * add_colour(), give_up(), hand_over(), struct rays, struct work, QUEUE_FULL, BLOCKERS. */
#ifndef TIA_SIMD_RAYS_PATHS_TMPL_H
#define TIA_SIMD_RAYS_PATHS_TMPL_H

#include "light_tmpl.h"
#include "render/trace/media.h"
#include "sure_check.h"

#define COLUMNS 15
#define QUEUE_SIZE 256
#define QUEUE_FULL 24 /* above this number, queued rays are traced before further camera rays are started */
#define QUEUE_ENDS (QUEUE_SIZE + 8) /* elements of a queue's arrays: whole packets may extend beyond the last item */
#define BLOCKERS 16

/* Queued rays, see struct bounce of whitted.c, or queued hits. Each of their numbers is a column, in the order of
 * EACH_RAY_COLUMN() or EACH_HIT_COLUMN(). */
struct queue {
    int count;
    double number[COLUMNS][QUEUE_ENDS];
    uint32_t slot[QUEUE_ENDS], depth[QUEUE_ENDS], layers[QUEUE_ENDS];
    struct media media[QUEUE_ENDS];
    struct path_route route[QUEUE_ENDS];
};

/* Rays of a packet. `weight` is their throughput, within ew. `run`: lane k is of slot[0] + k. */
struct rays {
    struct packet p;
    vd weight[3], ew;
    bool run;
    uint32_t slot[LANES], depth[LANES], layers[LANES];
    struct media media[LANES];
    struct path_route route[LANES]; /* the hits before the ray, if there are no more than PATH_STEPS */
};

/* Rays and hits of a block. Hits are queued until they fill a packet: many rays of a packet hit nothing, and their
 * lanes would be idle while the hits of the other rays are shaded. */
struct work {
    struct sure_block *block;
    uint32_t blocker[BLOCKERS];
    uint8_t class[SURE_SLOTS];
    uint16_t order[SURE_SLOTS]; /* order of the slots in packets, unless this is their own, `in_order` */
    bool in_order;
    double place[2][SURE_ENDS]; /* positions of samples in the image, in units of 1/(2 side^2) pixel */
    double unit[2];             /* these units, as parts of the image */
    double across[SURE_ENDS];   /* columns of pixels in the image, 0..1; only where `place` is not set */
    double rays[SURE_SLOTS];    /* upper limit of the number of each sample's rays so far */
    struct queue queue, hits;   /* there are at most 2 LANES hits */
    struct rays packet;         /* this member and those after it are one packet's, too large for a stack */
    struct query query;
    struct shade shade;
    struct light_room lights;
};

/* Calls DO(i, column) for each number that a queued ray and a queued hit have. */
#define EACH_SHARED_COLUMN(DO, r)                                                                                      \
    DO(0, (r)->p.o.x);                                                                                                 \
    DO(1, (r)->p.o.y);                                                                                                 \
    DO(2, (r)->p.o.z);                                                                                                 \
    DO(3, (r)->p.d.x);                                                                                                 \
    DO(4, (r)->p.d.y);                                                                                                 \
    DO(5, (r)->p.d.z);                                                                                                 \
    DO(6, (r)->weight[0]);                                                                                             \
    DO(7, (r)->weight[1]);                                                                                             \
    DO(8, (r)->weight[2])

/* As EACH_SHARED_COLUMN(), for all numbers of a ray. */
#define EACH_RAY_COLUMN(DO, r)                                                                                         \
    EACH_SHARED_COLUMN(DO, r);                                                                                         \
    DO(9, (r)->p.eo);                                                                                                  \
    DO(10, (r)->p.ed);                                                                                                 \
    DO(11, (r)->ew);                                                                                                   \
    DO(12, (r)->p.from.object);                                                                                        \
    DO(13, (r)->p.from.element);                                                                                       \
    DO(14, (r)->p.from.side)

/* As EACH_SHARED_COLUMN(), for the numbers of a hit's ray and its query that shading needs. */
#define EACH_HIT_COLUMN(DO, r, q)                                                                                      \
    EACH_SHARED_COLUMN(DO, r);                                                                                         \
    DO(9, (r)->p.ed);                                                                                                  \
    DO(10, (r)->ew);                                                                                                   \
    DO(11, (q)->t);                                                                                                    \
    DO(12, (q)->ep);                                                                                                   \
    DO(13, (q)->id);                                                                                                   \
    DO(14, (q)->element)

LANE_OP void copy_media(struct media *to, const struct media *from)
{
    to->count = from->count;
    for (uint32_t i = 0; i < from->count; i++)
        to->entered[i] = from->entered[i];
}

LANE_OP void copy_route(struct path_route *to, const struct path_route *from)
{
    to->count = from->count;
    for (uint32_t i = 0; i < from->count && i < PATH_STEPS; i++)
        to->step[i] = from->step[i];
}

/* Adds lane k of a packet to the queue, without its numbers. */
LANE_OP void enqueue_path(struct queue *to, const struct rays *r, int k)
{
    to->slot[to->count] = r->slot[k];
    to->depth[to->count] = r->depth[k];
    to->layers[to->count] = r->layers[k];
    copy_media(&to->media[to->count], &r->media[k]);
    copy_route(&to->route[to->count++], &r->route[k]);
}

/* Takes up to LANES items off the end of the queue, one for each lane, without their numbers; lanes without an item
 * have zeros in all columns. Returns the number of items, which are those from q->count on. */
LANE_OP int dequeue_paths(struct queue *q, struct rays *r)
{
    int taken = q->count < LANES ? q->count : LANES, first = q->count -= taken;

    for (int k = taken; k < LANES; k++) {
        q->slot[first + k] = q->depth[first + k] = q->layers[first + k] = 0;
        q->media[first + k].count = q->route[first + k].count = 0;
        for (int i = 0; i < COLUMNS; i++)
            q->number[i][first + k] = 0;
    }
    for (int k = 0; k < LANES; k++) {
        r->slot[k] = q->slot[first + k];
        r->depth[k] = q->depth[first + k];
        r->layers[k] = q->layers[first + k];
        copy_media(&r->media[k], &q->media[first + k]);
        copy_route(&r->route[k], &q->route[first + k]);
    }
    r->run = false;
    return taken;
}

#define ENQUEUE(i, column) vstore(&to->number[i][to->count], vpacked(column, lanes))
#define DEQUEUE(i, column) column = vload(&from->number[i][from->count])

/* Adds to the colours of a packet's samples. */
LANE_OP void add_colour(struct work *w, unsigned lanes, const struct rays *r, const vd rgb[3], vd error)
{
    struct sure_block *b = w->block;
    double c[3][LANES], e[LANES];

    if (r->run) {
        double *sum[4] = {&b->colour[0][r->slot[0]], &b->colour[1][r->slot[0]], &b->colour[2][r->slot[0]],
                          &b->error[r->slot[0]]};
        for (int i = 0; i < 4; i++)
            vstore(sum[i], vload(sum[i]) + vsel(mof(lanes), i < 3 ? rgb[i] : error, vset(0)));
        return;
    }
    for (int i = 0; i < 3; i++)
        vstore(c[i], rgb[i]);
    vstore(e, error);
    for (; lanes; lanes &= lanes - 1) {
        int k = __builtin_ctz(lanes);
        for (int i = 0; i < 3; i++)
            b->colour[i][r->slot[k]] += c[i][k];
        b->error[r->slot[k]] += e[k];
    }
}

LANE_OP void mark(struct work *w, uint32_t slot)
{
    w->block->unsure[slot] = true;
}

/* Adds to the number of a sample's rays. The fixed-point path ends a sample after TIA_RAYS_MAX rays, so a sample with
 * more than half as many is undecided. Only paths with layers have so many rays. */
LANE_OP void count_rays(struct work *w, uint32_t slot, double rays)
{
    w->rays[slot] += rays;
    if (w->rays[slot] > TIA_RAYS_MAX / 2)
        mark(w, slot);
}

/* Drops undecided rays. A ray's colour is between 0 and `brightest`. Where the throughput times `brightest` is small,
 * half of this product is added to the sample's colour and to its bound; the pixel's levels mostly stay decided.
 * Otherwise the sample is undecided. The throughputs of a generation of rays add up to that of the first ray at most,
 * and each is 2^-16 or more, which limits the number of rays. */
static void give_up(struct work *w, unsigned lanes, const struct rays *r, vd factor)
{
    const struct sure_scene *s = w->block->scene;
    double weight[LANES], e[LANES];

    if (!lanes)
        return;
    vstore(weight, most3(r->weight) * factor);
    vstore(e, r->ew);
    for (int k = 0; lanes >> k; k++) {
        double most = (weight[k] + e[k]) * s->brightest[r->depth[k]], half = most / 2;
        uint32_t slot = r->slot[k];
        if (!(lanes >> k & 1))
            continue;
        if (!(most < BOUND(GIVEN_UP)) || s->generations == 0) {
            mark(w, slot);
            continue;
        }
        for (int c = 0; c < 3; c++)
            w->block->colour[c][slot] += half;
        w->block->error[slot] += BOUND_OF(COLOUR_GIVEN_UP, half) + BOUND(COLOUR_UNITS);
        count_rays(w, slot, 1 + (weight[k] + e[k]) * 65536 * s->generations);
    }
}

/* Makes samples undecided whose rays find no room in the queue. Returns the other lanes. */
static unsigned with_room(struct work *w, unsigned lanes, const struct rays *r)
{
    for (; w->queue.count + __builtin_popcount(lanes) > QUEUE_SIZE; lanes &= lanes - 1)
        mark(w, r->slot[__builtin_ctz(lanes)]);
    return lanes;
}

/* Leaves undecided rays to the fixed-point path, which adds their light later. Returns the lanes of these rays; it
 * lacks rays after too many hits, those too faint to matter, see give_up(), and all of blocks whose first hits are the
 * rasteriser's. */
static unsigned hand_over(struct work *w, unsigned lanes, const struct rays *r)
{
    const struct sure_scene *s = w->block->scene;
    struct sure_block *b = w->block;
    double weight[LANES];
    unsigned over = 0;

    if (!lanes || s->generations == 0 || b->seen)
        return 0;
    vstore(weight, most3(r->weight) + r->ew);
    for (int k = 0; lanes >> k; k++) {
        const struct path_route *route = &r->route[k];
        bool fits = route->count <= PATH_STEPS && b->rest_count < SURE_RESTS;
        if (!(lanes >> k & 1) || !fits || weight[k] * s->brightest[r->depth[k]] < BOUND(GIVEN_UP))
            continue;
        b->rest[b->rest_count++] = (struct sure_rest){r->slot[k], *route};
        over |= 1u << k;
    }
    return over;
}

/* Adds an object to the end of a route. */
LANE_OP void add_step(struct path_route *route, uint32_t object, bool refracted)
{
    if (route->count < PATH_STEPS)
        route->step[route->count] = object | (refracted ? PATH_REFRACTED : 0);
    route->count++;
}

/* Queues rays, except those too faint in all channels; rays that may be too faint are undecided. */
static void push(struct work *w, unsigned lanes, struct rays *next, bool refracted, bool straight)
{
    struct queue *to = &w->queue;
    vd top = most3(next->weight), least = vset(BOUND(FAINT)),
       margin = BOUND_OF(FAINT_MARGIN, next->ew + BOUND(FAINT_UNITS));
    unsigned yes = lanes & mbits(vlt(least + margin, top)), no = mbits(vlt(top, least - margin));

    give_up(w, lanes & ~(yes | no), next, vset(1));
    lanes = with_room(w, yes, next);
    EACH_RAY_COLUMN(ENQUEUE, next);
    for (; lanes; lanes &= lanes - 1) {
        int k = __builtin_ctz(lanes);
        check_push(to->count, refracted);
        enqueue_path(to, next, k);
        add_step(&to->route[to->count - 1], w->shade.index[k], refracted);
        to->depth[to->count - 1] += !straight;
        to->layers[to->count - 1] += straight;
    }
}

/* Takes up to LANES queued rays; returns their lanes, without those whose samples have become undecided. */
static unsigned pop(struct work *w, struct rays *r)
{
    struct queue *from = &w->queue;
    int taken = dequeue_paths(from, r);
    unsigned lanes = 0;

    EACH_RAY_COLUMN(DEQUEUE, r);
    for (int k = 0; k < taken; k++) {
        bool open = !w->block->unsure[r->slot[k]];
        check_pop(from->count + k);
        lanes |= (unsigned)open << k;
        if (open)
            count_rays(w, r->slot[k], 1);
    }
    return lanes;
}

/* Queues hits, to be shaded later. */
static void push_hits(struct work *w, unsigned lanes, struct rays *r, struct query *q)
{
    struct queue *to = &w->hits;

    if (!lanes)
        return;
    EACH_HIT_COLUMN(ENQUEUE, r, q);
    for (; lanes; lanes &= lanes - 1)
        enqueue_path(to, r, __builtin_ctz(lanes));
}

static unsigned pop_hits(struct work *w, struct rays *r, struct query *q)
{
    struct queue *from = &w->hits;
    int taken = dequeue_paths(from, r);
    unsigned lanes = 0;

    EACH_HIT_COLUMN(DEQUEUE, r, q);
    for (int k = 0; k < taken; k++)
        lanes |= (unsigned)!w->block->unsure[r->slot[k]] << k;
    return lanes;
}

#undef ENQUEUE
#undef DEQUEUE

#endif
