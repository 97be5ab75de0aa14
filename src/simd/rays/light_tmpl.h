/* light_tmpl.h - direct lighting: Lambert, Phong highlight, shadow rays.
 *
 * Parameters: the doubles of isa/isa.h. Defines: add_light(), struct lit, struct light_room, struct known_lights. */
#ifndef TIA_SIMD_RAYS_LIGHT_TMPL_H
#define TIA_SIMD_RAYS_LIGHT_TMPL_H

#include "area_sum_tmpl.h"
#include "spread_tmpl.h"

#define AREA_FEW (LANES / 4) /* most lanes that are left to other packets because few need rays to be traced */

/* Aims the shadow ray, from outside the surface to the sample. Its vector is that of the sample, less b G, so its error
 * is that of the sample's vector, b eg, and roundings. */
static void aim_shadow(const struct sure_scene *scene, const struct sure_light *l, const struct shade *h,
                       const struct sample *s, struct shadow *shadow)
{
    shadow->p.o = h->outside;
    shadow->p.eo = h->eoutside;
    shadow->p.d = s->to;
    shadow->p.ed = s->eto;
    shadow->distance = vset(131072);
    shadow->edistance = vset(0);
    if (tia_light_has(l->from->kind, TIA_LIGHT_FAR)) {
        shadow->p.from = leaving(h, s->to, s->eto, 1, 0);
        return;
    }
    struct v3 way = v3_sub(s->way, v3_sub(h->outside, h->point));
    vd e = BOUND_OF(SHADOW_WAY, s->ew + BOUND_OF(SHADOW_NORMAL, h->eg * vset(scene->bias)) + BOUND(POINT_UNITS) +
                                    (v3_sum(way) + 2 * v3_sum(h->outside)) * BOUND(POINT_ROUNDING));
    shadow->p.d = v3_unit(way, e, &shadow->p.ed);
    shadow->distance = v3_dot(way, shadow->p.d);
    shadow->edistance = BOUND_OF(DISTANCE, e + shadow->distance * BOUND(DISTANCE_ROUNDING) + BOUND(LENGTH_UNIT));
    shadow->p.from = leaving(h, shadow->p.d, shadow->p.ed, 1, 0);
}

/* Computes the reflected light and its error. Lanes whose highlight's cosine is certainly not above 0 have none. */
static void reflect_light(const struct shade *h, const struct sample *s, vd lambert, vd elambert, vm lit, vd rgb[3],
                          vd *e)
{
    vm glossy = mand(lit, h->glossy);

    *e = BOUND_OF(DIFFUSE, most3(h->colour) * elambert + BOUND_OF(DIFFUSE_TEXTURE, h->ecolour));
    for (int c = 0; c < 3; c++)
        rgb[c] = h->colour[c] * lambert;
    if (!any(glossy))
        return;
    vd half = 2 * (h->facing * lambert) - v3_dot(h->viewer, s->to);
    vd ehalf = BOUND_OF(HIGHLIGHT_COSINE, BOUND_OF(HIGHLIGHT_FACING, 2 * (h->efacing + elambert)) + s->eto + h->ev +
                                              BOUND(HIGHLIGHT_ROUNDING));
    glossy = mand(glossy, vlt(-ehalf, half));
    if (!any(glossy))
        return;
    half = vmin(vmax(half, vset(0)), vset(1));
    vd shine = vsel(glossy, power(half, h->exponent), vset(0)), turn = power_turn(half, ehalf, h->exponent, shine);
    for (int c = 0; c < 3; c++)
        rgb[c] = rgb[c] + h->specular[c] * shine;
    *e = *e + vsel(glossy, most3(h->specular) * (BOUND_OF(HIGHLIGHT, turn) + vset(BOUND(POWER))), vset(0));
}

struct light_room;

/* The lights that reach the points, where these are known: see struct sure_seen. */
struct known_lights {
    const struct sure_seen *seen;
    uint32_t slot[LANES];
};

/* Sums of the light that the points reflect, and their errors; `cancel` counts the work. `known`: NULL, or replaces
 * shadow rays. */
struct lit {
    struct cancel *cancel;
    struct light_room *room;
    const struct known_lights *known;
    vd own[3], eown;
    vm unsure;
};

/* A call's memory for lighting, including that of shadow rays' walks; `there`, `point` and `one` belong to a single
 * point. */
