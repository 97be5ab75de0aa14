/* walk_paths.h - samples in packets: ambient occlusion, and light along random paths, bounce by bounce. Each step is
 * that of render/path/path.c; bounds go on from one to the next. */
#ifndef TIA_LEVELS_RAYS_WALK_PATHS_H
#define TIA_LEVELS_RAYS_WALK_PATHS_H

#include "flight.h"
#include "glass.h"

/* Products are rounded by half a unit each, sums are exact; those of 2^17 and more are cut, which is for the integers.
 */
static void add_part(struct flight *f, unsigned lanes, const struct paths *p, const vd rgb[3], vd e)
{
    vd most = most3(rgb), thick = most3(p->r.weight) + p->r.ew;
    double part[3][LANES], error[LANES];

    lanes = sure_of(f, lanes, mnot(vlt((most + e) * thick, vset(65536))), p->r.slot);
    for (int c = 0; c < 3; c++)
        vstore(part[c], p->r.weight[c] * rgb[c]);
    vstore(error, most * p->r.ew + e * thick + 2 * UNIT + most * thick * SURE_2(51));
    for (int k = 0; lanes >> k; k++) {
        if (!(lanes >> k & 1))
            continue;
        for (int c = 0; c < 3; c++)
            f->gather->colour[p->r.slot[k]][c] += part[c][k];
        f->gather->error[p->r.slot[k]] += error[k];
    }
}

/* The balance heuristic's weight q/(q + p/n) of an emitter that paths have come to, which n others could have been. */
LANE_OP struct ve weight_of(const struct sure_paths *paths, const struct paths *p, struct ve chosen, vm *fine)
{
    struct ve q = p->density, sum = {q.v + chosen.v * paths->one_of, q.e + chosen.e * paths->one_of};
    vm specular = mof(p->specular), good = vlt(4 * sum.e, sum.v);
    vd whole = vsel(good, sum.v, vset(1)), v = q.v / whole;
    vd e = 1.5 * (q.e + v * sum.e) / whole + SURE_2(50);

    *fine = mor(specular, mand(*fine, good));
    return ve_of(vsel(specular, vset(1), v), vsel(specular, vset(0), e));
}

LANE_OP void add_weighted(struct flight *f, unsigned lanes, const struct paths *p, const vd rgb[3], struct ve weight,
                          vm fine)
{
    vd most = most3(rgb), part[3];

    lanes = sure_of(f, lanes, mnot(fine), p->r.slot);
    for (int c = 0; c < 3; c++)
        part[c] = rgb[c] * weight.v;
    add_part(f, lanes, p, part, most * (weight.e + SURE_2(52)) + 2 * UNIT);
}

/* Light number n, which these lanes see. */
static void add_seen_light(struct flight *f, unsigned lanes, uint32_t n, const struct paths *p, const struct query *q)
{
    const struct sure_scene *s = f->gather->scene;
    const struct sure_light *l = &s->lights[n];
    const struct sure_shine *shine = &s->paths->lights[n];
    vd rgb[3] = {vset(shine->radiance[0]), vset(shine->radiance[1]), vset(shine->radiance[2])};
    struct ve weight = {vset(1), vset(0)}, chosen;
    vm fine = mnot(mnone());

    if ((lanes & ~p->specular) && l->from->kind != TIA_POINT_LIGHT) {
        vd ed = q->e + 4 * UNIT + vabs(q->t) * SURE_2(49) + p->r.p.eo;
        if (l->from->kind == TIA_SPHERE_LIGHT)
            chosen = ball_density(l->at, l->radius, p->r.p.o, p->r.p.eo, &fine);
        else
            chosen = plane_density(shine, q->t, ed, v3_dot(p->r.p.d, v3_set(l->normal)), p->r.p.ed + SURE_2(49), &fine);
        weight = weight_of(s->paths, p, chosen, &fine);
        if (!shine->known)
            fine = mand(fine, mof(p->specular));
    }
    add_weighted(f, lanes, p, rgb, weight, fine);
}

