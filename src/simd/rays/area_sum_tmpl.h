/* area_sum_tmpl.h - the light of all samples of an area light, of which only the objects of a shaft's lists may block
 * or filter any.
 *
 * Parameters: the doubles of isa/isa.h. Defines: sum_clear(), sum_blocked(), struct area_sum. */
#ifndef TIA_SIMD_RAYS_AREA_SUM_TMPL_H
#define TIA_SIMD_RAYS_AREA_SUM_TMPL_H

#include "power_tmpl.h"
#include "shaft_objects_tmpl.h"

#define AREA_FAINT_BITS 24 /* highlights below 2^-24 are left out: a choice, see AREA_FAINT */

/* Sums over the samples that reach the points: of cosines and of highlights, both times the light that arrives; the
 * number of these samples, and that of roundings of their transmitted light; the errors of highlights. */
struct area_sum {
    vd lambert[3], shine[3], count, filters, eshine;
    vm unsure;
};

/* The cosines that decide, as numbers along the light's axes, with their errors. */
struct area_terms {
    const struct shade *shade;
    struct affine lambert, above, half;
    vd elambert, eabove, eaway, ehalf, faint;
    vm glossy;
};

/* A sample: its place, the inverse of its distance from P, the lanes that it reaches, and how much of it. */
struct area_sample {
    vd x, y, inverse, cosine, through[3], filters;
    vm lit;
};

static void area_terms_of(const struct area *a, const struct shade *h, unsigned lanes, struct area_terms *t)
{
    struct v3 mirror = v3_sub(v3_scale(h->normal, 2 * h->facing), h->viewer);

    t->shade = h;
    t->lambert = affine_of(a->axes, a->way, h->normal);
    t->above = affine_of(a->axes, a->way, h->geometric);
    t->half = affine_of(a->axes, a->way, mirror);
    t->elambert = area_lambert_error(a, h);
    t->eabove = area_above_error(a, h);
    t->eaway = t->eabove;
    t->ehalf = BOUND_OF(HIGHLIGHT_COSINE, BOUND_OF(HIGHLIGHT_FACING, 2 * (h->efacing + t->elambert)) + a->eto + h->ev +
                                              BOUND(HIGHLIGHT_ROUNDING)) +
               BOUND(AREA_COSINE);
    t->glossy = mand(mof(lanes), h->glossy);
    if (any(t->glossy))
        t->faint = exp2_of(vset(-AREA_FAINT_BITS) / vsel(t->glossy, h->exponent, vset(1)));
}

/* Finds the lanes whose surface is certainly turned to the sample, from points `bias` above it as well; others are dark
 * or undecided. */
LANE_OP void find_turned(const struct area_terms *t, double bias, vm lanes, struct area_sample *s, struct area_sum *sum)
{
    vd height = affine_at(&t->above, s->x, s->y), above = height * s->inverse;

    s->cosine = affine_at(&t->lambert, s->x, s->y) * s->inverse;
    vm dark = mor(vlt(s->cosine, -t->elambert), vlt(above, -t->eabove));
    vm lit = mand(vlt(t->elambert, s->cosine), vlt(t->eaway, (height - bias) * s->inverse));
    sum->unsure = mor(sum->unsure, mand(lanes, mnot(mor(dark, lit))));
    s->lit = mand(lanes, lit);
}

/* Meets a sample's rays with a sphere, see set_ball(). */
LANE_OP void pass_ball(const struct ball *ball, vd square, struct area_sample *s, struct area_sum *sum)
{
    vd along = affine_at(&ball->along, s->x, s->y), d = along * along - ball->outside * square,
       e = ball->error * square;
    vm in = mand(s->lit, mof(ball->inside)), near = mand(mand(s->lit, mof(ball->lanes)), vle(-e, d));

    if (!any(mor(near, in)))
        return;
    near = mand(near, mand(vlt(vset(0), along), vlt(along, square)));
    vm met = mor(in, mand(near, vlt(e, d))), open = mand(near, mnot(met));
    sum->unsure = mor(sum->unsure, open);
    s->lit = mand(s->lit, mnot(open));
    if (ball->object->opaque) {
        s->lit = mand(s->lit, mnot(met));
        return;
    }
    s->filters = s->filters + vsel(met, vset(1), vset(0));
    for (int c = 0; c < 3; c++)
        s->through[c] = vsel(met, s->through[c] * vset(ball->object->transmission[c]), s->through[c]);
}

