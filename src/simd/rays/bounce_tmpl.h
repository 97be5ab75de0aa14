/* bounce_tmpl.h - rays spawned at a surface: reflection, refraction and straight passage.
 *
 * Parameters: the doubles of isa/isa.h. Defines: bounce(), find_boundaries(), refract(), struct refraction. */
#ifndef TIA_SIMD_RAYS_BOUNCE_TMPL_H
#define TIA_SIMD_RAYS_BOUNCE_TMPL_H

#include "paths_tmpl.h"

/* Refraction at a boundary: the direction and the reflectance, with their errors. */
struct refraction {
    struct v3 to;
    vd eto, fresnel, efresnel;
    vm straight, total, bends, unsure;
    struct media media[LANES];
};

/* Finds the boundaries with the fixed-point code: this is exact, since the media of a certain ray are certain. Sets
 * *per_part to 1/parts and *q to n2/(parts n1), see shading_refract(). */
static void find_boundaries(const struct sure_scene *s, const struct shade *h, unsigned glass, const struct rays *r,
                            struct refraction *f, vd *q, vd *per_part)
{
    double ratio[LANES], part[LANES];
    unsigned straight = 0, back = mbits(h->back);

    for (int k = 0; k < LANES; k++) {
        ratio[k] = part[k] = 0.25;
        copy_media(&f->media[k], &r->media[k]);
        if (!(glass >> k & 1))
            continue;
        const struct tia_material *m = &s->view->scene->materials[h->material[k]];
        struct boundary b = media_cross(s->view, &f->media[k], h->index[k], m, back >> k & 1);
        part[k] = b.to <= 4 * b.from ? 0.25 : 0.0625;
        ratio[k] = (double)b.to / (double)b.from * part[k];
        straight |= (unsigned)(b.to == b.from) << k;
    }
    f->straight = mof(straight);
    *q = vload(ratio);
    *per_part = vload(part);
}

/* Returns (a - b)/(a + b), a reflectance of Fresnel's equations. Where |a' - a| + |b' - b| <= e, it differs from (a' -
 * b')/(a' + b') by
 *
 *     2 |b (a' - a) - a (b' - b)|/((a + b) (a' + b')) <= 2 e/(a' + b').
 *
 * As e < (a + b)/16, a' + b' >= 15/16 (a + b). */
LANE_OP vd reflectance_of(vd a, vd b, vd e, vm *fine, vd *er)
{
    vd sum = a + b;
    vm good = vlt(vset(BOUND(FRESNEL_LEAST)) + BOUND(FRESNEL_KNOWN) * e, sum);

    sum = vsel(good, sum, vset(1));
    *fine = mand(*fine, good);
    *er = BOUND_OF(FRESNEL, BOUND(FRESNEL_QUOTIENT) * e / sum) + BOUND(FRESNEL_ROUNDING);
    return (a - b) / sum;
}

/* Refracts by Snell's law and Fresnel's equations, like shading_refract(). The cosine c has the error ec, so c^2 under
 * the root has the error (2 |c| + ec) ec. */
static void refract(const struct shade *h, vm glass, vd q, vd part, struct refraction *f)
{
    vd c = h->facing, ec = h->efacing, square = q * q, inside = square - (1 - c * c) * (part * part), er, es, ep;
    vd ei = BOUND_OF(REFRACT_INSIDE, (2 * vabs(c) + ec) * ec * (part * part)) + BOUND(REFRACT_ROUNDING), x = c * part;
    vd ex = BOUND_OF(REFRACT_COSINE, ec * part);
    vm fine = mnot(mnone());

    f->total = mand(mnot(f->straight), mor(vlt(inside, -ei), vlt(c, -ec)));
    f->bends = mand(mnot(f->straight), mand(vlt(ei, inside), vlt(ec, c)));
    vd root = vsqrt(vsel(f->bends, inside, vset(1)));
    er = BOUND_OF(REFRACT_ROOT, root_error(ei, root)) + BOUND(REFRACT_ROUNDING);
    vd bend = x - root, rs = reflectance_of(x, root, BOUND_OF(REFRACT_ACROSS, ex + er), &fine, &es);
    vd rp = reflectance_of(square * c, root * part, BOUND_OF(REFRACT_PARALLEL, square * ec + er * part), &fine, &ep);
    vd fresnel = 0.5 * (rs * rs + rp * rp),
       efresnel = BOUND_OF(REFRACT_FRESNEL, (vabs(rs) + es) * es + (vabs(rp) + ep) * ep) + BOUND(REFRACT_ROUNDING);
    f->to = v3_unit(v3_sub(v3_scale(h->normal, bend), v3_scale(h->viewer, part)),
                    BOUND_OF(REFRACT_DIRECTION, h->en * vabs(bend) + ex + er + h->ev * part) +
                        BOUND(REFRACT_DIRECTION_ROUNDING),
                    &f->eto);
    vm known = mor(f->straight, mor(f->total, mand(f->bends, mand(fine, vlt(fresnel + efresnel, vset(1))))));
    f->unsure = mand(glass, mnot(known));
    vm partly = mand(f->bends, h->fresnel);
    f->fresnel = vsel(f->total, vset(1), vsel(partly, fresnel, vset(0)));
    f->efresnel = vsel(partly, efresnel, vset(0));
}

LANE_OP void keep_paths(struct rays *next, const struct rays *r, const struct media media[LANES])
{
    for (int k = 0; k < LANES; k++) {
        next->slot[k] = r->slot[k];
        next->depth[k] = r->depth[k];
        next->layers[k] = r->layers[k];
        copy_media(&next->media[k], &media[k]);
        copy_route(&next->route[k], &r->route[k]);
    }
    next->run = false;
}

