/* emitters_tmpl.h - samples of points on emitters, and their densities: render/path/emitters.c in doubles.
 *
 * Parameters: the doubles of isa/isa.h. Defines: see_emitter(), plane_density(), ball_density(), struct emitter_view.
 *
 * Densities are per solid angle, times pi. The errors of quotients are derived as relative ones, since fixed-point
 * densities have a mantissa and an exponent. */
#ifndef TIA_SIMD_RAYS_EMITTERS_TMPL_H
#define TIA_SIMD_RAYS_EMITTERS_TMPL_H

#include "direction_tmpl.h"
#include "gather.h"
#include "interval_tmpl.h"
#include "light_tmpl.h"

/* A sample of an emitter, as seen from each lane's point. */
struct emitter_view {
    struct v3 to;
    vd eto, distance, edistance;
    struct ve density; /* 0 for an emitter without surface */
    vd factor, efactor;
    vm some, unsure; /* some: the sample faces the point; unsure: the lane is undecided */
};

/* Returns the density pi d^2/(A c), A being the area and c the cosine at the emitter. The relative errors x = ed/d and
 * y = ecosine/|c| are below 1/8, so that of the density is at most (1 + x)^2/(1 - y) - 1 <= (2.125 x + y)/(1 - y) <=
 * 2.43 x + 1.15 y. */
LANE_OP struct ve plane_density(const struct sure_shine *shine, vd d, vd ed, vd cosine, vd ecosine, vm *fine)
{
    vd size = vabs(cosine);
    vm good = mand(vlt(BOUND(PLANE_DENSITY_KNOWN) * ecosine, size), vlt(BOUND(PLANE_DENSITY_KNOWN) * ed, d));

    size = vsel(good, size, vset(1));
    d = vsel(good, d, vset(1));
    vd v = 3.14159265358979324 / shine->area * (d * d) / size;
    *fine = mand(*fine, good);
    return ve_of(
        v, BOUND_OF(PLANE_DENSITY, v * (BOUND(PLANE_DENSITY_DISTANCE) * ed / d +
                                        BOUND(PLANE_DENSITY_COSINE) * ecosine / size + BOUND(PLANE_DENSITY_ROUNDING))));
}

/* Returns 1 - cos of the half angle of the cone that a sphere of radius r fills, with the relative error *part. With
 * the sine s = r/d it is s^2/(1 + sqrt(1 - s^2)). The relative error p of s^2 is 2.25 ed/d and roundings, as 1/(1 -
 * x)^2 - 1 <= 2.1 x for x = ed/d <= 1/32; the roundings of the fixed-point code are 2^-60 in all. The root is off by at
 * most s^2 p/root, and 1 + root is more than 1. The sum of both errors, times 1.15 for the quotient, is *part, provided
 * that this is at most 1/8; all other lanes are undecided. */
LANE_OP vd cone_open(vd d, vd ed, double r, vd *part, vm *fine)
{
    vd away = vsel(vlt(vset(0), d), d, vset(1)), sine = vset(r) / away, square = sine * sine, rest = 1 - square;
    vm good = mand(vlt(vset(BOUND(CONE_WIDE)), rest),
                   mand(vlt(BOUND(CONE_SINE_KNOWN) * ed, d), vlt(vset(BOUND(CONE_NARROW)), square)));

    square = vsel(good, square, vset(0.5));
    vd root = vsqrt(vsel(good, rest, vset(0.5))),
       p = BOUND_OF(CONE_SINE_PART, BOUND(CONE_SINE) * ed / away + BOUND(CONE_SINE_ROUNDING)) +
           BOUND(CONE_SINE_UNITS) / square;
    *part = BOUND_OF(CONE_PART, BOUND(CONE_QUOTIENT) * (p + p * square / root)) + vset(BOUND(CONE_QUOTIENT_ROUNDING));
    *fine = mand(*fine, mand(good, vlt(*part, vset(0.125))));
    return square / (1 + root);
}

/* Returns the density of a sphere's visible points; 0 if the sphere contains `from`. */
LANE_OP struct ve ball_density(const double at[3], double radius, struct v3 from, vd efrom, vm *fine)
{
    struct v3 way = v3_sub(v3_set(at), from);
    vd d = vsqrt(v3_dot(way, way)),
       ed = BOUND_OF(BALL_DISTANCE,
                     efrom + (v3_sum(way) + v3_sum(from)) * BOUND(BALL_DISTANCE_ROUNDING) + BOUND(LENGTH_UNIT)),
       part;
    vm inside = vle(d + ed, vset(radius)), good = mnot(mnone());
    vd v = 0.5 / cone_open(d, ed, radius, &part, &good);

    *fine = mand(*fine, mor(inside, good));
    return ve_of(vsel(inside, vset(0), v), vsel(inside, vset(0), v * BOUND(BALL_DENSITY) * part));
}

/* Sets the view of a point on an emitter. `normal` points to the side of the viewing point, from which `way` leads to
 * the end of the shadow ray. */
