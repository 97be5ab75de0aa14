/* pixel.c - lights and colours of the definition, computed with balls. ray.h has its rays and explains the formulas. */
#include "pixel.h"

#include "ray.h"

#define BIAS (-13)
#define HALF (INT32_C(1) << 29)

/* ---- light ---- */

/* Sets n of the visible point on `body`. Each light computes it again, since balls are large. */
static void set_normal(struct pixel *p, const struct body *body, struct ball n[3])
{
    scaled(p, n, body->centre, &p->square);
    each(tia_ball_sub, p, n, p->inside ? n : p->point, p->inside ? p->point : n, 1);
}

/* Sets the visible point, at T, and what depends on it. Where T is 0, so is P, and 1 takes the place of V, which need
 * not be rational. */
static void set_point(struct pixel *p, const struct body *body, const struct ball *t)
{
    struct ball bias[3];

    if (!t->sign && !t->radius.m)
        tia_ball_set(p->n, &p->square, 1, 0);
    multiply_length(p, &p->scale, body->radius, &p->square);
    each(tia_ball_mul, p, p->point, p->v, t, 0);
    set_normal(p, body, bias);
    for (int i = 0; i < 3; i++) {
        bias[i].e += BIAS;
        bias[i].radius.e += BIAS;
    }
    for (int i = 0; i < 3; i++)
        multiply_length(p, &p->start[i], body->radius, &p->point[i]);
    each(tia_ball_add, p, p->start, p->start, bias, 1);
}

/* The ray from the visible point to a light. */
struct way {
    struct body light;        /* Q */
    struct ball m[3], square; /* m, M */
    struct ball reach;        /* r M */
    uint32_t passed;          /* sum of (j + 1) over the balls j that filter the light */
};

/* True if the caster blocks the light. `own`: the caster is the visible sphere. */
static bool blocks(struct pixel *p, const struct body *caster, bool own, const struct way *way)
{
    int n = p->n;
    struct ball g[3], a, h;
    bool inside = side_of(p, caster->centre, caster->radius) == BALL_BELOW;
    int64_t d[3];

    if (own && !inside)
        return false;
    for (int i = 0; i < 3; i++)
        d[i] = caster->centre[i] - way->light.centre[i];
    if (inside)
        return side_of(p, d, caster->radius) == BALL_ABOVE;
    scaled(p, g, caster->centre, &p->scale);
    each(tia_ball_sub, p, g, g, p->start, 1);
    dot(p, &a, g, way->m);
    if (sign_of(p, &a) != BALL_ABOVE ||
        (compare(p, &way->reach, &a) != BALL_ABOVE && side_of(p, d, caster->radius) == BALL_ABOVE))
        return false;
    dot(p, &h, g, g);
    multiply_length(p, g, caster->radius, &p->scale);
    tia_ball_mul(n, g, g, g);
    tia_ball_sub(n, &h, &h, g);
    tia_ball_mul(n, &h, &h, &way->square);
    tia_ball_mul(n, &a, &a, &a);
    return compare(p, &a, &h) != BALL_BELOW;
}

static void set_colour(const struct pixel *p, struct ball r[3], struct tia_rgb colour)
{
    int64_t channels[3] = {colour.r, colour.g, colour.b};

    set_each(p, r, channels, CHANNEL);
}

static void multiply(const struct pixel *p, struct ball product[3], struct tia_rgb colour)
{
    struct ball factor[3];

    set_colour(p, factor, colour);
    each(tia_ball_mul, p, product, product, factor, 1);
}

static bool is_black(const struct ball product[3])
{
    return !product[0].sign && !product[1].sign && !product[2].sign;
}

static uint32_t next_caster(const struct pixel *p, uint32_t l, uint32_t from)
{
    return p->picture->next_caster ? p->picture->next_caster(p->picture->lit, l, from) : from;
}

/* Multiplies light l by the transmissions of all balls that block it. */
static void cast_shadows(struct pixel *p, uint32_t object, uint32_t l, struct way *way, struct ball product[3])
{
    const struct tia_scene *scene = p->picture->scene;

    for (uint32_t j = next_caster(p, l, 0); j < scene->sphere_count && !p->open && !is_black(product);
         j = next_caster(p, l, j + 1)) {
        struct body caster = body_of(p->picture, j);
        if (!blocks(p, &caster, j == object, way))
            continue;
        multiply(p, product, scene->materials[scene->spheres[j].material].transmission);
        way->passed += j + 1;
    }
}