LANE_OP void pass_balls(const struct shaft *f, struct area_sample *s, struct area_sum *sum)
{
    vd square = square_at(&f->area->shadow, s->x, s->y);

    for (const struct ball *ball = f->ball; ball < f->ball + f->balls; ball++)
        if (ball->object->placed)
            pass_ball(ball, square_at(&ball->square, s->x, s->y), s, sum);
        else
            pass_ball(ball, square, s, sum);
}

/* Returns the lanes whose rays certainly pass by what is around an object. */
LANE_OP vm passes_around(const struct other *o, vd square, vd x, vd y)
{
    if (!o->bound)
        return mnone();
    vd along = affine_at(&o->along, x, y);
    vm by = mand(vlt(vset(0), o->outside),
                 mor(vlt(along, vset(0)), vlt(along * along, (o->outside - o->eoutside) * square)));
    if (!o->tube)
        return by;
    vd side = affine_at(&o->side, x, y), rise = affine_at(&o->rise, x, y);
    vd across = vmax(square - rise * rise, vset(0));
    return mor(by, vlt(o->widest * across + o->eside * square, side * side * (1 - BOUND(SHAFT_TUBE))));
}

/* Meets rays with the listed faces of a mesh, or with all of the object. */
static void meet_listed(const struct sure_scene *scene, const struct shaft *f, const struct other *other,
                        struct query *q)
{
    const struct sure_object *o = &scene->object[other->index];
    vm active = q->active;

    if (other->pair < 0) {
        meet_at_once(scene, other->index, q);
        return;
    }
    begin_object(o, other->index, q);
    begin_lines(q, o->mesh);
    for (int i = other->pair; i < other->pair + other->pairs; i++) {
        q->active = mand(mand(active, mof(f->pair[i].lanes)), mnot(q->blocked));
        if (any(q->active))
            meet_some(o->mesh, f->pair[i].pair, 1, q);
    }
    end_object(o, q);
}

/* Begins a query by the rays to a sample. */
static void begin_sample(const struct sure_scene *scene, const struct shaft *f, struct shadow *shadow, vd x, vd y,
                         vm lit)
{
    const struct area *a = f->area;
    struct query *q = &f->room->any;
    struct v3 way = v3_along(v3_along(a->out, a->axes[0], x), a->axes[1], y);
    vd square = v3_dot(way, way), inverse = inverse_root(square);

    shadow->p.d = v3_scale(way, inverse);
    shadow->distance = square * inverse;
    shadow->edistance = a->apart;
    begin_any(q, f->room, shadow, TIA_NO_OBJECT);
    q->maybe = mand(lit, mnot(packet_start(scene->centre, scene->extent, &shadow->p, lit)));
}

/* Meets the rays to a sample with the other objects, as find_shadow() does; false: all of them pass by. */
static __attribute__((noinline)) bool meet_others(const struct sure_scene *scene, const struct shaft *f,
                                                  struct shadow *shadow, vd x, vd y, vm lit)
{
    struct query *q = &f->room->any;
    vd square = square_at(&f->area->shadow, x, y);
    bool begun = false;

    for (const struct other *o = f->other; o < f->other + f->others; o++) {
        vm active = mand(lit, mof(o->lanes));
        if (begun)
            active = mand(active, mnot(q->blocked));
        if (!any(active))
            continue;
        active = mand(active, mnot(passes_around(o, o->placed ? square_at(&o->square, x, y) : square, x, y)));
        if (!any(active))
            continue;
        if (!begun)
            begin_sample(scene, f, shadow, x, y, lit);
        begun = true;
        q->active = active;
        meet_listed(scene, f, o, q);
    }
    if (begun)
        end_any(q, shadow);
    return begun;
}

LANE_OP void pass_others(const struct sure_scene *scene, const struct shaft *f, struct shadow *shadow,
                         struct area_sample *s, struct area_sum *sum)
{
    if (!meet_others(scene, f, shadow, s->x, s->y, s->lit))
        return;
    sum->unsure = mor(sum->unsure, shadow->unsure);
    s->lit = mand(s->lit, mnot(mor(shadow->unsure, shadow->blocked)));
    s->filters = s->filters + shadow->ethrough * (1 / BOUND(THROUGH_UNIT));
    for (int c = 0; c < 3; c++)
        s->through[c] = s->through[c] * shadow->through[c];
}

