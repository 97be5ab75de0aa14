/* look_tmpl.h - sampling of one emitter for each path, and the light that it sends to the path's surface.
 *
 * Parameters: the doubles of isa/isa.h. Defines: look_for_lights(). */
#ifndef TIA_SIMD_RAYS_LOOK_TMPL_H
#define TIA_SIMD_RAYS_LOOK_TMPL_H

#include "ends_tmpl.h"

LANE_OP void merge_sights(vm m, const struct emitter_view *one, struct emitter_view *a)
{
    a->to = v3_sel(m, one->to, a->to);
    a->eto = vsel(m, one->eto, a->eto);
    a->distance = vsel(m, one->distance, a->distance);
    a->edistance = vsel(m, one->edistance, a->edistance);
    a->density = ve_sel(m, one->density, a->density);
    a->factor = vsel(m, one->factor, a->factor);
    a->efactor = vsel(m, one->efactor, a->efactor);
    a->some = mor(mand(m, one->some), mand(mnot(m), a->some));
    a->unsure = mor(mand(m, one->unsure), mand(mnot(m), a->unsure));
}

/* Samples each emitter that lanes have chosen, once for all of them, into f->sight. *surface receives the lanes whose
 * emitter has a surface. */
static void find_sights(struct path_state *f, unsigned lanes, const uint32_t which[LANES], const struct shade *h,
                        const vu u[2], vd radiance[3], unsigned *surface)
{
    const struct sure_scene *s = f->gather->scene;
    struct emitter_view *a = &f->sight, *one = &f->other;
    unsigned same;

    *surface = 0;
    for (unsigned left = lanes; left; left &= ~same) {
        uint32_t number = which[__builtin_ctz(left)];
        const struct sure_emitter *e = &s->paths->emitters[number];
        same = 0;
        for (int k = 0; k < LANES; k++)
            same |= (unsigned)(which[k] == number) << k & left;
        see_emitter(s, e, h->outside, h->eoutside, u, left == lanes ? a : one);
        if (left != lanes)
            merge_sights(mof(same), one, a);
        for (int c = 0; c < 3; c++)
            radiance[c] =
                left == lanes ? vset(e->shine->radiance[c]) : vsel(mof(same), vset(e->shine->radiance[c]), radiance[c]);
        if (e->light == TIA_NO_OBJECT || tia_light_has(s->lights[e->light].from->kind, TIA_LIGHT_AREA))
            *surface |= same;
    }
}

/* Adds reflectance times radiance, divided by the sum of the densities with which the path could have chosen the
 * sampled point; scattering chooses points of a surface only. */
static void add_sights(struct path_state *f, unsigned lanes, const struct paths *p, const struct shade *h,
                       const struct emitter_view *a, const vd radiance[3], unsigned surface)
{
    const double one_of = f->gather->scene->paths->one_of;
    struct response *r = &f->response;
    vm m = mof(surface);
    struct ve chosen = {vsel(m, a->density.v * one_of, vset(one_of)), vsel(m, a->density.e * one_of, vset(0))};

    drop_density(m, r);
    struct ve density = {chosen.v + r->density.v, chosen.e + r->density.e};
    vm fine = mand(vlt(BOUND(SHARE_KNOWN) * density.e, density.v),
                   mand(vlt(vset(BOUND(SHARE_LEAST)), density.v), vlt(density.v, vset(1e15))));
    vd inverse = 1 / vsel(fine, density.v, vset(1)), part[3], bright = most3(radiance);
    vd share = most3(r->rgb) * inverse, eshare = reflectance_error(h, r, chosen, inverse, share);

    fine = mand(fine, vlt(share + eshare, vset(65536)));
    fine = mand(fine, vlt(bright, vset(65536)));
    for (int c = 0; c < 3; c++)
        part[c] = r->rgb[c] * inverse * (radiance[c] * a->factor);
    vd light = bright * a->factor, elight = BOUND_OF(SEEN_LIGHT, bright * a->efactor) + BOUND(SEEN_LIGHT_UNIT);
    vd e = BOUND_OF(SEEN_PART, share * elight + eshare * (light + elight)) + BOUND(SEEN_PART_UNITS) +
           share * light * BOUND(SEEN_PART_ROUNDING);
    lanes = sure_of(f, lanes, mnot(fine), p->r.slot);
    add_part(f, lanes, p, part, e);
}

