/* light_tmpl.h - direct lighting with shadow rays.
 *
 * Parameters: the doubles of isa/isa.h. Defines: add_light(). */
#ifndef TIA_SIMD_RAYS_LIGHT_TMPL_H
#define TIA_SIMD_RAYS_LIGHT_TMPL_H

#include "known_tmpl.h"
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
        lit_begin(one, sum->cancel, room, NULL);
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

/* Adds an area light to the lanes where it can be taken as a whole; returns the others. Lanes of which others' rays are
 * to be traced are left as well if they are few: single points then take fewer packets. */
static unsigned add_area(const struct sure_scene *s, const struct sure_light *l, const struct aim *aim,
                         const struct shade *h, unsigned lanes, const uint8_t class[LANES], struct lit *sum)
{
    struct light_room *room = sum->room;
    struct shaft *f = &room->shaft;
    unsigned others = 0;

    if (!is_plain_area(l))
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
    add_area_sum(&room->area, &room->area_sum, h, mof(f->lanes & ~f->rest), sum);
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
