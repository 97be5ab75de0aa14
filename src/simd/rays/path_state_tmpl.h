/* path_state_tmpl.h - path states of a block: at most one queued ray per sample.
 *
 * Parameters: the doubles of isa/isa.h. Defines: path_open(), path_start(), path_push(), path_pop(), fullest(),
 * path_quads(), quads_of_paths(), path_choice(), mark_unsure(), sure_of(), note_hits(),
 * note_shadows(), find_first(), find_hidden(), struct paths,
 * struct path_state. */
#ifndef TIA_SIMD_RAYS_PATH_STATE_TMPL_H
#define TIA_SIMD_RAYS_PATH_STATE_TMPL_H

#include <stddef.h>

#include "render/path/path.h"
#include "scatter_tmpl.h"
#include "tracer_tmpl.h"

#define PATH_COLUMNS 17

/* A queued ray. Its media stay here even while it is traced. */
struct queued_path {
    double number[PATH_COLUMNS];
    uint32_t bounce, layers;
    bool specular;
    struct media media;
};

/* Rays whose directions have the same signs are queued together: all lanes of such a packet enter a box by the same
 * planes. */
#define OCTANTS 8

/* Paths of a packet: their rays, and the density with which each path was scattered in the direction of its ray.
 * r.depth counts bounces. */
struct paths {
    struct rays r;
    struct ve density;
    unsigned specular;
};

struct path_state {
    struct room room; /* `room` to `paths` belong to one packet; they are too large for a stack */
    struct query query;
    struct shade shade;
    struct lobes lobes;
    struct emitter_view sight, other;
    struct shadow shadow;
    struct response response;
    struct paths paths;
    struct quads next; /* those of the packet's next directions, if next_known */
    bool next_known;
    struct sure_gather *gather;
    uint32_t blocker;
    uint32_t seed[SURE_GATHERED]; /* seed of each sample's pixel */
    struct queued_path ray[SURE_GATHERED];
    uint16_t waits[OCTANTS][SURE_GATHERED];
    int count[OCTANTS];
};

#define PLACE_OF(member) offsetof(struct paths, member)

/* Returns number i of a queued ray, in all lanes. */
LANE_OP vd *path_column(struct paths *p, int i)
{
    static const uint16_t place[PATH_COLUMNS] = {
        PLACE_OF(r.p.o.x),      PLACE_OF(r.p.o.y),   PLACE_OF(r.p.o.z),         PLACE_OF(r.p.d.x),
        PLACE_OF(r.p.d.y),      PLACE_OF(r.p.d.z),   PLACE_OF(r.weight[0]),     PLACE_OF(r.weight[1]),
        PLACE_OF(r.weight[2]),  PLACE_OF(r.p.eo),    PLACE_OF(r.p.ed),          PLACE_OF(r.ew),
        PLACE_OF(density.v),    PLACE_OF(density.e), PLACE_OF(r.p.from.object), PLACE_OF(r.p.from.element),
        PLACE_OF(r.p.from.side)};

    return (vd *)(void *)((char *)p + place[i]);
}

#undef PLACE_OF

LANE_OP void mark_unsure(struct path_state *f, unsigned lanes, const uint32_t slot[LANES])
{
    for (int k = 0; lanes >> k; k++)
        if (lanes >> k & 1)
            f->gather->unsure[slot[k]] = true;
}

/* Marks the samples of `unsure` lanes as undecided; returns the other lanes. */
LANE_OP unsigned sure_of(struct path_state *f, unsigned lanes, vm unsure, const uint32_t slot[LANES])
{
    unsigned gone = lanes & mbits(unsure);

    mark_unsure(f, gone, slot);
    return lanes & ~gone;
}

/* Returns the number of a lane's ray on its path, ESTIMATE_KNOWN at most. */
LANE_OP uint32_t ray_number(const struct paths *p, int k)
{
    uint32_t number = p->r.depth[k] + p->r.layers[k];

    return number < ESTIMATE_KNOWN ? number : ESTIMATE_KNOWN;
}

