/* light_tmpl.h - direct lighting: Lambert, Phong highlight, shadow rays.
 *
 * Parameters: the doubles of isa/isa.h. Defines: add_light(), spot_falloff(), attenuate(), struct falloff, struct lit,
 * struct light_room. */
#ifndef TIA_SIMD_RAYS_LIGHT_TMPL_H
#define TIA_SIMD_RAYS_LIGHT_TMPL_H

#include "power_tmpl.h"
#include "spread_tmpl.h"

/* The axes along which a light's samples lie, as seen from each lane's point; see struct ray_aim. For a sphere they are
 * those of a disc that faces the point. */
struct aim {
    struct v3 axes[2];
    vd e;
    vm unsure;
};

/* Sets the axes, as shape_axes() does, for the direction from a sphere light's centre to the point. They depend on
 * which of its coordinates is the smallest, which must be certain. */
static void aim_at_sphere(const struct sure_light *l, const struct shade *h, struct aim *a)
{
    vd e;
    struct v3 n = v3_unit(v3_sub(h->point, v3_set(l->at)),
                          BOUND_OF(AIM_DIRECTION, h->ep + v3_sum(h->point) * BOUND(POINT_ROUNDING)), &e);
    vd x = vabs(n.x), y = vabs(n.y), z = vabs(n.z), e2 = BOUND_OF(AIM_ORDER, 2 * e), zero = vset(0);
    vm is_x = mand(vlt(x + e2, y), vlt(x + e2, z)), is_y = mand(vlt(y + e2, x), vlt(y + e2, z));
    vm is_z = mand(vlt(z + e2, x), vlt(z + e2, y));
    struct v3 c = {vsel(is_x, zero, vsel(is_y, n.z, -n.y)), vsel(is_x, -n.z, vsel(is_y, zero, n.x)),
                   vsel(is_x, n.y, vsel(is_y, -n.x, zero))};

    a->unsure = mnot(mor(is_x, mor(is_y, is_z)));
    a->axes[0] = v3_unit(c, e, &a->e);
    a->axes[1] = v3_cross(n, a->axes[0]);
    a->e = BOUND_OF(AIM_AXES, a->e + e + BOUND(AIM_ROUNDING));
}

static void aim_at(const struct sure_light *l, const struct shade *h, struct aim *a)
{
    a->unsure = mnone();
    a->e = vset(BOUND(AIM_CONVERTED));
    a->axes[0] = v3_set(l->axes[0]);
    a->axes[1] = v3_set(l->axes[1]);
    if (ray_light_turns(l->from))
        aim_at_sphere(l, h, a);
}

/* The factor of the light that arrives: the attenuation, and the falloff of a spot light. */
struct falloff {
    vd factor, e;
    vm unsure;
};

/* Sets the factor (c - outer)/(inner - outer), clamped to 0..1. If the angles of the cone are nearly equal, its edge is
 * sharp instead. */
static void spot_falloff(const struct sure_light *l, struct v3 to, vd eto, struct falloff *f)
{
    vd c = -v3_dot(to, v3_set(l->normal)), e = BOUND_OF(SPOT_COSINE, eto + BOUND(COSINE)),
       width = vset(l->inner - l->outer);

    if (l->inner - l->outer < BOUND(SPOT_NARROW)) {
        f->unsure = mor(f->unsure, mand(vlt(vset(l->outer) - e, c), vlt(c, vset(l->inner) + e)));
        f->factor = vsel(vlt(c, vset(l->inner)), vset(0), vset(1));
        return;
    }
    f->factor = vmin(vmax((c - vset(l->outer)) / width, vset(0)), vset(1));
    f->e = BOUND_OF(SPOT, BOUND(SPOT_WIDTH) * e / width) + BOUND(SPOT_UNITS);
}

/* Multiplies the factor by the attenuation 1/(constant + linear d + quadratic d^2). The fixed-point attenuation is 0
 * where the sum is 2^17 or more. Where the sum is above 2^16, the error includes 2^-16, the largest value there. */
