/* reflect_tmpl.h - the light that points reflect: Lambert, Phong highlight, and the sums over lights.
 *
 * Parameters: the doubles of isa/isa.h. Defines: lit_begin(), find_lambert(), add_reflected(), add_area_sum(), struct
 * lit, struct light_room, struct lambert. */
#ifndef TIA_SIMD_RAYS_REFLECT_TMPL_H
#define TIA_SIMD_RAYS_REFLECT_TMPL_H

#include "area_sum_tmpl.h"

struct light_room;
struct known_lights;

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

/* Sets sums of no light. They are large, so that they are set field by field. */
LANE_OP void lit_begin(struct lit *lit, struct cancel *cancel, struct light_room *room,
                       const struct known_lights *known)
{
    lit->cancel = cancel;
    lit->room = room;
    lit->known = known;
    lit->own[0] = lit->own[1] = lit->own[2] = lit->eown = vset(0);
    lit->unsure = mnone();
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

/* Adds the sums over an area light's samples, as reflect_light() and add_reflected() do for one. */
LANE_OP void add_area_sum(const struct area *a, const struct area_sum *of, const struct shade *h, vm lanes,
                          struct lit *sum)
{
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

#endif