struct light_room {
    struct room room;
    struct aim aim, there;
    struct area area;
    struct shaft shaft;
    struct area_sum area_sum;
    struct sample sample;
    struct shadow shadow;
    struct shade point;
    struct lit one;
};

/* The cosine of the light to the normal, and its error. */
struct lambert {
    vd cosine, e;
};

/* Finds the lanes whose surface is certainly turned to a sample that gives light. Others are dark or undecided. */
LANE_OP vm find_lambert(const struct shade *h, const struct sample *s, vm lanes, struct lambert *lambert,
                        struct lit *sum)
{
    vd cosine = v3_dot(h->normal, s->to), above = v3_dot(h->geometric, s->to);
    vd el = BOUND_OF(LAMBERT, h->en + s->eto + BOUND(COSINE)), ea = BOUND_OF(ABOVE, h->eg + s->eto + BOUND(COSINE));
    vm dark = mor(vlt(cosine, -el), vlt(above, -ea)), lit = mand(vlt(el, cosine), vlt(ea, above));

    *lambert = (struct lambert){cosine, el};
    dark = mor(dark, vlt(s->falloff.factor + s->falloff.e, vset(BOUND(SAMPLE_DARK))));
    sum->unsure = mor(sum->unsure, mand(lanes, mor(mnot(mor(dark, lit)), mand(lit, s->falloff.unsure))));
    lit = mand(lit, mnot(dark));
    return mand(mand(lit, lanes), mnot(sum->unsure));
}

/* Adds the reflected light of the lit lanes, `through` of which arrives. */
LANE_OP void add_reflected(const struct sure_light *l, const struct shade *h, const struct sample *s,
                           const struct lambert *lambert, vm lit, const vd through[3], vd ethrough, struct lit *sum)
{
    double part = 1.0 / l->from->samples;
    vd factor = s->falloff.factor, rgb[3], e;

    reflect_light(h, s, lambert->cosine, lambert->e, lit, rgb, &e);
    e = BOUND_OF(SAMPLE_LIGHT, (e + 2 * ethrough) * factor) + BOUND_OF(SAMPLE_FALLOFF, 2 * s->falloff.e) +
        BOUND_OF(SAMPLE_FALLOFF_MORE, 2 * s->falloff.e * e);
    for (int c = 0; c < 3; c++)
        sum->own[c] = sum->own[c] + vsel(lit, rgb[c] * through[c] * factor * (l->emission[c] * part), vset(0));
    sum->eown = sum->eown + vsel(lit, (e + BOUND(SAMPLE_SUM)) * (l->brightest * part) + BOUND(SAMPLE_SUM), vset(0));
}

static __attribute__((noinline)) void add_sample(const struct sure_scene *scene, const struct sure_light *l,
                                                 const struct shade *h, const struct sample *s, vm lanes,
                                                 uint32_t *blocker, struct lit *sum)
{
    struct shadow *shadow = &sum->room->shadow;
    struct lambert lambert;
    vm lit = find_lambert(h, s, lanes, &lambert, sum);

    if (!any(lit))
        return;
    aim_shadow(scene, l, h, s, shadow);
    find_shadow(scene, &sum->room->room, shadow, lit, blocker);
    (void)cancelled(sum->cancel, shadow->work);
    sum->unsure = mor(sum->unsure, shadow->unsure);
    lit = mand(lit, mnot(mor(shadow->blocked, shadow->unsure)));
    if (any(lit))
        add_reflected(l, h, s, &lambert, lit, shadow->through, shadow->ethrough, sum);
}

/* Returns the lanes that light of a sample reaches. */
LANE_OP vm reached_lanes(const struct known_lights *known, unsigned bit)
{
    unsigned on = 0;

    for (int k = 0; k < LANES; k++)
        on |= (unsigned)(known->seen->lit[known->slot[k]] >> bit & 1) << k;
    return mof(on);
}

/* Gives the part of a sample's light that arrives, with the error of its product with the reflected part. */
LANE_OP vd known_share(const struct known_lights *known, unsigned bit, vm lit, vd *e)
{
    unsigned on = mbits(lit);

    *e = vset(0);
    if (!known->seen->shared)
        return vset(1);
#define SHARE(k) (on >> (k)&1 ? known->seen->shares[known->slot[k]][bit] : 0)
    vd share = (vd){EACH_LANE(SHARE)} * (1.0 / (1 << SURE_SHARE_BITS));
#undef SHARE
    *e = vset(BOUND(THROUGH_UNIT));
    return share;
}