/* Chooses each lane's emitter, and the random numbers of a point on it. After a bounce, the next direction belongs to
 * the same quad. */
LANE_OP void choose_emitters(struct path_state *f, unsigned lanes, const struct paths *p, uint32_t which[LANES],
                             vu u[2])
{
    uint64_t count = f->gather->scene->paths->emitter_count;
    struct quads quads = path_quads(f, p, 0);
    unsigned bounced = 0;

    for (int k = 0; k < LANES; k++)
        bounced |= (unsigned)(p->r.depth[k] > 0) << k;
    if (!f->next_known && !(lanes & ~bounced)) {
        f->next = quads;
        f->next_known = true;
    }
    vu_store(which, count > 1 ? path_choice(f, p, CHOICE_LIGHT) : (vu){0});
    for (int k = 0; k < LANES; k++)
        which[k] = (uint32_t)(which[k] * count >> 32);
    u[0] = quads_number(&quads, 0);
    u[1] = quads_number(&quads, 1);
}

/* Adds the light that each path's surface reflects from its emitter. Returns the lanes that are still certain. */
static unsigned look_for_lights(struct path_state *f, unsigned lanes, const struct paths *p, const struct shade *h,
                                const struct lobes *l)
{
    const struct sure_scene *s = f->gather->scene;
    uint32_t which[LANES], ends[LANES];
    unsigned rough = 0, surface;
    const struct emitter_view *a = &f->sight;
    struct shadow *shadow = &f->shadow;
    vd radiance[3];
    vu u[2];

    for (int k = 0; k < LANES; k++)
        rough |= (unsigned)l->of[k]->rough << k & lanes;
    if (!rough || !s->paths->emitter_count)
        return lanes;
    choose_emitters(f, lanes, p, which, u);
    find_sights(f, rough, which, h, u, radiance, &surface);
    struct cosines of = cosines_of(h, l, a->to, a->eto);
    vd above = v3_dot(a->to, h->geometric), ea = BOUND_OF(ABOVE, a->eto + h->eg + BOUND(COSINE));
    vm dark = mor(vlt(of.normal, -of.enormal), vlt(above, -ea)), lit = mand(vlt(of.enormal, of.normal), vlt(ea, above));
    /* an undecided sample may lie in any direction, so its side of the surface is undecided too */
    vm none = mand(mnot(a->unsure), mor(dark, mnot(a->some))), open = mor(a->unsure, mnot(mor(none, lit)));
    unsigned unsure = rough & mbits(open);
    mark_unsure(f, unsure, p->r.slot);
    lanes &= ~unsure;
    rough &= ~unsure & ~mbits(none);
    if (!rough)
        return lanes;
    shadow->p.o = h->outside;
    shadow->p.eo = h->eoutside;
    shadow->p.d = a->to;
    shadow->p.ed = a->eto;
    shadow->p.from = leaving(h, a->to, a->eto, 1, 0);
    shadow->distance = a->distance;
    shadow->edistance = a->edistance;
    for (int k = 0; k < LANES; k++)
        ends[k] = s->paths->emitters[which[k]].light;
    find_hidden(s, &f->room, shadow, rough, ends, &f->blocker);
    (void)cancelled(&f->gather->cancel, shadow->work);
    unsure = rough & mbits(shadow->unsure);
    mark_unsure(f, unsure, p->r.slot);
    lanes &= ~unsure;
    rough &= ~unsure;
    note_shadows(f, rough, ~mbits(shadow->blocked), p);
    rough &= ~mbits(shadow->blocked);
    if (!rough)
        return lanes;
    respond(h, l, &of, &f->response);
    add_sights(f, rough, p, h, a, radiance, surface);
    return lanes;
}

#endif