LANE_OP void see_place(struct emitter_view *a, struct v3 way, vd e, struct v3 normal, vd enormal, vd *cosine,
                       vd *ecosine)
{
    a->distance = vsqrt(v3_dot(way, way));
    a->edistance = BOUND_OF(SEEN_DISTANCE, e + a->distance * BOUND(SEEN_DISTANCE_ROUNDING) + BOUND(LENGTH_UNIT));
    a->to = v3_unit(way, e, &a->eto);
    *cosine = v3_dot(a->to, normal);
    *ecosine = BOUND_OF(SEEN_COSINE, a->eto + enormal + BOUND(COSINE));
    a->some = vlt(*cosine, -*ecosine);
    a->unsure = mor(a->unsure, mnot(mor(a->some, vlt(*ecosine, *cosine))));
    a->factor = vset(1);
    a->efactor = vset(0);
}

/* Sets the view of a sample on a rectangle or a disc. */
static void see_plane(const struct sure_scene *s, const struct sure_light *l, const struct sure_shine *shine,
                      struct v3 from, vd efrom, const vu u[2], struct emitter_view *a)
{
    vd x, y, cosine, ecosine;

    if (tia_light_has(l->from->kind, TIA_LIGHT_SIDES)) {
        x = 2 * vu_unit(u[0]) - 1;
        y = 2 * vu_unit(u[1]) - 1;
    } else {
        (void)disc_place(u[0], u[1], &x, &y);
        x = x * vset(l->radius);
        y = y * vset(l->radius);
    }
    struct v3 across = v3_scale(v3_set(l->axes[0]), x), along = v3_scale(v3_set(l->axes[1]), y);
    struct v3 place = v3_add(v3_set(l->at), v3_add(across, along)), normal = v3_set(l->normal);
    vd eplace = BOUND_OF(EMITTER_PLACE, BOUND(EMITTER_PLACE_UNITS) +
                                            (v3_sum(place) + v3_sum(across) + v3_sum(along) + vset(l->radius)) *
                                                BOUND(EMITTER_PLACE_ROUNDING));
    struct v3 back = v3_sub(from, place);
    vd side = v3_dot(back, normal),
       eside = BOUND_OF(EMITTER_SIDE, efrom + eplace + (v3_sum(back) + v3_sum(from)) * BOUND(EMITTER_SIDE_ROUNDING) +
                                          BOUND(EMITTER_SIDE_UNITS));
    vm front = vle(vset(0), side), fine = mnot(mnone());
    a->unsure = vle(vabs(side), eside);
    normal = v3_sel(front, normal, v3_neg(normal));
    struct v3 way = v3_sub(v3_along(place, normal, vset(s->bias)), from);
    see_place(a, way, eside, normal, vset(BOUND(CONVERTED)), &cosine, &ecosine);
    a->density = plane_density(shine, a->distance, a->edistance, cosine, ecosine, &fine);
    a->unsure = mor(a->unsure, mand(a->some, mnot(fine)));
}

/* Returns the point where a ray within the cone enters the ball, at t = tca - thc, with the bounds of sphere_tmpl.h.
 * The few rays that miss the ball by rounding are undecided. */
LANE_OP struct v3 ball_place(struct v3 way, struct v3 from, vd efrom, struct v3 d, vd ed, double radius, vd *ep,
                             vm *fine)
{
    vd r = vset(radius), tca = v3_dot(way, d), l1 = v3_sum(way), eo = efrom + v3_sum(from) * BOUND(BALL_WAY_ROUNDING);
    struct v3 side = v3_sub(way, v3_scale(d, tca));
    vd p2 = v3_dot(side, side), s = r * r - p2, round = r * r * BOUND(SPHERE_SQUARE_ROUNDING);
    vd lambda = BOUND_OF(SPHERE_ACROSS, eo + vabs(tca) * ed + l1 * BOUND(SPHERE_ASIDE) + BOUND(SPHERE_ASIDE_UNIT));
    vd all = BOUND_OF(SPHERE_ANY, eo + l1 * (2 * ed + BOUND(SPHERE_ASIDE)) + BOUND(SPHERE_ANY_UNITS));
    vd es = BOUND_OF(SPHERE_SQUARE, 2 * r * lambda + all * all + round);
    vm good = vlt(es, s);
    vd thc = vsqrt(vsel(good, s, vset(1))),
       ethc = BOUND_OF(SPHERE_HALF_CHORD, root_error(2 * r * lambda + all * all + round, thc) +
                                              BOUND(SPHERE_ROOT_UNIT) + BOUND(SPHERE_ROOT) * r);
    vd across = BOUND_OF(SPHERE_POINT_ACROSS, lambda + thc * ed),
       beside = BOUND_OF(SPHERE_POINT_ALONG, r * ed + ethc + all * ed);

    *ep = BOUND_OF(BALL_PLACE,
                   across + beside + BOUND(BALL_PLACE_UNITS) + (l1 + v3_sum(from)) * BOUND(BALL_PLACE_ROUNDING));
    *fine = mand(*fine, good);
    return v3_along(from, d, tca - thc);
}