/* Adds the samples of light n whose arrival is known, without shadow rays. */
static __attribute__((noinline)) void add_known(uint32_t n, const struct sure_light *l, const struct aim *aim,
                                                const struct shade *h, vm lanes, struct lit *sum)
{
    const struct sure_seen *seen = sum->known->seen;
    struct picked pick = {.run = false, .class = {0}};
    struct sample *s = &sum->room->sample;

    for (pick.sample = 0; pick.sample < l->from->samples; pick.sample++) {
        unsigned bit = seen->first_bit[n] + (seen->whole ? 0 : pick.sample);
        struct lambert lambert;
        vm lit = mand(lanes, reached_lanes(sum->known, bit));
        if (!any(lit))
            continue;
        sample_of(l, aim, h, &pick, s);
        find_falloff(l, s);
        lit = find_lambert(h, s, lit, &lambert, sum);
        if (!any(lit))
            continue;
        vd e, share = known_share(sum->known, bit, lit, &e), through[3] = {share, share, share};
        add_reflected(l, h, s, &lambert, lit, through, e, sum);
    }
}

/* Adds the light's samples one after another, each for all points at once. */
static void add_samples(const struct sure_scene *s, const struct sure_light *l, const struct aim *aim,
                        const struct shade *h, vm lanes, const uint8_t class[LANES], uint32_t *blocker, struct lit *sum)
{
    struct picked pick = {.run = false};
    struct sample *sample = &sum->room->sample;

    for (int k = 0; k < LANES; k++)
        pick.class[k] = class[k];
    for (pick.sample = 0; pick.sample < l->from->samples && !cancelled(sum->cancel, 1); pick.sample++) {
        sample_of(l, aim, h, &pick, sample);
        find_falloff(l, sample);
        add_sample(s, l, h, sample, lanes, blocker, sum);
    }
}

/* Adds all samples of the light for one point. Rays from one point to a light take similar paths through the hierarchy,
 * even if the packet's points are far apart. */
static void add_point(const struct sure_scene *s, const struct sure_light *l, const struct aim *aim,
                      const struct shade *h, uint8_t class, uint32_t *blocker, struct lit *sum)
{
    unsigned n = l->from->samples;
    struct picked pick = {.run = true};
    struct sample *sample = &sum->room->sample;

    for (int k = 0; k < LANES; k++)
        pick.class[k] = class;
    for (pick.sample = 0; pick.sample < n && !any(sum->unsure) && !cancelled(sum->cancel, 1); pick.sample += LANES) {
        unsigned left = n - pick.sample, lanes = left < LANES ? (1u << left) - 1 : (1u << LANES) - 1;
        sample_of(l, aim, h, &pick, sample);
        find_falloff(l, sample);
        add_sample(s, l, h, sample, mof(lanes), blocker, sum);
    }
}

static void add_points(const struct sure_scene *s, const struct sure_light *l, const struct aim *aim,
                       const struct shade *h, unsigned lanes, const uint8_t class[LANES], uint32_t *blocker,
                       struct lit *sum)
{
    struct light_room *room = sum->room;
    struct lit *one = &room->one;
    struct aim *there = &room->there;

    for (int k = 0; lanes >> k; k++) {
        if (!(lanes >> k & 1))
            continue;
        spread_shade(h, k, &room->point);
        there->axes[0] = v3_spread(&aim->axes[0], k);
        there->axes[1] = v3_spread(&aim->axes[1], k);
        there->e = vspread(&aim->e, k);
        *one = (struct lit){.cancel = sum->cancel, .room = room, .unsure = mnone()};
        add_point(s, l, there, &room->point, class[k], blocker, one);
        for (int c = 0; c < 3; c++)
            sum->own[c] = gain_lane(sum->own[c], k, one->own[c]);
        sum->eown = gain_lane(sum->eown, k, one->eown);
        sum->unsure = mor(sum->unsure, mof((unsigned)any(one->unsure) << k));
    }
}

/* True if the points are lit one by one. Points close together share a packet for each sample. Points far apart have
 * packets of their own; so do few points with many samples, as that takes fewer packets. */
LANE_OP bool each_by_itself(const struct sure_light *l, unsigned lanes, bool apart)
{
    unsigned n = l->from->samples, packets = (n + LANES - 1) / LANES * (unsigned)__builtin_popcount(lanes);

    return LANES > 1 && tia_light_has(l->from->kind, TIA_LIGHT_AREA) &&
           (apart ? 4 * packets <= 5 * n : 2 * packets <= n);
}

