/* glass_tmpl.h - continuation of paths at mirrors and glass.
 *
 * Parameters: the doubles of isa/isa.h. Defines: multiply_by(), divide_by(), go_on(), enter_glass(). */
#ifndef TIA_SIMD_RAYS_GLASS_TMPL_H
#define TIA_SIMD_RAYS_GLASS_TMPL_H

#include "path_state_tmpl.h"

/* Multiplies throughputs by a material's constants. */
LANE_OP void multiply_by(struct paths *p, const vd factor[3])
{
    vd most = most3(p->r.weight);

    for (int c = 0; c < 3; c++)
        p->r.weight[c] = p->r.weight[c] * factor[c];
    p->r.ew = BOUND_OF(MULTIPLIED_WEIGHT, p->r.ew * most3(factor)) + BOUND(THROUGHPUT_UNIT) +
              most * BOUND(THROUGHPUT_ROUNDING);
}

/* Divides throughputs by chances. Returns the lanes that are undecided, as their chance is too small. A quotient w/c is
 * off by (ew + w/c ec)/c', and 1/c' <= (1 + 2 ec/c)/c where 16 ec < c. */
LANE_OP vm divide_by(struct paths *p, struct ve chance, vm lanes)
{
    vm known = mand(lanes, vlt(BOUND(DIVIDED_KNOWN) * chance.e, chance.v));
    vd inverse = 1 / vsel(known, chance.v, vset(1)), part = vsel(known, chance.e * inverse, vset(0));

    for (int c = 0; c < 3; c++)
        p->r.weight[c] = p->r.weight[c] * inverse;
    vd most = most3(p->r.weight);
    p->r.ew = BOUND_OF(DIVIDED_WEIGHT, (p->r.ew * inverse + most * part) * (1 + BOUND(DIVIDED_QUOTIENT) * part)) +
              vsel(known, BOUND(THROUGHPUT_UNIT) + most * BOUND(THROUGHPUT_ROUNDING), vset(0));
    return mand(lanes, mnot(known));
}

/* Returns the lanes whose fixed-point throughput is certainly not clipped, and marks the others as undecided.
 * Throughputs of 2^17 and more are clipped and stay too small from then on, even if the path adds only little light. */
LANE_OP unsigned uncut(struct path_state *f, unsigned lanes, const struct paths *next, const uint32_t slot[LANES])
{
    return sure_of(f, lanes, mnot(vlt(most3(next->r.weight) + next->r.ew, vset(65536))), slot);
}

LANE_OP void keep_media(struct path_state *f, unsigned lanes, const struct paths *p, const struct media media[LANES])
{
    for (; lanes; lanes &= lanes - 1) {
        int k = __builtin_ctz(lanes);
        f->ray[p->r.slot[k]].media = media[k];
    }
}

/* Queues the next rays of these lanes, with one bounce more. `media` holds the new media of each lane; NULL: unchanged.
 * A path without throughput ends. Where only the fixed-point throughput is 0, the path continues, and adds no more than
 * its error bound. */
LANE_OP void go_on(struct path_state *f, unsigned lanes, const struct paths *p, struct paths *next,
                   const struct media *media)
{
    lanes = uncut(f, lanes, next, p->r.slot) & mbits(vlt(vset(0), most3(next->r.weight)));
    for (int k = 0; k < LANES; k++) {
        next->r.slot[k] = p->r.slot[k];
        next->r.depth[k] = p->r.depth[k] + 1;
        next->r.layers[k] = p->r.layers[k];
    }
    if (media)
        keep_media(f, lanes, p, media);
    path_push(f, next, lanes);
}

/* Returns the lanes that reflect, by Fresnel's equations and the random numbers `given`. *unsure receives the lanes
 * whose chance of reflection, cut to 32 bits, may lie on either side of the random number. */