/* Paths that end at no object. */
static unsigned add_far_ends(struct flight *f, unsigned lanes, const struct paths *p, const struct query *q)
{
    const struct sure_scene *s = f->gather->scene;
    unsigned sky = lanes & mbits(vle(vset(NEVER), q->t)), shining = lanes & ~sky & ~mbits(vlt(q->id, vset(LIGHT_ID)));
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

/* What surfaces send by themselves. Emitting spheres of the scene are looked for as well. */
static void add_glow(struct flight *f, unsigned lanes, const struct paths *p, const struct shade *h,
                     const struct lobes *l)
{
    const struct sure_scene *s = f->gather->scene;
    double glow[LANES];
    unsigned sphere = 0;
    struct ve weight = {vset(1), vset(0)};
    vm fine = mnot(mnone());
    vd rgb[3], flat[3];

    for (int k = 0; k < LANES; k++) {
        glow[k] = l->of[k]->glow;
        sphere |= (unsigned)(lanes >> k & 1 && h->index[k] < s->view->scene->sphere_count) << k;
    }
    for (int c = 0; c < 3; c++)
        rgb[c] = h->emission[c] * vload(glow);
    unsigned glows = lanes & mbits(vlt(vset(0), most3(rgb))), flats = lanes & mbits(vlt(vset(0), most3(h->flat)));
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
    add_part(f, flats, p, flat, most3(h->flat) * h->efacing + 2 * UNIT);
}

LANE_OP void path_quads(const struct flight *f, const struct paths *p, uint32_t which, vu u[4])
{
    uint32_t quad[LANES];

    for (int k = 0; k < LANES; k++)
        quad[k] = PATH_QUAD(p->r.depth[k], which);
    quad_of_paths(f, p->r.slot, quad, u);
}

/* Russian roulette, see path.c: the chance is the largest throughput m, cut to 32 bits, and must be the same all over
 * m +- ew where the path survives. */
static unsigned survivors(struct flight *f, unsigned lanes, struct paths *p, vu given)
{
    double most[LANES], e[LANES], chance[LANES];
    unsigned asked = 0, unsure = 0;
    uint32_t number[LANES];

    for (int k = 0; k < LANES; k++)
        asked |= (unsigned)(p->r.depth[k] >= PATH_ROULETTE) << k & lanes;
    if (!asked)
        return lanes;
    vstore(most, most3(p->r.weight));
    vstore(e, p->r.ew + UNIT);
    vu_store(number, given);
    for (int k = 0; k < LANES; k++) {
        double low = (most[k] - e[k]) * 4294967296.0, high = (most[k] + e[k]) * 4294967296.0;
        chance[k] = 1;
        if (!(asked >> k & 1) || low >= 4294967296.0)
            continue;
        uint64_t least = low < 0 ? 0 : (uint64_t)low, largest = (uint64_t)high;
        if (number[k] >= largest && largest < UINT32_MAX)
            lanes &= ~(1u << k);
        else if (least != largest || largest >= UINT32_MAX)
            unsure |= 1u << k;
        else
            chance[k] = (double)least / 4294967296.0;
    }
    doubt(f, unsure, p->r.slot);
    divide_by(p, vload(chance), mof(asked));
    return lanes & ~unsure;
}

LANE_OP void merge_sights(vm m, const struct sight *one, struct sight *a)
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

/* Each emitter that a lane has chosen is looked at once. *surface: lanes of those that have one. */
static void find_sights(const struct sure_scene *s, unsigned lanes, const uint32_t which[LANES], const struct shade *h,
                        const vu u[2], struct sight *a, vd radiance[3], unsigned *surface)
{
    struct sight one;
    unsigned same;

    *surface = 0;
    for (unsigned left = lanes; left; left &= ~same) {
        uint32_t number = which[__builtin_ctz(left)];
        const struct sure_emitter *e = &s->paths->emitters[number];
        same = 0;
        for (int k = 0; k < LANES; k++)
            same |= (unsigned)(which[k] == number) << k & left;
        see_emitter(s, e, h->outside, h->eoutside, u, left == lanes ? a : &one);
        if (left != lanes)
            merge_sights(mof(same), &one, a);
        for (int c = 0; c < 3; c++)
            radiance[c] =
                left == lanes ? vset(e->shine->radiance[c]) : vsel(mof(same), vset(e->shine->radiance[c]), radiance[c]);
        if (e->light == TIA_NO_OBJECT || s->lights[e->light].from->kind >= TIA_RECTANGLE_LIGHT)
            *surface |= same;
    }
}

/* Reflectance times radiance over the sum of the densities with which this place could have been chosen. */
static void add_sights(struct flight *f, unsigned lanes, const struct paths *p, const struct response *r,
                       const struct sight *a, const vd radiance[3], unsigned surface)
{
    const double one_of = f->gather->scene->paths->one_of;
    vm m = mof(surface);
    struct ve density = {vsel(m, a->density.v * one_of + r->density.v, vset(one_of)),
                         vsel(m, a->density.e * one_of + r->density.e, vset(0))};
    vm fine = mand(vlt(16 * density.e, density.v), mand(vlt(vset(SURE_2(40)), density.v), vlt(density.v, vset(1e15))));
    vd inverse = 1 / vsel(fine, density.v, vset(1)), most = most3(r->rgb), part[3], bright = most3(radiance);
    vd share = most * inverse, eshare = 1.125 * inverse * (r->e + share * density.e) + UNIT + share * SURE_2(50);

    fine = mand(fine, vlt(share + eshare, vset(65536)));
    fine = mand(fine, vlt(bright, vset(65536)));
    for (int c = 0; c < 3; c++)
        part[c] = r->rgb[c] * inverse * (radiance[c] * a->factor);
    vd light = bright * a->factor, elight = bright * a->efactor + UNIT;
    vd e = share * elight + eshare * (light + elight) + 2 * UNIT + share * light * SURE_2(50);
    lanes = sure_of(f, lanes, mnot(fine), p->r.slot);
    add_part(f, lanes, p, part, e);
}

/* What one of the emitters sends to the surface. Returns the lanes that are sure. */
static unsigned look_for_lights(struct flight *f, unsigned lanes, const struct paths *p, const struct shade *h,
                                const struct lobes *l, vu choice, const vu u[2])
{
    const struct sure_scene *s = f->gather->scene;
    uint32_t which[LANES], ends[LANES];
    unsigned rough = 0, surface;
    struct sight a;
    struct response r;
    struct shadow shadow;
    vd radiance[3];

    for (int k = 0; k < LANES; k++)
        rough |= (unsigned)l->of[k]->rough << k & lanes;
    if (!rough || !s->paths->emitter_count)
        return lanes;
    vu_store(which, choice);
    for (int k = 0; k < LANES; k++)
        which[k] = (uint32_t)((uint64_t)which[k] * s->paths->emitter_count >> 32);
    find_sights(s, rough, which, h, u, &a, radiance, &surface);
    vd cosine = v3_dot(a.to, h->normal), above = v3_dot(a.to, h->geometric);
    vd ec = a.eto + h->en + SURE_2(49), ea = a.eto + h->eg + SURE_2(49);
    vm dark = mor(vlt(cosine, -ec), vlt(above, -ea)), lit = mand(vlt(ec, cosine), vlt(ea, above));
    vm open = mor(a.unsure, mand(a.some, mnot(lit))), none = mor(dark, mand(mnot(a.unsure), mnot(a.some)));
    unsigned unsure = rough & mbits(mand(open, mnot(none)));
    doubt(f, unsure, p->r.slot);
    lanes &= ~unsure;
    rough &= ~unsure & ~mbits(none);
    if (!rough)
        return lanes;
    shadow.p.o = h->outside;
    shadow.p.eo = h->eoutside;
    shadow.p.d = a.to;
    shadow.p.ed = a.eto;
    shadow.p.from = leaving(h, a.to, a.eto, 1, 0);
    shadow.distance = a.distance;
    shadow.edistance = a.edistance;
    for (int k = 0; k < LANES; k++)
        ends[k] = s->paths->emitters[which[k]].light;
    find_hidden(s, &shadow, rough, ends, &f->blocker);
    unsure = rough & mbits(shadow.unsure);
    doubt(f, unsure, p->r.slot);
    lanes &= ~unsure;
    rough &= ~unsure & ~mbits(shadow.blocked);
    if (!rough)
        return lanes;
    respond(h, l, a.to, a.eto, cosine, ec, &r);
    add_sights(f, rough, p, &r, &a, radiance, surface);
    return lanes;
}

/* Paths that go on by Lambert's law or Phong's lobe. */
static void scatter_paths(struct flight *f, unsigned lanes, unsigned shiny, const struct paths *p,
                          const struct shade *h, const struct lobes *l, const vu u[2])
{
    struct v3 local = cosine_direction(u[0], u[1]), axis = h->normal;
    vd e = h->en;
    vm exact = h->exact, unsure, glossy = mof(shiny);
    struct response r;
    struct paths next;

    if (shiny) {
        local = v3_sel(glossy, phong_direction(h, u, shiny), local);
        axis = v3_sel(glossy, l->mirrored, axis);
        e = vsel(glossy, l->emirrored, e);
        exact = mand(exact, mnot(glossy));
    }
    next.r.p.d = around(axis, e, exact, local, vset(SURE_LOCAL), &next.r.p.ed, &unsure);
    vd cosine = v3_dot(next.r.p.d, h->normal), above = v3_dot(next.r.p.d, h->geometric);
    vd ec = next.r.p.ed + h->en + SURE_2(49), ea = next.r.p.ed + h->eg + SURE_2(49);
    vm lit = mand(vlt(ec, cosine), vlt(ea, above)), dark = mor(vlt(cosine, -ec), vlt(above, -ea));
    lanes = sure_of(f, lanes, mor(unsure, mnot(mor(lit, dark))), p->r.slot) & mbits(lit);
    if (!lanes)
        return;
    respond(h, l, next.r.p.d, next.r.p.ed, cosine, ec, &r);
    vd inverse = 1 / r.density.v, most = most3(p->r.weight);
    unsigned mixed = 0;
    for (int k = 0; k < LANES; k++)
        mixed |= (unsigned)(l->of[k]->below[2] != 0) << k;
    vm m = mof(mixed),
       fine = mor(mnot(m), mand(vlt(16 * r.density.e, r.density.v), vlt(vset(SURE_2(40)), r.density.v)));
    vd share = most3(r.rgb) * inverse, eshare = 1.125 * inverse * (r.e + share * r.density.e) + UNIT;
    vd factor = vsel(m, share, most3(h->colour)), efactor = vsel(m, eshare + share * SURE_2(50), h->ecolour);
    lanes = sure_of(f, lanes, mnot(mand(fine, vlt(factor, vset(4096)))), p->r.slot);
    for (int c = 0; c < 3; c++)
        next.r.weight[c] = p->r.weight[c] * vsel(m, r.rgb[c] * inverse, h->colour[c]);
    next.r.ew = p->r.ew * (factor + efactor) + most * efactor + UNIT + most * factor * SURE_2(51);
    next.density = r.density;
    next.r.p.from = leaving(h, next.r.p.d, next.r.p.ed, 1, 0);
    next.r.p.o = h->outside;
    next.r.p.eo = h->eoutside;
    next.specular = 0;
    go_on(f, lanes, p, &next, p->r.media);
}

static void reflect_paths(struct flight *f, unsigned lanes, const struct paths *p, const struct shade *h,
                          const struct lobes *l)
{
    struct paths next = *p;

    multiply_by(&next, h->mirror);
    divide_by(&next, l->chance[CHANCE_MIRROR], mof(lanes));
    next.r.p.o = h->outside;
    next.r.p.eo = h->eoutside;
    next.r.p.d = l->mirrored;
    next.r.p.ed = l->emirrored;
    next.r.p.from = leaving(h, next.r.p.d, next.r.p.ed, 1, 0);
    next.specular = lanes;
    go_on(f, lanes, p, &next, p->r.media);
}

/* Each path takes one of its surface's lobes. */
static void bounce_paths(struct flight *f, unsigned lanes, const struct paths *p, const struct shade *h,
                         struct lobes *l, const vu numbers[4], const vu u[2])
{
    unsigned mirror = 0, glass = 0, shiny = 0, rough = 0;
    uint32_t number[LANES];

    vu_store(number, numbers[0]);
    for (int k = 0; k < LANES; k++) {
        const uint32_t *below = l->of[k]->below;
        unsigned bit = 1u << k & lanes;
        if (num_happens(below[0], number[k]))
            mirror |= bit;
        else if (num_happens(below[1], number[k]))
            glass |= bit;
        else if (num_happens(below[2], number[k]))
            shiny |= bit;
        else
            rough |= bit;
    }
    if (shiny | rough)
        scatter_paths(f, shiny | rough, shiny, p, h, l, u);
    if (mirror)
        reflect_paths(f, mirror, p, h, l);
    if (glass)
        enter_glass(f, glass, p, h, l, numbers[3]);
}

/* Lanes whose paths end at their surface; and those whose lobes are not known. */
static unsigned going_on(struct flight *f, unsigned lanes, const struct paths *p, const struct lobes *l)
{
    unsigned black = 0, unknown = 0;

    for (int k = 0; k < LANES; k++) {
        black |= (unsigned)(l->of[k]->black || p->r.depth[k] >= f->gather->scene->paths->bounces) << k;
        unknown |= (unsigned)!l->of[k]->known << k;
    }
    doubt(f, lanes & unknown & ~black, p->r.slot);
    return lanes & ~(black | unknown);
}

/* The numbers of directions are in the quad before, at the first bounce, and that may come after layers. */
static void first_directions(const struct flight *f, unsigned lanes, const struct paths *p, vu places[4])
{
    uint32_t quad[LANES], now[2][LANES], first[2][LANES];
    unsigned these = 0;
    vu u[4];

    for (int k = 0; k < LANES; k++) {
        these |= (unsigned)(p->r.depth[k] == 0) << k & lanes;
        quad[k] = ESTIMATE_FIRST_QUAD;
    }
    if (!these)
        return;
    quad_of_paths(f, p->r.slot, quad, u);
    for (int i = 0; i < 2; i++) {
        vu_store(now[i], places[2 + i]);
        vu_store(first[i], u[2 + i]);
        for (int k = 0; k < LANES; k++)
            now[i][k] = these >> k & 1 ? first[i][k] : now[i][k];
        places[2 + i] = vu_load(now[i]);
    }
}

static void step_paths(struct flight *f, struct paths *p, unsigned lanes)
{
    const struct sure_scene *s = f->gather->scene;
    struct query q;
    struct shade h;
    struct lobes l;
    vu numbers[4], places[4];

    find_first(s, &q, &p->r.p, lanes, true, p->specular);
    vm sky = mand(vle(vset(NEVER), q.t), vle(vset(NEVER), q.low));
    lanes = sure_of(f, lanes, mnot(mor(sky, vlt(q.t + q.e, q.low))), p->r.slot);
    lanes = add_far_ends(f, lanes, p, &q);
    if (!lanes)
        return;
    find_surfaces(s, &p->r.p, &q, lanes, &h);
    lanes = sure_of(f, lanes, h.unsure, p->r.slot);
    if (!lanes)
        return;
    lobes_of(s->paths, &h, lanes, &l);
    add_glow(f, lanes, p, &h, &l);
    lanes = going_on(f, lanes, p, &l);
    if (!lanes)
        return;
    path_quads(f, p, 1, numbers);
    path_quads(f, p, 0, places);
    first_directions(f, lanes, p, places);
    lanes = survivors(f, lanes, p, numbers[2]);
    if (!lanes)
        return;
    lobes_mirror(&h, &l);
    lanes = look_for_lights(f, lanes, p, &h, &l, numbers[1], places);
    bounce_paths(f, lanes, p, &h, &l, numbers, places + 2);
}

static void walk_paths(struct sure_gather *g)
{
    const struct tia_view *view = g->scene->view->view;
    struct flight f;
    struct paths p;
    vu first[4];
    int from = 0;

    flight_open(&f, g);
    while (!view_stops(view)) {
        if (from < g->count && f.count[fullest(&f)] < LANES) {
            unsigned lanes = flight_start(&f, from, &p, first);
            step_paths(&f, &p, lanes);
            from += LANES;
            continue;
        }
        unsigned lanes = flight_pop(&f, &p);
        if (!lanes)
            return;
        step_paths(&f, &p, lanes);
    }
}

/* Ambient occlusion: decisions alone. */
static void occlude_packet(struct flight *f, struct paths *p, unsigned lanes, const vu u[4])
{
    const struct sure_scene *s = f->gather->scene;
    struct shadow shadow;
    struct query q;
    struct shade h;
    vm unsure;

    for (int k = 0; lanes >> k; k++)
        for (int c = 0; c < 3; c++)
            f->gather->colour[p->r.slot[k]][c] = 1;
    find_first(s, &q, &p->r.p, lanes, false, 0);
    vm sky = mand(vle(vset(NEVER), q.t), vle(vset(NEVER), q.low));
    lanes = sure_of(f, lanes, mnot(mor(sky, vlt(q.t + q.e, q.low))), p->r.slot) & ~mbits(sky);
    if (!lanes)
        return;
    find_surfaces(s, &p->r.p, &q, lanes, &h);
    lanes = sure_of(f, lanes, h.unsure, p->r.slot);
    shadow.p.o = h.outside;
    shadow.p.eo = h.eoutside;
    shadow.p.d = around(h.normal, h.en, h.exact, cosine_direction(u[2], u[3]), vset(SURE_LOCAL), &shadow.p.ed, &unsure);
    shadow.p.from = leaving(&h, shadow.p.d, shadow.p.ed, 1, 0);
    shadow.distance = vset(s->paths->reach);
    shadow.edistance = vset(0);
    vd above = v3_dot(shadow.p.d, h.geometric), e = shadow.p.ed + h.eg + SURE_2(49);
    lanes = sure_of(f, lanes, mor(unsure, vle(vabs(above), e)), p->r.slot);
    unsigned below = lanes & mbits(vlt(above, vset(0))), open = lanes & ~below;
    shadow.blocked = shadow.unsure = mnone();
    if (open)
        find_hidden(s, &shadow, open, NULL, &f->blocker);
    doubt(f, open & mbits(shadow.unsure), p->r.slot);
    below |= open & mbits(shadow.blocked);
    for (int k = 0; below >> k; k++)
        for (int c = 0; c < 3 && (below >> k & 1); c++)
            f->gather->colour[p->r.slot[k]][c] = 0;
}

static void occlude(struct sure_gather *g)
{
    const struct tia_view *view = g->scene->view->view;
    struct flight f;
    struct paths p;
    vu u[4];

    flight_open(&f, g);
    for (int from = 0; from < g->count && !view_stops(view); from += LANES) {
        unsigned lanes = flight_start(&f, from, &p, u);
        occlude_packet(&f, &p, lanes, u);
    }
}

#endif