/* Adds the sums over an area light's samples, as reflect_light() and add_reflected() do for one. */
LANE_OP void add_area_sum(const struct area *a, const struct shade *h, vm lanes, struct lit *sum)
{
    const struct area_sum *of = &sum->room->area_sum;
    const struct sure_light *l = a->light;
    double part = 1.0 / l->from->samples;
    vd e = BOUND_OF(DIFFUSE, most3(h->colour) * area_lambert_error(a, h) + BOUND_OF(DIFFUSE_TEXTURE, h->ecolour));

    e = e * of->count + most3(h->specular) * of->eshine;
    e = BOUND_OF(SAMPLE_LIGHT, e + 2 * BOUND(THROUGH_UNIT) * of->filters) + of->count * BOUND(SAMPLE_SUM);
    e = e * (l->brightest * part) + of->count * BOUND(SAMPLE_SUM);
    lanes = mand(lanes, mnot(of->unsure));
    sum->unsure = mor(sum->unsure, of->unsure);
    for (int c = 0; c < 3; c++) {
        vd rgb = h->colour[c] * of->lambert[c] + h->specular[c] * of->shine[c];
        sum->own[c] = sum->own[c] + vsel(lanes, rgb * (l->emission[c] * part), vset(0));
    }
    sum->eown = sum->eown + vsel(lanes, e, vset(0));
}

/* Adds an area light to the lanes where it can be taken as a whole; returns the others. Lanes of which others' rays are
 * to be traced are left as well if they are few: single points then take fewer packets. */
static unsigned add_area(const struct sure_scene *s, const struct sure_light *l, const struct aim *aim,
                         const struct shade *h, unsigned lanes, const uint8_t class[LANES], struct lit *sum)
{
    struct light_room *room = sum->room;
    struct shaft *f = &room->shaft;
    unsigned others = 0;

    if (!tia_light_has(l->from->kind, TIA_LIGHT_AREA) || tia_light_has(l->from->kind, TIA_LIGHT_CONE) ||
        l->from->fades || !l->place)
        return lanes;
    set_area(l, aim, h, &room->area);
    lanes &= ~mbits(turned_away(&room->area, h));
    if (!lanes)
        return 0;
    f->area = &room->area;
    f->shade = h;
    find_shaft(s, &room->room, lanes, f);
    (void)cancelled(sum->cancel, f->work + l->from->samples);
    for (int i = 0; i < f->others; i++)
        others |= f->other[i].lanes & f->lanes & ~f->rest;
    if (__builtin_popcount(others) <= AREA_FEW)
        f->rest |= others;
    if (!(f->lanes & ~f->rest))
        return f->rest;
    if (f->balls || f->others)
        sum_blocked(s, f, &room->shadow, class, &room->area_sum);
    else
        sum_clear(s, f, class, &room->area_sum);
    add_area_sum(&room->area, h, mof(f->lanes & ~f->rest), sum);
    return f->rest;
}

static void add_light(const struct sure_scene *s, uint32_t n, const struct shade *h, vm lanes, bool apart,
                      const uint8_t class[LANES], uint32_t *blocker, struct lit *sum)
{
    const struct sure_light *l = &s->lights[n];
    struct aim *aim = &sum->room->aim;

    if (tia_light_has(l->from->kind, TIA_LIGHT_EVERYWHERE)) {
        if (l->radius > 0) /* the occlusion is undecided, see `occluded` in struct sure_scene */
            sum->unsure = mor(sum->unsure, lanes);
        for (int c = 0; c < 3; c++)
            sum->own[c] = sum->own[c] + h->colour[c] * l->emission[c];
        sum->eown = sum->eown + BOUND_OF(AMBIENT, h->ecolour * l->brightest) + BOUND(SAMPLE_SUM);
        return;
    }
    aim_at(l, h, aim);
    sum->unsure = mor(sum->unsure, mand(aim->unsure, lanes));
    if (sum->known) {
        add_known(n, l, aim, h, lanes, sum);
        return;
    }
    unsigned left = mbits(mand(lanes, mnot(sum->unsure)));
    left = add_area(s, l, aim, h, left, class, sum);
    if (!left)
        return;
    if (each_by_itself(l, left, apart))
        add_points(s, l, aim, h, left, class, blocker, sum);
    else
        add_samples(s, l, aim, h, mof(left), class, blocker, sum);
}

#endif
