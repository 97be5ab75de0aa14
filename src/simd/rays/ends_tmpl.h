/* ends_tmpl.h - light that paths collect at their ends and on their way: background, visible lights, and emission.
 *
 * Parameters: the doubles of isa/isa.h. Defines: add_part(), add_far_ends(), add_glow(). */
#ifndef TIA_SIMD_RAYS_ENDS_TMPL_H
#define TIA_SIMD_RAYS_ENDS_TMPL_H

#include "path_state_tmpl.h"

/* Adds radiance times throughput. In fixed point, products are rounded by half a unit each, sums are exact, and
 * products of 2^17 and more are clipped. Lanes with products that may reach 2^16 are undecided. */
static void add_part(struct path_state *f, unsigned lanes, const struct paths *p, const vd rgb[3], vd e)
{
    vd most = most3(rgb), thick = most3(p->r.weight) + p->r.ew;
    double part[3][LANES], error[LANES];

    lanes = sure_of(f, lanes, mnot(vlt((most + e) * thick, vset(65536))), p->r.slot);
    for (int c = 0; c < 3; c++)
        vstore(part[c], p->r.weight[c] * rgb[c]);
    vstore(error, BOUND_OF(ADDED_THROUGHPUT, most * p->r.ew) + BOUND_OF(ADDED, e * thick) + BOUND(ADDED_UNITS) +
                      most * thick * BOUND(ADDED_ROUNDING));
    for (int k = 0; lanes >> k; k++) {
        if (!(lanes >> k & 1))
            continue;
        for (int c = 0; c < 3; c++)
            f->gather->colour[p->r.slot[k]][c] += part[c][k];
        f->gather->error[p->r.slot[k]] += error[k];
    }
}

/* Returns the balance heuristic's weight q/(q + p/n) of an emitter that a path has met. q is the density of the path's
 * direction, and p that of sampling this emitter, one of n. */
LANE_OP struct ve weight_of(const struct sure_paths *paths, const struct paths *p, struct ve chosen, vm *fine)
{
    struct ve q = p->density, other = {chosen.v * paths->one_of, chosen.e * paths->one_of};
    vm specular = mof(p->specular), good = vlt(BOUND(BALANCE_KNOWN) * (q.e + other.e), q.v + other.v);
    vd inverse = 1 / vsel(good, q.v + other.v, vset(1)), v = q.v * inverse;
    vd e = BOUND_OF(BALANCE, BOUND(BALANCE_QUOTIENT) * inverse * (other.v * inverse * q.e + v * other.e)) +
           BOUND(BALANCE_ROUNDING);

    *fine = mor(specular, mand(*fine, good));
    return ve_of(vsel(specular, vset(1), v), vsel(specular, vset(0), e));
}

/* Adds radiance times a weight. The fixed-point code multiplies by the weight last, after it has clipped products of
 * 2^17 and more. */
LANE_OP void add_weighted(struct path_state *f, unsigned lanes, const struct paths *p, const vd rgb[3],
                          struct ve weight, vm fine)
{
    vd most = most3(rgb), part[3];

    fine = mand(fine, vlt((most + BOUND(WEIGHTED_CUT)) * (most3(p->r.weight) + p->r.ew), vset(65536)));
    lanes = sure_of(f, lanes, mnot(fine), p->r.slot);
    for (int c = 0; c < 3; c++)
        part[c] = rgb[c] * weight.v;
    add_part(f, lanes, p, part,
             BOUND_OF(WEIGHTED, most * (weight.e + BOUND(WEIGHTED_ROUNDING))) + BOUND(WEIGHTED_UNITS));
}

