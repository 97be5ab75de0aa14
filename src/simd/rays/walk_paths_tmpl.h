/* walk_paths_tmpl.h - path tracing in packets, bounce by bounce.
 *
 * Parameters: the doubles of isa/isa.h. Defines: walk_paths(), for the table of lanes.h.
 *
 * Each step is that of render/path/path.c, and passes its bounds to the next step. */
#ifndef TIA_SIMD_RAYS_WALK_PATHS_TMPL_H
#define TIA_SIMD_RAYS_WALK_PATHS_TMPL_H

#include "glass_tmpl.h"
#include "look_tmpl.h"
#include "occlude_tmpl.h"

/* Returns the lanes that survive Russian roulette, see path.c. The chance is the largest component m of the throughput,
 * cut to 32 bits; from 2^32 - 1 on it is 1. If m +- ew allows several chances, only a random number among them leaves
 * the lane undecided. The throughputs of survivors are divided by the chance. */
static unsigned survivors(struct path_state *f, unsigned lanes, struct paths *p)
{
    const vd all = vset(4294967296.0), largest = vset(UINT32_MAX);
    vd most = most3(p->r.weight), e = BOUND_OF(SURVIVAL, p->r.ew + BOUND(SURVIVAL_UNIT)),
       low = vfloor(vmax((most - e) * all, vset(0))), high = vfloor((most + e) * all);
    unsigned asked = 0;

    for (int k = 0; k < LANES; k++)
        asked |= (unsigned)(p->r.depth[k] >= PATH_ROULETTE) << k & lanes;
    vm open = mand(mof(asked), vlt(low, largest));
    if (!any(open))
        return lanes;
    high = vsel(vlt(high, largest), high, all);
    vd number = vu_number(path_choice(f, p, CHOICE_SURVIVAL));
    vm ends = mand(open, vle(high, number)), stays = mand(open, vlt(number, low));
    lanes = sure_of(f, lanes & ~mbits(ends), mand(open, mnot(mor(ends, stays))), p->r.slot);
    vm small =
        divide_by(p, ve_of((high + low) * (SURE_Q32 / 2), (high - low) * (SURE_Q32 / 2)), mand(stays, mof(lanes)));
    return sure_of(f, lanes, small, p->r.slot);
}

/* Gives the random numbers of the next directions. At the first bounce, even after layers, they are those of the first
 * quad. */
LANE_OP void direction_numbers(const struct path_state *f, const struct paths *p, vu u[2])
{
    uint32_t quad[LANES];

    for (int k = 0; k < LANES; k++)
        quad[k] = p->r.depth[k] ? PATH_QUAD(p->r.depth[k], 0) : ESTIMATE_FIRST_QUAD;
    struct quads quads = f->next_known ? f->next : quads_of_paths(f, p->r.slot, quad);
    u[0] = quads_number(&quads, 2);
    u[1] = quads_number(&quads, 3);
}

/* Continues paths by Lambert's law or, in `shiny` lanes, by Phong's lobe. The cosine to the lobe's axis is the local
 * direction's z: the axis's error does not count. */
static __attribute__((noinline)) void scatter_paths(struct path_state *f, unsigned lanes, unsigned shiny,
                                                    const struct paths *p, const struct shade *h, const struct lobes *l)
{
    vu u[2];

    direction_numbers(f, p, u);
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
    next.r.p.d = around(axis, e, exact, local, vset(BOUND(LOCAL)), &next.r.p.ed, &unsure);
    struct cosines of = cosines_of(h, l, next.r.p.d, next.r.p.ed);
    of.normal = vsel(glossy, of.normal, local.z);
    of.enormal = vsel(glossy, of.enormal, vset(BOUND(LOCAL_COSINE)));
    of.mirrored = vsel(glossy, local.z, of.mirrored);
    of.emirrored = vsel(glossy, vset(BOUND(LOCAL_COSINE)), of.emirrored);
    vd above = v3_dot(next.r.p.d, h->geometric), ea = BOUND_OF(ABOVE, next.r.p.ed + h->eg + BOUND(COSINE));
    vm lit = mand(vlt(of.enormal, of.normal), vlt(ea, above)), dark = mor(vlt(of.normal, -of.enormal), vlt(above, -ea));
    lanes = sure_of(f, lanes, mor(unsure, mnot(mor(lit, dark))), p->r.slot) & mbits(lit);
    if (!lanes)
        return;
    respond(h, l, &of, &r);
    vd inverse = 1 / r.density.v, most = most3(p->r.weight);
    unsigned mixed = 0;
    for (int k = 0; k < LANES; k++)
        mixed |= (unsigned)(l->of[k]->below[2] != 0) << k;
    vm m = mof(mixed), fine = mor(mnot(m), mand(vlt(BOUND(SHARE_KNOWN) * r.density.e, r.density.v),
                                                vlt(vset(BOUND(SHARE_LEAST)), r.density.v)));
    vd share = most3(r.rgb) * inverse, eshare = reflectance_error(h, &r, ve_of(vset(0), vset(0)), inverse, share);
    vd factor = vsel(m, share, most3(h->colour)), efactor = vsel(m, eshare, h->ecolour);
    lanes = sure_of(f, lanes, mnot(mand(fine, vlt(factor, vset(4096)))), p->r.slot);
    for (int c = 0; c < 3; c++)
        next.r.weight[c] = p->r.weight[c] * vsel(m, r.rgb[c] * inverse, h->colour[c]);
    next.r.ew = BOUND_OF(SCATTERED_WEIGHT, p->r.ew * (factor + efactor) + most * efactor) + BOUND(THROUGHPUT_UNIT) +
                most * factor * BOUND(THROUGHPUT_ROUNDING);
    next.density = r.density;
    next.r.p.from = leaving(h, next.r.p.d, next.r.p.ed, 1, 0);
    next.r.p.o = h->outside;
    next.r.p.eo = h->eoutside;
    next.specular = 0;
    go_on(f, lanes, p, &next, NULL);
}

