/* ray_areas.h - for tests of area lights as a whole: a random light and a point that sees it, and exact rays between
 * them. Include it after one_lane.h. */
#ifndef TESTS_RAY_AREAS_H
#define TESTS_RAY_AREAS_H

#include "ray_steps.h"

enum { TRIES = 20000, SAMPLES = 8 };
#define WITHIN .9999L /* used part of a bound */

static struct light_room room;
static double places[16][2][SURE_PLACES];

/* A light of a few samples on a rectangle or a disc, and a point that sees it. */
struct scenery {
    struct ray_light from;
    struct sure_light light;
    struct shade shade;
    struct aim aim;
    struct area area;
};

static inline struct real place_of(const struct scenery *c, int i)
{
    struct real s = {{c->light.at[0], c->light.at[1], c->light.at[2]}};

    s = real_along(s, real_of(c->area.axes[0]), places[0][0][i]);
    return real_along(s, real_of(c->area.axes[1]), places[0][1][i]);
}

static inline void some_light(struct scenery *c)
{
    bool sides = random_bits() % 2;
    struct real n = real_random(), a = real_aside(n), b = real_cross(n, a), at = real_random();
    double far = 1 + 7 * some_part(), size = (sides ? 0.2 : 0.45) * far * some_part();

    memset(c, 0, sizeof *c);
    c->from = (struct ray_light){.kind = sides ? TIA_RECTANGLE_LIGHT : TIA_SPHERE_LIGHT, .samples = SAMPLES};
    c->light = (struct sure_light){.from = &c->from, .radius = sides ? 0 : size, .place = places};
    for (int i = 0; i < 3; i++)
        c->light.at[i] = (double)at.v[i] * far;
    c->aim.axes[0] = v3_of(real_along((struct real){{0}}, a, sides ? size : 1));
    c->aim.axes[1] = v3_of(real_along((struct real){{0}}, b, sides ? size * some_part() : 1));
    for (int i = 0; i < SAMPLES; i++) {
        double turn = 7 * some_part(), radius = size * some_part();
        places[0][0][i] = sides ? random_double() : radius * cos(turn);
        places[0][1][i] = sides ? random_double() : radius * sin(turn);
    }
}

/* Sets the light as it is seen from a point near the origin. */
static inline void some_view(struct scenery *c)
{
    struct shade *h = &c->shade;
    struct real to = real_unit((struct real){{c->light.at[0], c->light.at[1], c->light.at[2]}});

    h->point = v3_scale(v3_of(real_random()), some_part() / 4);
    h->outside = h->point;
    h->normal = h->geometric = v3_of(real_unit(real_along(to, real_random(), 1.5L * (long double)some_part())));
    h->viewer = v3_of(real_random());
    h->facing = v3_dot(h->normal, h->viewer);
    h->ep = some_size(12, 30);
    h->eoutside = h->ep;
    h->en = h->eg = some_size(12, 30);
    h->efacing = h->en;
    h->glossy = 1;
    h->exponent = 1 + 60 * some_part();
    set_area(&c->light, &c->aim, h, &c->area);
}

/* The exact ray to a sample from an origin that is displaced by its error, towards the ball around `centre` or away
 * from it. */
struct exact_ray {
    struct real o, d;
    long double length;
};

static inline struct exact_ray ray_to(const struct scenery *c, int i, struct real centre, long double turn)
{
    struct exact_ray r = {.o = real_of(c->shade.outside)};
    struct real to = place_of(c, i), d = real_unit(real_along(to, r.o, -1)), l = real_along(centre, r.o, -1);
    struct real aside = real_along(l, d, -real_dot(l, d));

    if (real_dot(aside, aside) > 1e-12L)
        r.o = real_along(r.o, real_unit(aside), turn * c->shade.eoutside);
    r.d = real_along(to, r.o, -1);
    r.length = sqrtl(real_dot(r.d, r.d));
    r.d = real_unit(r.d);
    return r;
}

#endif