/* Adds the radiance of light number n in the lanes whose paths meet it. */
static void add_seen_light(struct path_state *f, unsigned lanes, uint32_t n, const struct paths *p,
                           const struct query *q)
{
    const struct sure_scene *s = f->gather->scene;
    const struct sure_light *l = &s->lights[n];
    const struct sure_shine *shine = &s->paths->lights[n];
    vd rgb[3] = {vset(shine->radiance[0]), vset(shine->radiance[1]), vset(shine->radiance[2])};
    struct ve weight = {vset(1), vset(0)}, chosen;
    vm fine = mnot(mnone());

    if ((lanes & ~p->specular) && tia_light_has(l->from->kind, TIA_LIGHT_AREA)) {
        vd ed = BOUND_OF(MET_DISTANCE, q->e + BOUND(MET_UNITS) + vabs(q->t) * BOUND(MET_ROUNDING) + p->r.p.eo);
        if (tia_light_has(l->from->kind, TIA_LIGHT_BALL))
            chosen = ball_density(l->at, l->radius, p->r.p.o, p->r.p.eo, &fine);
        else
            chosen = plane_density(shine, q->t, ed, v3_dot(p->r.p.d, v3_set(l->normal)),
                                   BOUND_OF(MET_COSINE, p->r.p.ed + BOUND(COSINE)), &fine);
        weight = weight_of(s->paths, p, chosen, &fine);
        if (!shine->known)
            fine = mand(fine, mof(p->specular));
    }
    add_weighted(f, lanes, p, rgb, weight, fine);
}

/* Adds the background, or the light that is met, to paths that end at no object. Returns the other lanes. */
static unsigned add_far_ends(struct path_state *f, unsigned lanes, const struct paths *p, const struct query *q)
{
    const struct sure_scene *s = f->gather->scene;
    unsigned sky = lanes & mbits(vle(vset(INFINITE), q->t)),
             shining = lanes & ~sky & ~mbits(vlt(q->id, vset(LIGHT_ID)));
    double id[LANES];

    if (sky) {
        const vd rgb[3] = {vset(s->background[0]), vset(s->background[1]), vset(s->background[2])};
        add_part(f, sky, p, rgb, vset(0));
    }
    lanes &= ~(sky | shining);
    vstore(id, q->id);
    while (shining) {
        double first = id[__builtin_ctz(shining)];
        unsigned same = mbits(mand(vle(q->id, vset(first)), vle(vset(first), q->id))) & shining;
        add_seen_light(f, same, (uint32_t)(first - LIGHT_ID), p, q);
        shining &= ~same;
    }
    return lanes;
}

/* Adds the emission of surfaces. For the scene's spheres it is weighted, since these are sampled as emitters too. */
static void add_glow(struct path_state *f, unsigned lanes, const struct paths *p, const struct shade *h,
                     const struct lobes *l)
{
    const struct sure_scene *s = f->gather->scene;
    double glow[LANES];
    unsigned sphere = 0;
    struct ve weight = {vset(1), vset(0)};
    vm fine = mnot(mnone());
    vd rgb[3], flat[3];

    unsigned glows = lanes & mbits(vlt(vset(0), most3(h->emission)));
    unsigned flats = lanes & mbits(vlt(vset(0), most3(h->flat)));
    if (!(glows | flats))
        return;
    for (int k = 0; k < LANES; k++) {
        glow[k] = l->of[k]->glow;
        sphere |= (unsigned)(h->index[k] < s->view->scene->sphere_count) << k;
    }
    for (int c = 0; c < 3; c++)
        rgb[c] = h->emission[c] * vload(glow);
    for (unsigned left = glows & sphere & ~p->specular; left; left &= left - 1) {
        unsigned one = left & -left;
        const struct sure_object *o = h->object[__builtin_ctz(one)];
        vm good = mnot(mnone()), here = mof(one);
        struct ve chosen = ball_density(o->at, o->radius, p->r.p.o, p->r.p.eo, &good);
        struct ve w = weight_of(s->paths, p, chosen, &good);
        weight = ve_sel(here, w, weight);
        fine = mand(fine, mor(good, mnot(here)));
    }
    if (glows)
        add_weighted(f, glows, p, rgb, weight, fine);
    if (!flats)
        return;
    vd facing = vmax(h->facing, vset(0));
    for (int c = 0; c < 3; c++)
        flat[c] = h->flat[c] * facing;
    add_part(f, flats, p, flat, BOUND_OF(FACING_LIGHT, most3(h->flat) * h->efacing) + BOUND(FACING_UNITS));
}

#endif
