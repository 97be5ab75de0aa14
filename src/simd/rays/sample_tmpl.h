/* sample_tmpl.h - the samples of a light: directions, attenuation, the cone of a spot light.
 *
 * Parameters: the doubles of isa/isa.h. Defines: aim_at(), sample_of(), find_falloff(), spot_falloff(), attenuate(),
 * struct aim, struct falloff, struct sample, struct picked. */
#ifndef TIA_SIMD_RAYS_SAMPLE_TMPL_H
#define TIA_SIMD_RAYS_SAMPLE_TMPL_H

#include "surface_tmpl.h"

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

#endif