/* Adds the highlights of the lit lanes; where a highlight is certainly faint, only its error. */
LANE_OP void add_shine(const struct area_terms *t, const struct area_sample *s, struct area_sum *sum)
{
    const struct shade *h = t->shade;
    vd half = affine_at(&t->half, s->x, s->y) * s->inverse;
    vm glossy = mand(s->lit, t->glossy), bright = mand(glossy, vle(t->faint, half + t->ehalf));

    sum->eshine = sum->eshine + vsel(glossy, vset(BOUND(AREA_FAINT)), vset(0));
    if (!any(bright))
        return;
    half = vmin(vmax(half, vset(0)), vset(1));
    vd shine = vsel(bright, power(half, h->exponent), vset(0)), turn = power_turn(half, t->ehalf, h->exponent, shine);
    for (int c = 0; c < 3; c++)
        sum->shine[c] = sum->shine[c] + shine * s->through[c];
    sum->eshine = sum->eshine + vsel(bright, BOUND_OF(HIGHLIGHT, turn) + vset(BOUND(POWER)), vset(0));
}

/* The places of a light's samples: those of one class of pixel in all lanes, or those of each lane's class. */
struct area_places {
    struct picked pick;
    const double *place;
    bool same;
};

LANE_OP void area_places_of(const struct sure_light *l, const uint8_t class[LANES], unsigned lanes,
                            struct area_places *p)
{
    uint8_t first = class[__builtin_ctz(lanes)];

    p->pick.run = false;
    p->same = true;
    p->place = l->place[first][0];
    for (int k = 0; k < LANES; k++) {
        p->pick.class[k] = class[k];
        p->same = p->same && (class[k] == first || !(lanes >> k & 1));
    }
}

LANE_OP void area_place(const struct sure_light *l, struct area_places *p, unsigned i, struct area_sample *s)
{
    p->pick.sample = i;
    if (p->same) {
        s->x = vset(p->place[i]);
        s->y = vset(p->place[i + SURE_PLACES]);
    } else {
        find_places(l, &p->pick, &s->x, &s->y);
    }
}

/* Adds a sample's light. `channels`: 1 if all light arrives alike; then only the first cosine is added. */
LANE_OP void add_to_sum(const struct area_terms *t, const struct area_sample *s, int channels, struct area_sum *sum)
{
    vd cosine = vsel(s->lit, s->cosine, vset(0));

    if (any(t->glossy))
        add_shine(t, s, sum);
    for (int c = 0; c < channels; c++)
        sum->lambert[c] = sum->lambert[c] + cosine * s->through[c];
    sum->count = sum->count + vsel(s->lit, vset(1), vset(0));
    sum->filters = sum->filters + vsel(s->lit, s->filters, vset(0));
}

/* Sums over all samples of the light, each for all points at once. `clear`: nothing is listed. */
LANE_OP void sum_samples(const struct sure_scene *scene, const struct shaft *f, struct shadow *shadow,
                         const uint8_t class[LANES], bool clear, struct area_sum *result)
{
    const struct sure_light *l = f->area->light;
    unsigned lanes = f->lanes & ~f->rest;
    struct area_terms t;
    struct area_places places;
    struct area_sum sum = {.unsure = mnone()};

    area_terms_of(f->area, f->shade, lanes, &t);
    t.eaway =
        vmax(t.eabove, BOUND_OF(AREA_LEAVING, 2 * (f->shade->eg + f->area->eout + BOUND(COSINE) + BOUND(AREA_COSINE))));
    area_places_of(l, class, lanes, &places);
    for (unsigned i = 0; i < l->from->samples; i++) {
        struct area_sample s = {.through = {vset(1), vset(1), vset(1)}, .filters = vset(0)};
        area_place(l, &places, i, &s);
        s.inverse = inverse_root(square_at(&f->area->seen, s.x, s.y));
        find_turned(&t, scene->bias, mof(lanes), &s, &sum);
        check_shadow(mbits(s.lit));
        if (!clear && f->balls)
            pass_balls(f, &s, &sum);
        if (!clear && f->others && any(s.lit))
            pass_others(scene, f, shadow, &s, &sum);
        add_to_sum(&t, &s, clear ? 1 : 3, &sum);
    }
    if (clear)
        sum.lambert[1] = sum.lambert[2] = sum.lambert[0];
    *result = sum;
}

static __attribute__((noinline)) void sum_clear(const struct sure_scene *scene, const struct shaft *f,
                                                const uint8_t class[LANES], struct area_sum *sum)
{
    sum_samples(scene, f, NULL, class, true, sum);
}

static __attribute__((noinline)) void sum_blocked(const struct sure_scene *scene, const struct shaft *f,
                                                  struct shadow *shadow, const uint8_t class[LANES],
                                                  struct area_sum *sum)
{
    const struct shade *h = f->shade;

    shadow->p.o = h->outside;
    shadow->p.eo = h->eoutside;
    shadow->p.ed = f->area->eout;
    shadow->p.from = (struct origin){h->id, h->part, vsel(h->back, vset(1), vset(0))};
    sum_samples(scene, f, shadow, class, false, sum);
}

#endif
