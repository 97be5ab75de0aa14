#include "ray_light.h"

#include "math/integer.h"
#include "math/rotation.h"
#include "rgb.h"

/* ---- shapes ---- */

static num_unit cosine(tia_q16 degrees)
{
    int64_t s, c;

    tia_sincos(degrees, &s, &c);
    return num_unit_of_q62(c);
}

static void prepare_rectangle(struct ray_light *l, const struct tia_light *given)
{
    struct num_dir along[2], normal;

    for (int i = 0; i < 2; i++) {
        l->side[i] = num_point_of(given->side[i]);
        (void)num_normalise(l->side[i], &along[i]);
    }
    normal = num_dir_normalised(num_dir_cross(along[0], along[1]));
    l->direction = normal;
    l->across[0] = num_dir_cross(along[1], normal);
    l->across[1] = num_dir_cross(normal, along[0]);
}

static void prepare_centre(struct ray_light *l, const struct tia_light *given)
{
    (void)l;
    (void)given;
}

static void prepare_direction(struct ray_light *l, const struct tia_light *given)
{
    l->direction = num_dir_of(given->direction);
}

static void prepare_cone(struct ray_light *l, const struct tia_light *given)
{
    prepare_direction(l, given);
    l->inner = cosine(given->inner);
    l->outer = cosine(given->outer);
}

static void prepare_disc(struct ray_light *l, const struct tia_light *given)
{
    prepare_direction(l, given);
    shape_axes(l->direction, l->axes);
}

/* Returns the four bits of i in reverse order. */
static unsigned mirrored(unsigned i)
{
    static const uint8_t mirror[16] = {0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15};

    return mirror[i];
}

/* Returns sin(2 pi v/256). */
static num_unit sine(unsigned v)
{
    unsigned place = v & 63;
    num_unit s = num_unit_of_q62(tia_sines[v & 64 ? 64 - place : place]);

    return v & 128 ? -s : s;
}

unsigned ray_pixel_class(int x, int y)
{
    static const uint8_t bayer[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};

    return bayer[y & 3][x & 3];
}

/* Computes the coordinates of sample i of n. u = frac((i + 1/2)/n + class/16), computed in integers, so that the
 * fraction of a whole number is exactly 0. v is in units of 1/256. */
static void pattern(const struct ray_light *l, unsigned class, unsigned i, num_unit *u, unsigned *v)
{
    unsigned n = l->samples;

    *u = l->part * (num_unit)((32 * i + 16 + 2 * n * class) % (32 * n));
    *v = (16 * mirrored(i & 15) + mirrored(i >> 4) + 16 * mirrored(class)) & 255;
}

static struct num_point at_centre(const struct ray_aim *aim, num_unit u, unsigned v)
{
    (void)u;
    (void)v;
    return aim->light->centre;
}

/* Returns a point of the disc around the centre, with the aim's axes. */
static struct num_point on_disc(const struct ray_aim *aim, num_unit u, unsigned v)
{
    num_length r = num_times(aim->light->radius, num_unit_sqrt(u));
    struct num_point a = num_point_along(aim->axes[0], num_times(r, sine(v + 64)));
    struct num_point b = num_point_along(aim->axes[1], num_times(r, sine(v)));

    return num_point_add(aim->light->centre, num_point_add(a, b));
}

static struct num_point scaled(struct num_point p, num_unit s)
{
    return (struct num_point){num_times(p.x, s), num_times(p.y, s), num_times(p.z, s)};
}

struct num_point ray_light_rectangle_point(const struct ray_light *l, num_unit s, num_unit t)
{
    return num_point_add(l->centre, num_point_add(scaled(l->side[0], s), scaled(l->side[1], t)));
}

static struct num_point on_rectangle(const struct ray_aim *aim, num_unit u, unsigned v)
{
    return ray_light_rectangle_point(aim->light, 2 * (u - NUM_UNIT_ONE / 2),
                                     NUM_UNIT_ONE / 128 * (num_unit)((int)v - 128));
}

/* Computes where a ray meets the plane of a rectangle or disc: the distance, and the point relative to the centre.
 * Returns false if they do not meet at 0 <= t < limit. */
static bool meets_plane(const struct ray_light *l, const struct ray *ray, num_length limit, num_length *t,
                        struct num_point *from_centre)
{
    struct num_point way = num_point_sub(l->centre, ray->origin);
    num_unit slope = num_dir_dot(ray->direction, l->direction);