/* Notes what the rays of these lanes certainly meet. */
LANE_OP void note_hits(struct path_state *f, unsigned lanes, const struct paths *p, const struct query *q)
{
    const vd none = vset(TIA_NO_OBJECT);
    vm light = vle(vset(LIGHT_ID), q->id), object = mand(vle(vset(0), q->id), mnot(light));
    const vi words[2] = {whole_words(vsel(object, q->id, none)),
                         whole_words(vsel(light, q->id - vset(LIGHT_ID), none))};
    int64_t met[2][LANES];

    __builtin_memcpy(met, words, sizeof met);
    for (; lanes; lanes &= lanes - 1) {
        int k = __builtin_ctz(lanes);
        struct estimate_known *known = &f->gather->known[p->r.slot[k]];
        uint32_t i = ray_number(p, k);
        if (i == ESTIMATE_KNOWN)
            continue;
        known->count = i + 1;
        known->hit[i].object = (uint32_t)met[0][k];
        known->hit[i].light = (uint32_t)met[1][k];
    }
}

/* Notes that the shadow rays of these lanes certainly reach their light, or do not. */
LANE_OP void note_shadows(struct path_state *f, unsigned lanes, unsigned seen, const struct paths *p)
{
    for (; lanes; lanes &= lanes - 1) {
        int k = __builtin_ctz(lanes);
        struct estimate_known *known = &f->gather->known[p->r.slot[k]];
        uint32_t bit = UINT32_C(1) << ray_number(p, k);
        known->shadows_known |= bit;
        known->lights_reached |= seen >> k & 1 ? bit : 0;
    }
}

LANE_OP void path_push(struct path_state *f, struct paths *next, unsigned lanes)
{
    double number[PATH_COLUMNS][LANES];

    for (int i = 0; i < PATH_COLUMNS; i++)
        vstore(number[i], *path_column(next, i));
    for (int k = 0; lanes >> k; k++) {
        if (!(lanes >> k & 1))
            continue;
        uint32_t slot = next->r.slot[k];
        struct queued_path *to = &f->ray[slot];
        unsigned octant =
            (unsigned)(number[3][k] < 0) | (unsigned)(number[4][k] < 0) << 1 | (unsigned)(number[5][k] < 0) << 2;
        for (int i = 0; i < PATH_COLUMNS; i++)
            to->number[i] = number[i][k];
        to->bounce = next->r.depth[k];
        to->layers = next->r.layers[k];
        to->specular = next->specular >> k & 1;
        f->waits[octant][f->count[octant]++] = (uint16_t)slot;
    }
}

static int fullest(const struct path_state *f)
{
    int most = 0;

    for (int i = 1; i < OCTANTS; i++)
        most = f->count[i] > f->count[most] ? i : most;
    return most;
}

/* Takes up to LANES queued rays, those of the fullest octant first; returns their lane mask. */
static unsigned path_pop(struct path_state *f, struct paths *p)
{
    static const double none[PATH_COLUMNS];
    const double *row[LANES];
    int octant = fullest(f), taken = 0;

    p->specular = 0;
    for (int k = 0; k < LANES; k++) {
        row[k] = none;
        p->r.slot[k] = p->r.depth[k] = p->r.layers[k] = 0;
    }
    for (; taken < LANES && f->count[octant]; taken++) {
        uint32_t slot = f->waits[octant][--f->count[octant]];
        const struct queued_path *from = &f->ray[slot];
        row[taken] = from->number;
        p->r.slot[taken] = slot;
        p->r.depth[taken] = from->bounce;
        p->r.layers[taken] = from->layers;
        p->specular |= (unsigned)from->specular << taken;
        octant = f->count[octant] ? octant : fullest(f);
    }
    for (int i = 0; i < PATH_COLUMNS; i++)
        *path_column(p, i) = vgather(row, i);
    return (1u << taken) - 1;
}

LANE_OP struct quads quads_of_paths(const struct path_state *f, const uint32_t slot[LANES], const uint32_t quad[LANES])
{
#define SEED(k) f->seed[slot[k]]
#define INDEX(k) f->gather->index[slot[k]]
    return quads_of((vu){EACH_LANE(SEED)}, (vu){EACH_LANE(INDEX)}, vu_load(quad));
#undef SEED
#undef INDEX
}