static __attribute__((noinline)) void reflect_paths(struct path_state *f, unsigned lanes, const struct paths *p,
                                                    const struct shade *h, const struct lobes *l)
{
    struct paths next = *p;

    multiply_by(&next, h->mirror);
    lanes = sure_of(f, lanes, divide_by(&next, ve_of(l->chance[CHANCE_MIRROR], l->spread), mof(lanes)), p->r.slot);
    next.r.p.o = h->outside;
    next.r.p.eo = h->eoutside;
    next.r.p.d = l->mirrored;
    next.r.p.ed = l->emirrored;
    next.r.p.from = leaving(h, next.r.p.d, next.r.p.ed, 1, 0);
    next.specular = lanes;
    go_on(f, lanes, p, &next, NULL);
}

/* Chooses one lobe of the surface for each path, and continues the path by it. */
static void bounce_paths(struct path_state *f, unsigned lanes, const struct paths *p, const struct shade *h,
                         struct lobes *l)
{
    unsigned mirror = 0, glass = 0, shiny = 0, rough = 0, open = 0;
    bool several = false;
    uint32_t number[LANES];

    for (int k = 0; k < LANES; k++)
        several |= l->of[k]->below[2] != 0;
    if (!several) {
        scatter_paths(f, lanes, 0, p, h, l);
        return;
    }
    vu_store(number, path_choice(f, p, CHOICE_LOBE));
    for (int k = 0; k < LANES; k++) {
        const uint32_t *below = l->of[k]->below;
        unsigned bit = 1u << k & lanes;
        open |= lobe_is_open(l->of[k], number[k]) ? bit : 0;
        if (num_happens(below[0], number[k]))
            mirror |= bit;
        else if (num_happens(below[1], number[k]))
            glass |= bit;
        else if (num_happens(below[2], number[k]))
            shiny |= bit;
        else
            rough |= bit;
    }
    mark_unsure(f, open, p->r.slot);
    if ((shiny | rough) & ~open)
        scatter_paths(f, (shiny | rough) & ~open, shiny & ~open, p, h, l);
    if (mirror & ~open)
        reflect_paths(f, mirror & ~open, p, h, l);
    if (glass & ~open)
        enter_glass(f, glass & ~open, p, h, l, path_choice(f, p, CHOICE_REFLECTION));
}

/* Returns the lanes whose paths continue; samples whose lobes are undecided become undecided. */
static unsigned going_on(struct path_state *f, unsigned lanes, const struct paths *p, const struct lobes *l)
{
    unsigned black = 0, unknown = 0;

    for (int k = 0; k < LANES; k++) {
        black |= (unsigned)(l->of[k]->black || p->r.depth[k] >= f->gather->scene->paths->bounces) << k;
        unknown |= (unsigned)!l->of[k]->known << k;
    }
    mark_unsure(f, lanes & unknown & ~black, p->r.slot);
    return lanes & ~(black | unknown);
}

static void step_paths(struct path_state *f, struct paths *p, unsigned lanes)
{
    const struct sure_scene *s = f->gather->scene;
    struct query *q = &f->query;
    struct shade *h = &f->shade;
    struct lobes *l = &f->lobes;

    find_first(s, &f->room, q, &p->r.p, lanes, true, p->specular);
    (void)cancelled(&f->gather->cancel, q->work);
    vm sky = mand(vle(vset(INFINITE), q->t), vle(vset(INFINITE), q->low));
    lanes = sure_of(f, lanes, mnot(mor(sky, vlt(q->t + q->e, q->low))), p->r.slot);
    note_hits(f, lanes, p, q);
    lanes = add_far_ends(f, lanes, p, q);
    if (!lanes)
        return;
    find_surfaces(s, &p->r.p, q, lanes, h);
    lanes = sure_of(f, lanes, h->unsure, p->r.slot);
    if (!lanes)
        return;
    lobes_of(s->paths, h, lanes, l);
    add_glow(f, lanes, p, h, l);
    lanes = going_on(f, lanes, p, l);
    if (!lanes)
        return;
    lanes = survivors(f, lanes, p);
    if (!lanes)
        return;
    lobes_mirror(h, l);
    lanes = look_for_lights(f, lanes, p, h, l);
    bounce_paths(f, lanes, p, h, l);
}

static void walk_paths(struct sure_gather *g, void *memory)
{
    struct path_state *f = memory;
    struct paths *p = &f->paths;
    int from = 0;

    path_open(f, g);
    while (!g->cancel.stopped) {
        if (from < g->count && f->count[fullest(f)] < LANES) {
            unsigned lanes = path_start(f, from, p, &f->next);
            f->next_known = true;
            step_paths(f, p, lanes);
            from += LANES;
            continue;
        }
        unsigned lanes = path_pop(f, p);
        f->next_known = false;
        if (!lanes)
            return;
        step_paths(f, p, lanes);
    }
}

#endif