    if (slope > -NUM_UNIT_LEAST && slope < NUM_UNIT_LEAST)
        return false;
    *t = num_div(num_point_dot(way, l->direction), slope);
    if (*t < 0 || *t >= limit)
        return false;
    *from_centre = num_point_sub(num_point_along(ray->direction, *t), way);
    return true;
}

static bool is_within(struct num_point p, struct num_point side, struct num_dir across)
{
    num_length at = num_point_dot(p, across), reach = num_point_dot(side, across);

    at = at < 0 ? -at : at;
    return at <= (reach < 0 ? -reach : reach);
}

static bool meets_nothing(const struct ray_light *l, const struct ray *ray, num_length limit, num_length *t)
{
    (void)l;
    (void)ray;
    (void)limit;
    (void)t;
    return false;
}

static bool meets_ball(const struct ray_light *l, const struct ray *ray, num_length limit, num_length *t)
{
    return l->radius > 0 && sphere_intersect(l->centre, l->radius, ray, limit, t) && *t < limit;
}

static bool meets_disc(const struct ray_light *l, const struct ray *ray, num_length limit, num_length *t)
{
    struct num_point p;

    return l->radius > 0 && meets_plane(l, ray, limit, t, &p) && num_norm(p) <= l->radius;
}

static bool meets_rectangle(const struct ray_light *l, const struct ray *ray, num_length limit, num_length *t)
{
    struct num_point p;

    return meets_plane(l, ray, limit, t, &p) && is_within(p, l->side[0], l->across[0]) &&
           is_within(p, l->side[1], l->across[1]);
}

/* ---- the kinds ---- */

struct light_kind {
    void (*prepare)(struct ray_light *l, const struct tia_light *given);
    /* returns the point of a sample */
    struct num_point (*place)(const struct ray_aim *aim, num_unit u, unsigned v);
    bool (*meets)(const struct ray_light *l, const struct ray *ray, num_length limit, num_length *t);
};

/* A row for each kind of TIA_LIGHTS. */
#define LIGHT(name, prepare, place, meets) static const struct light_kind name##_light = {prepare, place, meets}
LIGHT(point, prepare_centre, at_centre, meets_ball);
LIGHT(directional, prepare_direction, at_centre, meets_nothing);
LIGHT(ambient, prepare_centre, at_centre, meets_nothing);
LIGHT(spot, prepare_cone, at_centre, meets_nothing);
LIGHT(rectangle, prepare_rectangle, on_rectangle, meets_rectangle);
LIGHT(disc, prepare_disc, on_disc, meets_disc);
LIGHT(sphere, prepare_centre, on_disc, meets_ball);

static void prepare_shape(struct ray_light *l, const struct tia_light *given)
{
#define PREPARE(KIND, name, what, traits)                                                                              \
    case KIND:                                                                                                         \
        name##_light.prepare(l, given);                                                                                \
        break;
    switch (l->kind) {
        TIA_LIGHTS(PREPARE)
    }
}

/* Returns the point of sample i. */
static struct num_point source(const struct ray_aim *aim, unsigned i)
{
    const struct ray_light *l = aim->light;
    num_unit u = 0;
    unsigned v = 0;

    if (tia_light_has(l->kind, TIA_LIGHT_AREA))
        pattern(l, aim->class, i, &u, &v);
#define PLACE(KIND, name, what, traits)                                                                                \
    case KIND:                                                                                                         \
        return name##_light.place(aim, u, v);
    switch (l->kind) {
        TIA_LIGHTS(PLACE)
    }
    return l->centre;
}

bool ray_light_intersect(const struct ray_light *l, const struct ray *ray, num_length limit, num_length *t)
{
#define MEETS(KIND, name, what, traits)                                                                                \
    case KIND:                                                                                                         \
        return name##_light.meets(l, ray, limit, t);
    switch (l->kind) {
        TIA_LIGHTS(MEETS)
    }
    return false;
}

bool ray_light_is_seen(const struct ray_light *l)
{
    return tia_light_has(l->kind, TIA_LIGHT_SURFACE) && (!tia_light_has(l->kind, TIA_LIGHT_RADIUS) || l->radius > 0);
}

/* ---- light ---- */