/* Returns a quad of each lane's bounce. `which` is 0 for a point on a light and the next direction, 1 for choices, see
 * PATH_QUAD. */
LANE_OP struct quads path_quads(const struct path_state *f, const struct paths *p, uint32_t which)
{
    uint32_t quad[LANES];

    for (int k = 0; k < LANES; k++)
        quad[k] = PATH_QUAD(p->r.depth[k], which);
    return quads_of_paths(f, p->r.slot, quad);
}

LANE_OP vu path_choice(const struct path_state *f, const struct paths *p, enum path_choice choice)
{
    struct quads quads = path_quads(f, p, 1);

    return quads_number(&quads, choice);
}

/* Computes a camera ray by the fixed-point code: its origin, and a vector of any length along it. The camera's window
 * is small but has units of 2^-45 too, so that a bound on its rounding would exceed all other bounds. */
static void camera_ray(const struct ray_camera *camera, struct light_pixel pixel, const uint32_t u[2], double o[3],
                       double way[3])
{
    struct ray ray;

    if (ray_camera_is_pinhole(camera)) {
        sure_point(o, camera->eye);
        sure_point(way, ray_camera_way_within(camera, &pixel, u));
        return;
    }
    ray_camera_ray_within(camera, &pixel, 0, u, &ray);
    sure_point(o, ray.origin);
    sure_dir(way, ray.direction);
}

/* Sets the camera rays of a packet. */
static void first_paths(const struct path_state *f, struct paths *p, const struct quads *first)
{
    const struct sure_gather *g = f->gather;
    double o[LANES][3], way[LANES][3];
    const double *from[LANES], *to[LANES];
    uint32_t numbers[2][LANES];

    vu_store(numbers[0], quads_number(first, 0));
    vu_store(numbers[1], quads_number(first, 1));
    for (int k = 0; k < LANES; k++) {
        const uint32_t u[2] = {numbers[0][k], numbers[1][k]}, slot = p->r.slot[k];
        camera_ray(&g->scene->view->camera, ray_pixel_at(g->x[slot], g->y[slot]), u, o[k], way[k]);
        from[k] = o[k];
        to[k] = way[k];
    }
    p->r.p.o = v3_gather(from, 0);
    p->r.p.eo = v3_sum(p->r.p.o) * BOUND(FIRST_ORIGIN);
    struct v3 along = v3_gather(to, 0);
    p->r.p.d = v3_unit(along, v3_sum(along) * BOUND(FIRST_WAY), &p->r.p.ed);
    p->r.p.from = (struct origin){vset(-1), vset(0), vset(0)};
}

/* Starts up to LANES samples beginning with `from`; returns their lane mask. *first receives their first quads. */
static unsigned path_start(struct path_state *f, int from, struct paths *p, struct quads *first)
{
    const struct sure_gather *g = f->gather;
    uint32_t quad[LANES];
    unsigned lanes = 0;

    for (int k = 0; k < LANES; k++) {
        p->r.slot[k] = (uint32_t)(from + k < g->count ? from + k : g->count - 1);
        p->r.depth[k] = p->r.layers[k] = f->ray[p->r.slot[k]].media.count = 0;
        quad[k] = ESTIMATE_FIRST_QUAD;
        lanes |= (unsigned)(from + k < g->count) << k;
    }
    *first = quads_of_paths(f, p->r.slot, quad);
    first_paths(f, p, first);
    p->r.weight[0] = p->r.weight[1] = p->r.weight[2] = vset(1);
    p->r.ew = vset(0);
    p->density = ve_of(vset(0), vset(0));
    p->specular = lanes;
    return lanes;
}

static void path_open(struct path_state *f, struct sure_gather *g)
{
    uint32_t seed = g->scene->view->scene->integration.seed;

    f->gather = g;
    f->room.scattered = true;
    f->blocker = TIA_NO_OBJECT;
    for (int i = 0; i < g->count; i++) {
        f->seed[i] = sampler_of(seed, g->x[i], g->y[i], 0).seed;
        g->colour[i][0] = g->colour[i][1] = g->colour[i][2] = g->error[i] = 0;
        g->unsure[i] = false;
        g->known[i].count = g->known[i].shadows_known = g->known[i].lights_reached = 0;
    }
    for (int i = 0; i < OCTANTS; i++)
        f->count[i] = 0;
}