static void see_ball(const struct sure_scene *s, const double at[3], double radius, struct v3 from, vd efrom,
                     const vu u[2], struct emitter_view *a)
{
    struct v3 way = v3_sub(v3_set(at), from), local;
    vd e = BOUND_OF(BALL_WAY, efrom + (v3_sum(way) + v3_sum(from)) * BOUND(BALL_WAY_ROUNDING) + BOUND(LENGTH_UNIT)),
       d = vsqrt(v3_dot(way, way)), ed, part, en, ep;
    vd cosine, ecosine;
    vm outside = vlt(vset(radius), d - e), fine = outside, turned;

    ed = BOUND_OF(SEEN_DISTANCE, e + d * BOUND(SEEN_DISTANCE_ROUNDING) + BOUND(LENGTH_UNIT));
    vd open = cone_open(d, ed, radius, &part, &fine), h = open * vu_unit(u[0]), square = h * (2 - h);
    vd r = vsqrt(square),
       eh = BOUND_OF(BALL_HEIGHT, h * (part + BOUND(BALL_HEIGHT_ROUNDING)) + BOUND(BALL_HEIGHT_UNITS)),
       er =
           BOUND_OF(BALL_RADIUS, BOUND(BALL_RADIUS_ROOT) * eh / vmax(r, vset(1e-12)) + r * BOUND(BALL_RADIUS_ROUNDING));
    vd x, y;
    turn_place(u[1], &x, &y);
    local = (struct v3){r * x, r * y, 1 - h};
    struct v3 axis = v3_unit(way, e, &en);
    struct v3 to = around(axis, en, mnone(), local, BOUND_OF(BALL_LOCAL, er + eh + vset(BOUND(LOCAL))), &ed, &turned);
    struct v3 place = ball_place(way, from, efrom, to, ed, radius, &ep, &fine);
    struct v3 normal = v3_unit(v3_sub(place, v3_set(at)),
                               BOUND_OF(BALL_NORMAL, ep + v3_sum(place) * BOUND(BALL_NORMAL_ROUNDING)), &en);
    struct v3 end = v3_sub(v3_along(place, normal, vset(s->bias)), from);
    a->unsure = mor(turned, mnot(fine));
    see_place(a, end,
              BOUND_OF(BALL_END, ep + efrom + BOUND(POINT_UNITS) + en * vset(s->bias) +
                                     (v3_sum(end) + v3_sum(place)) * BOUND(BALL_END_ROUNDING)),
              normal, en, &cosine, &ecosine);
    a->density = ve_of(0.5 / open, 0.5 / open * BOUND(BALL_DENSITY) * part);
    vm inside = vle(d + e, vset(radius));
    a->some = mand(a->some, mnot(inside));
    a->unsure = mand(a->unsure, mnot(inside));
}

/* Sets the view of a point, a spot or a directional light. */
static void see_point(const struct sure_light *l, struct v3 from, vd efrom, struct emitter_view *a)
{
    struct falloff f = {vset(1), vset(0), mnone()};

    a->unsure = mnone();
    a->some = mnot(mnone());
    a->density = ve_of(vset(0), vset(0));
    a->distance = vset(131072);
    a->edistance = vset(0);
    a->to = v3_neg(v3_set(l->normal));
    a->eto = vset(BOUND(CONVERTED));
    if (!tia_light_has(l->from->kind, TIA_LIGHT_FAR)) {
        struct v3 way = v3_sub(v3_set(l->at), from);
        vd e = BOUND_OF(POINT_WAY, efrom + (v3_sum(way) + v3_sum(from)) * BOUND(POINT_ROUNDING));
        a->to = v3_unit(way, e, &a->eto);
        a->distance = v3_dot(way, a->to);
        a->edistance = BOUND_OF(DISTANCE, e + a->distance * BOUND(DISTANCE_ROUNDING) + BOUND(LENGTH_UNIT));
        if (tia_light_has(l->from->kind, TIA_LIGHT_CONE))
            spot_falloff(l, a->to, a->eto, &f);
        if (l->from->fades)
            attenuate(l, a->distance, a->edistance, &f);
    }
    a->factor = f.factor;
    a->efactor = f.e;
    a->unsure = f.unsure;
}

static void see_emitter(const struct sure_scene *s, const struct sure_emitter *e, struct v3 from, vd efrom,
                        const vu u[2], struct emitter_view *a)
{
    const struct sure_light *l = e->light == TIA_NO_OBJECT ? NULL : &s->lights[e->light];

    if (!l)
        see_ball(s, s->object[e->sphere].at, s->object[e->sphere].radius, from, efrom, u, a);
    else if (!tia_light_has(l->from->kind, TIA_LIGHT_AREA))
        see_point(l, from, efrom, a);
    else if (tia_light_has(l->from->kind, TIA_LIGHT_BALL))
        see_ball(s, l->at, l->radius, from, efrom, u, a);
    else
        see_plane(s, l, e->shine, from, efrom, u, a);
    if (!e->shine->known)
        a->unsure = mnot(mnone());
}

#endif