void ray_light_prepare(struct ray_light *l, const struct tia_light *given, int scale_bits)
{
    bool sampled = tia_light_has(given->kind, TIA_LIGHT_SAMPLED);

    l->kind = given->kind;
    l->samples = !sampled ? 1 : given->samples ? given->samples : TIA_LIGHT_SAMPLES_DEFAULT;
    l->part = num_fraction(NUM_LENGTH_ONE, num_integer((int32_t)(32 * l->samples)));
    ray_rgb(&given->emission, l->emission);
    l->centre = num_point_of(given->centre);
    l->radius = num_length_of(given->radius);
    l->constant = num_length_of(given->constant);
    l->linear = num_length_of(given->linear);
    l->quadratic = num_length_of(given->quadratic);
    l->fades =
        !tia_light_has(given->kind, TIA_LIGHT_PLACELESS) && (given->constant || given->linear || given->quadratic);
    l->unit = l->fades ? num_scene_unit(scale_bits + given->unit_bits) : NUM_UNIT_ONE;
    prepare_shape(l, given);
}

void ray_light_aim(struct ray_aim *aim, const struct ray_light *l, struct num_point point, struct num_dir normal,
                   unsigned class)
{
    struct num_dir from;

    aim->light = l;
    aim->point = point;
    aim->normal = normal;
    aim->class = class;
    aim->axes[0] = l->axes[0];
    aim->axes[1] = l->axes[1];
    if (ray_light_turns(l)) {
        if (!num_normalise(num_point_sub(point, l->centre), &from))
            from = (struct num_dir){NUM_UNIT_ONE, 0, 0};
        shape_axes(from, aim->axes);
    }
}

/* Returns 1/(constant + linear d + quadratic d^2), or 0 if the sum is 2^17 or more; d is in the attenuation's unit of
 * length. */
static num_length attenuation(const struct ray_light *l, num_length d)
{
    num_length slope = l->linear + num_product_within(l->quadratic, d);
    num_length sum = l->constant + num_product_within(slope < NUM_LENGTH_MAX ? slope : NUM_LENGTH_MAX, d);

    return sum < NUM_LENGTH_MAX ? num_ratio(NUM_LENGTH_ONE, sum) : 0;
}

/* Returns a spot light's falloff, 0..1, at a point from which the light is in the direction `to`. */
static num_length spot(const struct ray_light *l, struct num_dir to)
{
    num_unit c = -num_dir_dot(to, l->direction);

    if (c >= l->inner)
        return NUM_LENGTH_ONE;
    return c <= l->outer ? 0 : num_length_of_unit(num_fraction(c - l->outer, l->inner - l->outer));
}

/* True if N.L is certainly below 0, L being the rounded direction of `way`. The rounding, 2^-57, changes the product of
 * N and `way` by less than 2^-37. */
static bool is_behind(const struct ray_aim *aim, struct num_point way)
{
    return num_point_dot(way, aim->normal) < -NUM_LENGTH_ONE / 1073741824;
}

bool ray_light_sample(const struct ray_aim *aim, unsigned i, struct ray_sample *s)
{
    const struct ray_light *l = aim->light;

    if (tia_light_has(l->kind, TIA_LIGHT_FAR)) {
        s->to = num_dir_negated(l->direction);
        s->factor = NUM_LENGTH_ONE;
        return true;
    }
    s->source = source(aim, i);
    struct num_point way = num_point_sub(s->source, aim->point);
    if (is_behind(aim, way) || !num_normalise(way, &s->to))
        return false;
    s->factor = tia_light_has(l->kind, TIA_LIGHT_CONE) ? spot(l, s->to) : NUM_LENGTH_ONE;
    if (s->factor > 0 && l->fades)
        s->factor = num_product_within(s->factor, attenuation(l, num_times(num_point_dot(way, s->to), l->unit)));
    return s->factor > 0;
}

bool ray_light_shadow(const struct ray_light *l, const struct ray_sample *s, struct num_point from, struct ray *shadow,
                      num_length *distance)
{
    shadow->origin = from;
    ray_watch(shadow, NULL);
    shadow->direction = s->to;
    *distance = NUM_LENGTH_MAX;
    if (tia_light_has(l->kind, TIA_LIGHT_FAR))
        return true;
    struct num_point way = num_point_sub(s->source, from);
    if (!num_normalise(way, &shadow->direction))
        return false;
    *distance = num_point_dot(way, shadow->direction);
    return true;
}