/* True if the product of two colours is black. */
static bool is_lost(struct tia_rgb a, struct tia_rgb b)
{
    return (!a.r || !b.r) && (!a.g || !b.g) && (!a.b || !b.b);
}

/* Adds light l to the path hash, as one that reaches the point. */
static void note_reached(struct pixel *p, uint32_t l, uint32_t passed)
{
    if (l < 16)
        p->path_hash = (p->path_hash + (passed * (l + 1) << 16)) | UINT32_C(1) << l;
}

/* Adds light l to the colour of sphere `object`. */
static void add_light(struct pixel *p, uint32_t object, uint32_t l)
{
    const struct tia_scene *scene = p->picture->scene;
    const struct tia_sphere *sphere = &scene->spheres[object];
    const struct tia_light *light = &p->picture->lights[l];
    struct tia_rgb colour = scene->materials[sphere->material].colour, white = {TIA_Q30_ONE, TIA_Q30_ONE, TIA_Q30_ONE};
    struct body body = body_of(p->picture, object);
    struct way way;
    struct ball lambert, product[3];
    int n = p->n;

    way.light = body_of(p->picture, scene->sphere_count + l);
    scaled(p, way.m, way.light.centre, &p->square);
    each(tia_ball_sub, p, way.m, way.m, p->point, 1);
    set_normal(p, &body, product);
    dot(p, &lambert, product, way.m);
    way.passed = 0;
    if ((is_lost(colour, light->emission) && !p->traces) || sign_of(p, &lambert) != BALL_ABOVE)
        return;
    dot(p, &way.square, way.m, way.m);
    multiply_length(p, &way.reach, sphere->radius, &way.square);
    set_colour(p, product, white);
    cast_shadows(p, object, l, &way, product);
    if (p->open || is_black(product))
        return;
    note_reached(p, l, way.passed);
    multiply(p, product, colour);
    multiply(p, product, light->emission);
    tia_ball_sqrt(n, &way.square, &way.square);
    tia_ball_mul(n, &way.square, &way.square, &p->scale);
    tia_ball_div(n, &lambert, &lambert, &way.square);
    each(tia_ball_mul, p, product, product, &lambert, 0);
    each(tia_ball_add, p, p->sum, p->sum, product, 1);
}

/* ---- pixels ---- */

/* Returns floor(levels min(1, channel) + threshold). Where it is open whether the channel is above 1, it is so near to
 * 1 that both give the last level, as the threshold is from 1/128 to 127/128. */
static unsigned quantise(struct pixel *p, const struct ball *channel, int32_t levels, tia_q30 threshold)
{
    struct ball y, q;

    tia_ball_set(p->n, &y, 1, 0);
    tia_ball_sub(p->n, &q, channel, &y);
    if (tia_ball_sign(p->n, &q) != BALL_ABOVE)
        y = *channel;
    tia_ball_set(p->n, &q, levels, 0);
    tia_ball_mul(p->n, &y, &y, &q);
    tia_ball_set(p->n, &q, threshold, CHANNEL);
    tia_ball_add(p->n, &y, &y, &q);
    int32_t most = tia_ball_floor(p->n, &y) + 1, level = most - 2;
    for (bool below = false; level < most && !below; level += !below) {
        tia_ball_set(p->n, &q, level + 1, 0);
        below = compare(p, &y, &q) == BALL_BELOW;
    }
    return (unsigned)level;
}

/* Returns the colour `flat` plus, unless `object` is NULL, the light that this sphere reflects. */
static tia_rgb565 colour_of(struct pixel *p, struct tia_rgb flat, const uint32_t *object, tia_q30 threshold)
{
    set_colour(p, p->sum, flat);
    for (uint32_t l = 0; object && l < p->picture->light_count && !p->open; l++)
        add_light(p, *object, l);
    if (p->open)
        return 0;
    unsigned r = quantise(p, &p->sum[0], 31, threshold), g = quantise(p, &p->sum[1], 63, threshold);
    return (tia_rgb565)(r << 11 | g << 5 | quantise(p, &p->sum[2], 31, threshold));
}

