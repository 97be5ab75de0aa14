/* paths_tmpl.h - the rays of a block: queues of rays and hits, and sums of the light that they add.
 *
 * Parameters: the doubles of isa/isa.h, the hooks of sure_check.h. Defines: push(), pop(), push_hits(), pop_hits(),
 * add_colour(), give_up(), struct rays, struct work, QUEUE_FULL, BLOCKERS. */
#ifndef TIA_SIMD_RAYS_PATHS_TMPL_H
#define TIA_SIMD_RAYS_PATHS_TMPL_H

#include "light_tmpl.h"
#include "render/trace/media.h"
#include "sure_check.h"

#define COLUMNS 15

/* A queued ray, see struct bounce of whitted.c, or a queued hit, stored as scalars in the order of ray_column() or
 * hit_column(). */
struct queued {
    double number[COLUMNS];
    uint32_t slot, depth, layers;
    struct media media;
};

#define QUEUE_SIZE 256
#define QUEUE_FULL 24 /* above this number, queued rays are traced before further camera rays are started */
#define BLOCKERS 16

/* Rays of a packet. `weight` is their throughput, within ew. */
struct rays {
    struct packet p;
    vd weight[3], ew;
    uint32_t slot[LANES], depth[LANES], layers[LANES];
    struct media media[LANES];
};

/* Rays and hits of a block. Hits are queued until they fill a packet: many rays of a packet hit nothing, and their
 * lanes would be idle while the hits of the other rays are shaded. */
struct work {
    struct sure_block *block;
    uint32_t blocker[BLOCKERS];
    uint8_t class[SURE_SLOTS];
    uint16_t order[SURE_SLOTS];  /* order of the slots in packets */
    double place[2][SURE_SLOTS]; /* positions of samples in the image, in units of 1/(2 side^2) pixel */
    double rays[SURE_SLOTS];     /* upper limit of the number of each sample's rays so far */
    struct queued queue[QUEUE_SIZE], hits[2 * LANES];
    int count, hit_count;
    struct rays packet; /* this member and those after it are one packet's, too large for a stack */
    struct query query;
    struct shade shade;
    struct light_room lights;
};

LANE_OP vd *ray_column(struct rays *r, int i)
{
    vd *const column[COLUMNS] = {&r->p.o.x, &r->p.o.y,     &r->p.o.z,         &r->p.d.x,          &r->p.d.y,
                                 &r->p.d.z, &r->weight[0], &r->weight[1],     &r->weight[2],      &r->p.eo,
                                 &r->p.ed,  &r->ew,        &r->p.from.object, &r->p.from.element, &r->p.from.side};

    return column[i];
}

/* Returns column i of a queued hit. The columns are the numbers of a ray and its query that shading needs. */
LANE_OP vd *hit_column(struct rays *r, struct query *q, int i)
{
    vd *const column[COLUMNS] = {&r->p.o.x, &r->p.o.y,     &r->p.o.z,     &r->p.d.x,     &r->p.d.y,
                                 &r->p.d.z, &r->weight[0], &r->weight[1], &r->weight[2], &r->p.ed,
                                 &r->ew,    &q->t,         &q->ep,        &q->id,        &q->element};

    return column[i];
}

LANE_OP void enqueue(struct queued *to, double number[COLUMNS][LANES], const struct rays *r, int k)
{
    for (int i = 0; i < COLUMNS; i++)
        to->number[i] = number[i][k];
    to->slot = r->slot[k];
    to->depth = r->depth[k];
    to->layers = r->layers[k];
    to->media = r->media[k];
}

/* Takes up to LANES items off the end of a queue, one for each lane; returns their number. row[k] receives the address
 * of the numbers of lane k; r receives all other data. */
LANE_OP int dequeue(const struct queued *queue, int *count, struct rays *r, const double *row[LANES])
{
    static const struct queued none;
    int taken = *count < LANES ? *count : LANES;

    for (int k = 0; k < LANES; k++) {
        const struct queued *from = k < taken ? &queue[--*count] : &none;
        row[k] = from->number;
        r->slot[k] = from->slot;
        r->depth[k] = from->depth;
        r->layers[k] = from->layers;
        r->media[k] = from->media;
    }
    return taken;
}

LANE_OP void add_colour(struct work *w, unsigned lanes, const uint32_t slot[LANES], const vd rgb[3], vd error)
{
    double c[3][LANES], e[LANES];

    for (int i = 0; i < 3; i++)
        vstore(c[i], rgb[i]);
    vstore(e, error);
    for (int k = 0; k < LANES; k++) {
        if (!(lanes >> k & 1))
            continue;
        for (int i = 0; i < 3; i++)
            w->block->colour[i][slot[k]] += c[i][k];
        w->block->error[slot[k]] += e[k];
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

/* Queues rays, except those too faint in all channels; rays that may be too faint are undecided. */
static void push(struct work *w, unsigned lanes, struct rays *next, bool refracted, bool straight)
{
    vd top = most3(next->weight), least = vset(BOUND(FAINT)),
       margin = BOUND_OF(FAINT_MARGIN, next->ew + BOUND(FAINT_UNITS));
    unsigned yes = lanes & mbits(vlt(least + margin, top)), no = mbits(vlt(top, least - margin));
    double number[COLUMNS][LANES];

    (void)refracted; /* used by check_push() only */
    give_up(w, lanes & ~(yes | no), next, vset(1));
    for (int i = 0; i < COLUMNS; i++)
        vstore(number[i], *ray_column(next, i));
    for (int k = 0; yes >> k; k++) {
        if (!(yes >> k & 1))
            continue;
        if (w->count == QUEUE_SIZE) {
            mark(w, next->slot[k]);
            continue;
        }
        check_push(w->count, refracted);
        struct queued *to = &w->queue[w->count++];
        enqueue(to, number, next, k);
        to->depth += !straight;
        to->layers += straight;
    }
}

/* Takes up to LANES queued rays; returns their lanes, without those whose samples have become undecided. */
static unsigned pop(struct work *w, struct rays *r)
{
    const double *row[LANES];
    int taken = dequeue(w->queue, &w->count, r, row);
    unsigned lanes = 0;

    for (int i = 0; i < COLUMNS; i++)
        *ray_column(r, i) = vgather(row, i);
    for (int k = 0; k < taken; k++) {
        bool open = !w->block->unsure[r->slot[k]];
        check_pop(w->count + taken - 1 - k);
        lanes |= (unsigned)open << k;
        if (open)
            count_rays(w, r->slot[k], 1);
    }
    return lanes;
}

/* Queues hits, to be shaded later. */
static void push_hits(struct work *w, unsigned lanes, struct rays *r, struct query *q)
{
    double number[COLUMNS][LANES];

    for (int i = 0; i < COLUMNS; i++)
        vstore(number[i], *hit_column(r, q, i));
    for (; lanes; lanes &= lanes - 1)
        enqueue(&w->hits[w->hit_count++], number, r, __builtin_ctz(lanes));
}

static unsigned pop_hits(struct work *w, struct rays *r, struct query *q)
{
    const double *row[LANES];
    int taken = dequeue(w->hits, &w->hit_count, r, row);
    unsigned lanes = 0;

    for (int i = 0; i < COLUMNS; i++)
        *hit_column(r, q, i) = vgather(row, i);
    for (int k = 0; k < taken; k++)
        lanes |= (unsigned)!w->block->unsure[r->slot[k]] << k;
    return lanes;
}

#endif