static unsigned reflected_by(const struct refraction *r, const struct shade *h, unsigned lanes, vu given,
                             unsigned *unsure)
{
    double fresnel[LANES], e[LANES];
    unsigned total = mbits(r->total) & lanes, partly = mbits(mand(r->bends, h->fresnel)) & lanes, reflected = total;
    uint32_t number[LANES];

    vstore(fresnel, r->fresnel);
    vstore(e, r->efresnel);
    vu_store(number, given);
    *unsure = 0;
    for (int k = 0; k < LANES; k++) {
        double low = (fresnel[k] - e[k]) * 4294967296.0 - BOUND(REFLECTED_CHANCE),
               high = (fresnel[k] + e[k]) * 4294967296.0 + BOUND(REFLECTED_CHANCE);
        if (!(partly >> k & 1))
            continue;
        if (number[k] < low)
            reflected |= 1u << k;
        else if (number[k] <= high)
            *unsure |= 1u << k;
    }
    return reflected;
}

/* Passes straight through a boundary with equal indices of refraction on both sides; this adds a layer, not a bounce.
 */
static void pass_straight(struct path_state *f, unsigned lanes, const struct paths *p, struct paths *next,
                          const struct shade *h, const struct media media[LANES])
{
    const double bias = f->gather->scene->bias;
    unsigned passes = 0;

    lanes = uncut(f, lanes, next, p->r.slot);
    next->r.p.o = v3_along(h->point, h->viewer, vset(-bias));
    next->r.p.eo = BOUND_OF(STRAIGHT_ON, h->ep + BOUND_OF(STRAIGHT_ON_TURN, h->ev * vset(bias))) + BOUND(POINT_UNITS) +
                   v3_sum(next->r.p.o) * BOUND(POINT_ROUNDING);
    next->r.p.d = p->r.p.d;
    next->r.p.ed = p->r.p.ed;
    next->r.p.from = leaving(h, next->r.p.d, next->r.p.ed, -1, BOUND(LEAVING_STEEP)); /* see struct origin */
    next->specular = lanes;
    for (int k = 0; k < LANES; k++) {
        next->r.slot[k] = p->r.slot[k];
        next->r.depth[k] = p->r.depth[k];
        next->r.layers[k] = p->r.layers[k] + 1;
        passes |= (unsigned)(next->r.layers[k] <= TIA_LAYERS_MAX) << k & lanes;
    }
    keep_media(f, passes, p, media);
    path_push(f, next, passes & mbits(vlt(vset(0), most3(next->r.weight))));
}

/* Reflects or refracts paths at random, like go_through() of path.c. */
static __attribute__((noinline)) void enter_glass(struct path_state *f, unsigned lanes, const struct paths *p,
                                                  const struct shade *h, const struct lobes *l, vu number)
{
    const struct sure_scene *s = f->gather->scene;
    struct refraction r;
    struct paths next = *p;
    unsigned unsure;
    vd q, part;

    for (int k = 0; k < LANES; k++)
        next.r.media[k] = f->ray[p->r.slot[k]].media;
    find_boundaries(s, h, lanes, &next.r, &r, &q, &part);
    refract(h, mof(lanes), q, part, &r);
    lanes = sure_of(f, lanes, r.unsure, p->r.slot);
    unsigned reflected = reflected_by(&r, h, lanes, number, &unsure), straight = mbits(r.straight) & lanes;
    mark_unsure(f, unsure, p->r.slot);
    lanes &= ~unsure;
    multiply_by(&next, h->refraction);
    lanes = sure_of(f, lanes, divide_by(&next, ve_of(l->chance[CHANCE_GLASS], l->spread), mof(lanes)), p->r.slot);
    if (lanes & straight)
        pass_straight(f, lanes & straight, p, &next, h, r.media);
    lanes &= ~straight;
    next.specular = lanes;
    if (lanes & reflected) {
        next.r.p.o = h->outside;
        next.r.p.eo = h->eoutside;
        next.r.p.d = l->mirrored;
        next.r.p.ed = l->emirrored;
        next.r.p.from = leaving(h, next.r.p.d, next.r.p.ed, 1, 0);
        go_on(f, lanes & reflected, p, &next, NULL);
    }
    lanes &= ~reflected;
    if (lanes) {
        next.r.p.o = off_surface(s, h, -s->bias, &next.r.p.eo);
        next.r.p.d = r.to;
        next.r.p.ed = r.eto;
        next.r.p.from = leaving(h, next.r.p.d, next.r.p.ed, -1, 0);
        go_on(f, lanes, p, &next, r.media);
    }
}

#endif