static void attenuate(const struct sure_light *l, vd distance, vd edistance, struct falloff *f)
{
    vd d = distance * vset(l->unit),
       ed = BOUND_OF(FADE_DISTANCE, edistance * vset(l->unit) + BOUND(FADE_UNITS) + d * BOUND(FADE_ROUNDING));
    vd slope = vset(l->linear) + vset(l->quadratic) * d, sum = vset(l->constant) + slope * d;
    vd esum =
        BOUND_OF(FADE_SUM, (slope + vset(l->quadratic) * (d + ed)) * ed) + (sum + d + 1) * BOUND(FADE_SUM_ROUNDING);
    vm fine = mand(vlt(vset(BOUND(FADE_LEAST)), sum), vlt(BOUND(FADE_KNOWN) * esum, sum)), far = vlt(vset(65536), sum);
    vd factor = 1 / vsel(fine, sum, vset(1));

    f->unsure = mor(f->unsure, mnot(fine));
    f->e = BOUND_OF(FADE_SPOT, f->e * factor) +
           (f->factor + f->e) * (BOUND_OF(FADE, BOUND(FADE_INVERSE) * esum * factor * factor) +
                                 vsel(far, vset(BOUND(FADE_FAR)), vset(0))) +
           BOUND(FADE_FACTOR);
    f->factor = f->factor * factor;
}

/* A light's sample: vector and unit direction from P, and their errors. */
struct sample {
    struct v3 way, to;
    vd ew, eto;
    struct falloff falloff;
};

static void find_falloff(const struct sure_light *l, struct sample *s)
{
    s->falloff = (struct falloff){vset(1), vset(0), mnone()};
    if (tia_light_has(l->from->kind, TIA_LIGHT_CONE))
        spot_falloff(l, s->to, s->eto, &s->falloff);
    if (l->from->fades) {
        vd distance = v3_dot(s->way, s->to);
        attenuate(l, distance, BOUND_OF(DISTANCE, s->ew + distance * BOUND(DISTANCE_ROUNDING) + BOUND(LENGTH_UNIT)),
                  &s->falloff);
    }
}

/* The samples of a light that the lanes evaluate, and the classes of their pixels. `run`: lane k has sample `sample` +
 * k, all for one pixel; otherwise all lanes have `sample`. */
struct picked {
    unsigned sample;
    bool run;
    uint8_t class[LANES];
};

/* Finds the coordinates of the samples along the light's axes. */
LANE_OP void find_places(const struct sure_light *l, const struct picked *pick, vd *x, vd *y)
{
    double other[LANES][2];
    const double *place[LANES];

    if (l->place && pick->run) {
        *x = vload(&l->place[pick->class[0]][0][pick->sample]);
        *y = vload(&l->place[pick->class[0]][1][pick->sample]);
        return;
    }
    for (unsigned k = 0; k < LANES; k++) {
        unsigned i = pick->sample + (pick->run ? k : 0);
        place[k] = l->place ? &l->place[pick->class[k]][0][i] : other[k];
        if (!l->place)
            tia_sure_place(l, i < l->from->samples ? i : 0, pick->class[k], other[k]);
    }
    *x = vgather(place, 0);
    *y = vgather(place, l->place ? SURE_PLACES : 1);
}

static __attribute__((noinline)) void sample_of(const struct sure_light *l, const struct aim *a, const struct shade *h,
                                                const struct picked *pick, struct sample *s)
{
    if (tia_light_has(l->from->kind, TIA_LIGHT_FAR)) {
        s->way = s->to = v3_neg(v3_set(l->normal));
        s->ew = s->eto = vset(BOUND(CONVERTED));
        return;
    }
    s->way = v3_sub(v3_set(l->at), h->point);
    s->ew = BOUND_OF(SAMPLE_WAY, h->ep + (v3_sum(s->way) + v3_sum(h->point)) * BOUND(POINT_ROUNDING));
    if (tia_light_has(l->from->kind, TIA_LIGHT_AREA)) {
        vd x, y;
        find_places(l, pick, &x, &y);
        s->way = v3_add(s->way, v3_add(v3_scale(a->axes[0], x), v3_scale(a->axes[1], y)));
        s->ew = s->ew + BOUND_OF(SAMPLE_AREA, (vabs(x) + vabs(y)) * (a->e + BOUND(SAMPLE_PLACE))) +
                BOUND(SAMPLE_UNITS) + (v3_sum(a->axes[0]) + v3_sum(a->axes[1])) * BOUND(SAMPLE_SIDES);
    }
    s->to = v3_unit(s->way, s->ew, &s->eto);
}

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