/* Returns the lanes whose paths may bounce once more. */
LANE_OP unsigned may_bounce(const struct sure_scene *s, const struct rays *r)
{
    unsigned on = 0;

    for (int k = 0; k < LANES; k++)
        on |= (unsigned)(r->depth[k] < s->depth) << k;
    return on;
}

/* Returns the lanes whose paths may pass straight through one more layer. */
LANE_OP unsigned may_pass(const struct rays *r)
{
    unsigned on = 0;

    for (int k = 0; k < LANES; k++)
        on |= (unsigned)(r->layers[k] < TIA_LAYERS_MAX) << k;
    return on;
}

/* Classifies rays that start `height` off a surface: certainly leaving it, certainly returning to it, or undecided. */
LANE_OP struct origin leaving_or_not(const struct shade *h, struct v3 d, vd ed, double sign, double height)
{
    struct origin from = leaving(h, d, ed, sign, 0);
    vm back = vlt(v3_dot(h->geometric, d) * sign, -BOUND_OF(RETURNING, h->eg + ed + vset(BOUND(COSINE))));

    from.object = vsel(back, h->id, from.object);
    from.side = vsel(back, vset(-height), from.side);
    return from;
}

/* Queues refracted rays. A bent ray starts behind the surface, at the distance `bias` along the normal; a straight one
 * starts behind the point, at this distance along the ray. */
static void push_refracted(struct work *w, const struct shade *h, unsigned lanes, const struct rays *r,
                           const struct refraction *f)
{
    const struct sure_scene *s = w->block->scene;
    unsigned straight = mbits(f->straight) & lanes & may_pass(r), bends = mbits(f->bends) & lanes & may_bounce(s, r);
    struct rays next;

    if (!(straight | bends))
        return;
    keep_paths(&next, r, f->media);
    for (int c = 0; c < 3; c++)
        next.weight[c] = r->weight[c] * (h->refraction[c] - h->refraction[c] * f->fresnel);
    next.ew = BOUND_OF(REFRACTED_WEIGHT, r->ew) + BOUND_OF(REFRACTED_FRESNEL, f->efresnel * most3(r->weight)) +
              BOUND(WEIGHT_UNITS) + most3(r->weight) * BOUND(WEIGHT_ROUNDING);
    if (bends) {
        next.p.o = off_surface(s, h, -s->bias, &next.p.eo);
        next.p.d = f->to;
        next.p.ed = f->eto;
        next.p.from = leaving_or_not(h, next.p.d, next.p.ed, -1, s->bias);
        push(w, bends, &next, true, false);
    }
    if (straight) {
        next.p.o = v3_along(h->point, h->viewer, vset(-s->bias));
        next.p.eo = BOUND_OF(STRAIGHT_ON, h->ep + h->ev * vset(s->bias)) + BOUND(POINT_UNITS) +
                    v3_sum(next.p.o) * BOUND(POINT_ROUNDING);
        next.p.d = r->p.d;
        next.p.ed = r->p.ed;
        next.p.from =
            leaving(h, next.p.d, next.p.ed, -1,
                    s->bias < BOUND(LEAVING_BIAS) ? BOUND(LEAVING_STEEP) : BOUND(LEAVING_FLAT)); /* see struct origin */
        push(w, straight, &next, true, true);
    }
}

static void push_reflected(struct work *w, const struct shade *h, unsigned lanes, const struct rays *r,
                           const vd reflects[3], vd ereflects)
{
    const struct sure_scene *s = w->block->scene;
    struct rays next;

    lanes &= may_bounce(s, r) & mbits(vlt(vset(0), most3(reflects)));
    if (!lanes)
        return;
    keep_paths(&next, r, r->media);
    for (int c = 0; c < 3; c++)
        next.weight[c] = r->weight[c] * reflects[c];
    next.ew = BOUND_OF(REFLECTED_WEIGHT, r->ew * (most3(reflects) + ereflects)) +
              BOUND_OF(REFLECTED_FRESNEL, ereflects * most3(r->weight)) + BOUND(WEIGHT_UNITS) +
              most3(next.weight) * BOUND(WEIGHT_ROUNDING);
    next.p.o = h->outside;
    next.p.eo = h->eoutside;
    next.p.d = mirrored_at(h, &next.p.ed);
    next.p.from = leaving_or_not(h, next.p.d, next.p.ed, 1, s->bias);
    push(w, lanes, &next, false, false);
}

/* Queues the rays that a packet spawns. Not inlined, so that its large stack frame does not add to those of hierarchy
 * walks and shadow rays. */
static __attribute__((noinline)) void bounce(struct work *w, const struct shade *h, unsigned lanes,
                                             const struct rays *r)
{
    unsigned glass = mbits(h->refracts) & lanes;
    vd reflects[3] = {h->mirror[0], h->mirror[1], h->mirror[2]}, e = vset(0), q, part;
    struct refraction f;

    if (glass) {
        find_boundaries(w->block->scene, h, glass, r, &f, &q, &part);
        refract(h, mof(glass), q, part, &f);
        unsigned unsure = mbits(f.unsure) & glass;
        give_up(w, unsure, r, most3(h->mirror) + most3(h->refraction));
        lanes &= ~unsure;
        push_refracted(w, h, lanes & glass, r, &f);
        for (int c = 0; c < 3; c++)
            reflects[c] = reflects[c] + vsel(mof(glass), h->refraction[c] * f.fresnel, vset(0));
        e = vsel(mof(glass), f.efresnel, vset(0));
    }
    if (lanes)
        push_reflected(w, h, lanes, r, reflects, e);
}

#endif