/* Finds the nearest hit of each ray with an object and, if `lights` is set, with a light that paths can meet. Point
 * lights are met only in `specular` lanes. */
static void find_first(const struct sure_scene *s, struct room *room, struct query *q, struct packet *p, unsigned lanes,
                       bool lights, unsigned specular)
{
    vm wild = begin_nearest(s, room, q, p, mof(lanes));

    for (uint32_t n = 0; lights && n < s->light_count; n++) {
        const struct sure_light *l = &s->lights[n];
        bool point = !(PATH_SURFACES >> l->from->kind & 1);
        if (!l->seen || !(PATH_SEEN >> l->from->kind & 1) || (point && !(specular & lanes)))
            continue;
        vm all = q->active;
        q->active = point ? mand(all, mof(specular & lanes)) : all;
        q->object = vset(LIGHT_ID + n);
        meet_light(l, q);
        q->active = all;
    }
    end_nearest(q, wild);
}

/* Intersects light number n in the lanes whose rays do not end at it. */
LANE_OP void meet_other_light(const struct sure_scene *s, uint32_t n, const uint32_t ends[LANES], struct query *q)
{
    unsigned here = 0;

    for (int k = 0; k < LANES; k++)
        here |= (unsigned)(ends[k] == n) << k;
    vm mine = mand(q->active, mof(here));
    q->active = mand(q->active, mnot(mof(here)));
    q->object = vset(LIGHT_ID + n);
    if (any(q->active))
        meet_light(&s->lights[n], q);
    q->active = mor(q->active, mine);
}

/* Decides which rays are occluded before their ends. Objects occlude, even transparent ones. So do lights with a
 * surface, unless `ends` is NULL.
 *
 * ends[k] is the number of the light at which the ray of lane k ends, 2^-26 before the light's surface along the
 * normal. That light is not tested. In fixed point it never occludes: the ray ends 2^-26 off the light's plane or
 * sphere, and roundings move the intersection by no more than 2^-42, or 2^-43 of the sphere's radius, wherever the ray
 * starts. In doubles a test would be undecided, since the bound of the intersection is as large as that of the ray's
 * origin. */
static void find_hidden(const struct sure_scene *s, struct room *room, struct shadow *shadow, unsigned lanes,
                        const uint32_t *ends, uint32_t *blocker)
{
    vm active = mof(lanes), fine = packet_start(s->centre, s->extent, &shadow->p, active);
    struct query *q = &room->any;

    q->p = &shadow->p;
    q->room = room;
    q->work = SURE_PACKET + s->unbounded_count + (ends ? s->light_count : 0);
    q->active = mand(active, fine);
    q->any = q->solid = q->opaque = true;
    q->blocker = q->index = q->tested = *blocker;
    q->groups = NULL;
    q->group = 0;
    q->distance = shadow->distance;
    q->edistance = shadow->edistance;
    q->limit = q->distance + q->edistance;
    q->blocked = q->maybe = q->met = q->may_meet = mnone();
    q->t = q->e = q->ep = q->low = q->id = q->element = q->ethrough = vset(0);
    for (int c = 0; c < 3; c++)
        q->through[c] = vset(1);
    for (uint32_t n = 0; ends && n < s->light_count; n++)
        if (s->lights[n].seen && (PATH_SURFACES >> s->lights[n].from->kind & 1))
            meet_other_light(s, n, ends, q);
    if (*blocker != TIA_NO_OBJECT && any(q->active))
        meet_one(s, *blocker, q);
    if (any(q->active))
        meet_unbounded(s, q);
    if (any(q->active))
        walk_objects(s, q);
    *blocker = q->blocker;
    shadow->work = q->work;
    shadow->blocked = q->blocked;
    shadow->unsure = mor(mand(q->maybe, mnot(q->blocked)), mand(active, mnot(fine)));
}

#endif