/* Returns the pixel where sphere `object` is visible. */
static tia_rgb565 shade(struct pixel *p, uint32_t object, tia_q30 threshold)
{
    const struct tia_scene *scene = p->picture->scene;
    struct body body = body_of(p->picture, object);
    struct ball t;

    if (!meet(p, &body, &t)) { /* it is met, as another precision or stage has found */
        p->open = true;
        return 0;
    }
    set_point(p, &body, &t);
    return colour_of(p, scene->materials[scene->spheres[object].material].emission, &object, threshold);
}

/* Returns the index of the visible ball, lights after spheres; the number of all balls if none is visible. */
static uint32_t find_visible(struct pixel *p)
{
    const struct exact_picture *picture = p->picture;
    uint32_t count = picture->scene->sphere_count + picture->light_count, visible = count;
    struct body nearest_body = {.radius = 0};
    struct ball nearest, t;

    for (uint32_t i = 0; i < count && !p->open; i++) {
        struct body body = body_of(picture, i);
        if (!body.radius || !meet(p, &body, &t) ||
            (visible < count && (are_equally_far(p, &body, &nearest_body) || compare(p, &t, &nearest) != BALL_BELOW)))
            continue;
        nearest = t;
        nearest_body = body;
        visible = i;
    }
    return visible;
}

static tia_rgb565 pixel_of(struct pixel *p, tia_q30 threshold)
{
    const struct exact_picture *picture = p->picture;
    uint32_t visible = find_visible(p), spheres = picture->scene->sphere_count;

    if (p->open)
        return 0;
    if (visible < spheres)
        return shade(p, visible, threshold);
    return colour_of(p,
                     visible < spheres + picture->light_count ? picture->lights[visible - spheres].emission
                                                              : picture->scene->background,
                     NULL, threshold);
}

static bool nearer(struct pixel *p, uint32_t i, uint32_t j)
{
    struct body a = body_of(p->picture, i), b = body_of(p->picture, j);
    struct ball t, u;

    if (are_equally_far(p, &a, &b))
        return false;
    return meet(p, &a, &t) && (!meet(p, &b, &u) || compare(p, &t, &u) == BALL_BELOW);
}

/* Prepares the next precision; the first one if n is 0. False if nothing is open or there is no further precision. */
static bool go_on(struct pixel *p, const struct exact_picture *picture, int x, int y)
{
    if (p->n && (!p->open || p->n == TIA_BALL_WORDS))
        return false;
    p->n = p->n ? 2 * p->n : 2;
    look(p, picture, x, y);
    return true;
}

tia_rgb565 tia_exact_pixel(const struct exact_picture *picture, int x, int y, tia_q30 threshold,
                           struct exact_cost *cost)
{
    struct pixel p;
    tia_rgb565 pixel = 0;

    for (p.n = 0, p.traces = false; go_on(&p, picture, x, y);)
        pixel = pixel_of(&p, threshold);
    if (cost) {
        cost->words = cost->words < p.n ? p.n : cost->words;
        cost->tie = cost->tie || p.tie;
    }
    return pixel;
}

tia_rgb565 tia_exact_shade(const struct exact_picture *picture, int x, int y, uint32_t object, tia_q30 threshold,
                           uint16_t *colours, uint32_t *path_hash)
{
    struct pixel p;
    tia_rgb565 pixel = 0;

    for (p.n = 0, p.traces = path_hash != NULL; go_on(&p, picture, x, y);) {
        pixel = shade(&p, object, threshold);
        for (int c = 0; colours && !p.open && c < 3; c++)
            colours[c] = (uint16_t)quantise(&p, &p.sum[c], 65535, HALF);
        if (path_hash)
            *path_hash = p.path_hash;
    }
    return pixel;
}

bool tia_exact_meets(const struct exact_picture *picture, int x, int y, uint32_t object)
{
    struct body body = body_of(picture, object);
    struct pixel p;
    bool met = false;

    for (p.n = 0, p.traces = false; go_on(&p, picture, x, y);)
        met = meet(&p, &body, NULL);
    return met;
}

bool tia_exact_nearer(const struct exact_picture *picture, int x, int y, uint32_t i, uint32_t j)
{
    struct pixel p;
    bool near = false;

    for (p.n = 0, p.traces = false; go_on(&p, picture, x, y);)
        near = nearer(&p, i, j);
    return near;
}