/* Computes the reflected light and its error. */
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
    half = vmin(vmax(half, vset(0)), vset(1));
    vd shine = vsel(glossy, power(half, h->exponent), vset(0));
    for (int c = 0; c < 3; c++)
        rgb[c] = rgb[c] + h->specular[c] * shine;
    *e = *e +
         vsel(glossy, most3(h->specular) * (BOUND_OF(HIGHLIGHT, h->exponent * ehalf) + vset(BOUND(POWER))), vset(0));
}

struct light_room;

/* Sums of the light that the points reflect, and their errors; `cancel` counts the work. */
struct lit {
    struct cancel *cancel;
    struct light_room *room;
    vd own[3], eown;
    vm unsure;
};

/* A call's memory for lighting, including that of shadow rays' walks; `there`, `point` and `one` belong to a single
 * point. */
struct light_room {
    struct room room;
    struct aim aim, there;
    struct sample sample;
    struct shadow shadow;
    struct shade point;
    struct lit one;
};

static __attribute__((noinline)) void add_sample(const struct sure_scene *scene, const struct sure_light *l,
                                                 const struct shade *h, const struct sample *s, vm lanes,
                                                 uint32_t *blocker, struct lit *sum)
{
    vd lambert = v3_dot(h->normal, s->to), above = v3_dot(h->geometric, s->to);
    vd el = BOUND_OF(LAMBERT, h->en + s->eto + BOUND(COSINE)), ea = BOUND_OF(ABOVE, h->eg + s->eto + BOUND(COSINE)),
       rgb[3], e;
    vm dark = mor(vlt(lambert, -el), vlt(above, -ea)), lit = mand(vlt(el, lambert), vlt(ea, above));
    double part = 1.0 / l->from->samples;
    struct shadow *shadow = &sum->room->shadow;

    dark = mor(dark, vlt(s->falloff.factor + s->falloff.e, vset(BOUND(SAMPLE_DARK))));
    sum->unsure = mor(sum->unsure, mand(lanes, mor(mnot(mor(dark, lit)), mand(lit, s->falloff.unsure))));
    lit = mand(lit, mnot(dark));
    lit = mand(mand(lit, lanes), mnot(sum->unsure));
    if (!any(lit))
        return;
    aim_shadow(scene, l, h, s, shadow);
    find_shadow(scene, &sum->room->room, shadow, lit, blocker);
    (void)cancelled(sum->cancel, shadow->work);
    sum->unsure = mor(sum->unsure, shadow->unsure);
    lit = mand(lit, mnot(mor(shadow->blocked, shadow->unsure)));
    if (!any(lit))
        return;
    reflect_light(h, s, lambert, el, lit, rgb, &e);
    vd factor = s->falloff.factor;
    e = BOUND_OF(SAMPLE_LIGHT, (e + 2 * shadow->ethrough) * factor) + BOUND_OF(SAMPLE_FALLOFF, 2 * s->falloff.e) +
        BOUND_OF(SAMPLE_FALLOFF_MORE, 2 * s->falloff.e * e);
    for (int c = 0; c < 3; c++)
        sum->own[c] = sum->own[c] + vsel(lit, rgb[c] * shadow->through[c] * factor * (l->emission[c] * part), vset(0));
    sum->eown = sum->eown + vsel(lit, (e + BOUND(SAMPLE_SUM)) * (l->brightest * part) + BOUND(SAMPLE_SUM), vset(0));
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
    unsigned left = mbits(mand(lanes, mnot(sum->unsure)));
    if (each_by_itself(l, left, apart))
        add_points(s, l, aim, h, left, class, blocker, sum);
    else
        add_samples(s, l, aim, h, lanes, class, blocker, sum);
}

#endif
