#include "light.h"

static bool is_area(const struct tia_light *light)
{
    return light->kind == TIA_RECTANGLE_LIGHT || light->kind == TIA_DISC_LIGHT || light->kind == TIA_SPHERE_LIGHT;
}

unsigned light_samples(const struct tia_light *light)
{
    return !is_area(light) ? 1 : light->samples == 0 ? TIA_LIGHT_SAMPLES_DEFAULT : light->samples;
}

unsigned light_class(unsigned x, unsigned y)
{
    static const unsigned bayer[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};

    return bayer[y % 4][x % 4];
}

/* Returns 0, 1/2, 1/4, 3/4, ...: the binary digits of i in reverse order behind the point. */
static double radical_inverse(unsigned i)
{
    double sum = 0;

    for (double digit = 0.5; i > 0; i /= 2, digit /= 2)
        sum += i % 2 * digit;
    return sum;
}

void light_pattern(unsigned pixel_class, unsigned i, unsigned n, double *u, double *v)
{
    *u = fmod((i + 0.5) / n + pixel_class / 16.0, 1.0);
    *v = fmod(radical_inverse(i) + radical_inverse(pixel_class), 1.0);
}

static struct oracle_vec on_disc(struct oracle_vec centre, struct oracle_vec normal, double radius, double u, double v)
{
    struct oracle_vec a, b;

    axes(normal, &a, &b);
    struct oracle_vec p = along(centre, radius * sqrt(u) * cos(2.0 * PI * v), a);
    return along(p, radius * sqrt(u) * sin(2.0 * PI * v), b);
}

/* Returns the point of sample i on the light. */
static struct oracle_vec source(const struct tia_light *light, struct oracle_vec p, unsigned pixel_class, unsigned i)
{
    struct oracle_vec centre = position(light->centre);
    double u, v;

    light_pattern(pixel_class, i, light_samples(light), &u, &v);
    switch (light->kind) {
    case TIA_RECTANGLE_LIGHT:
        return along(along(centre, 2.0 * u - 1.0, position(light->side[0])), 2.0 * v - 1.0, position(light->side[1]));
    case TIA_DISC_LIGHT:
        return on_disc(centre, direction(light->direction), q16(light->radius), u, v);
    case TIA_SPHERE_LIGHT:
        return on_disc(centre, unit(sub(p, centre)), q16(light->radius), u, v);
    default:
        return centre;
    }
}

static double attenuation(const struct tia_light *light, double d)
{
    double sum = q16(light->constant) + q16(light->linear) * d + q16(light->quadratic) * d * d;

    if (light->constant == 0 && light->linear == 0 && light->quadratic == 0)
        return 1;
    return sum < 131072 ? 1 / sum : 0;
}

/* Returns a spot's falloff in the direction `way`, from the point to the light. */
static double spot(const struct tia_light *light, struct oracle_vec way)
{
    double a = -dot(way, direction(light->direction));
    double inner = cos(radians(light->inner)), outer = cos(radians(light->outer));

    return a >= inner ? 1.0 : a <= outer ? 0.0 : (a - outer) / (inner - outer);
}

bool light_beam(const struct tia_light *light, double unit, struct oracle_vec p, unsigned pixel_class, unsigned i,
                struct beam *beam)
{
    if (light->kind == TIA_DIRECTIONAL_LIGHT) {
        *beam =
            (struct beam){.direction = scaled(direction(light->direction), -1), .distance = INFINITY, .strength = 1};
        return true;
    }
    struct oracle_vec from = source(light, p, pixel_class, i), way = sub(from, p);
    double distance = length(way);
    if (!(distance > 0))
        return false;
    *beam = (struct beam){divide(way, distance), from, distance,
                          attenuation(light, distance / unit) / light_samples(light)};
    if (light->kind == TIA_SPOT_LIGHT)
        beam->strength *= spot(light, beam->direction);
    return true;
}

/* Intersects a parallelogram around the light's centre: p = s side[0] + t side[1] with |s|, |t| <= 1. */
static bool rectangle_hit(const struct tia_light *light, struct ray ray, struct hit *hit)
{
    struct oracle_vec a = position(light->side[0]), b = position(light->side[1]), n = cross(a, b);
    double square = dot(n, n);

    if (!(square > 0) || !shape_plane(ray, position(light->centre), unit(n), hit))
        return false;
    struct oracle_vec p = sub(at(ray, hit->t), position(light->centre));
    return fabs(dot(cross(p, b), n)) <= square && fabs(dot(cross(a, p), n)) <= square;
}

bool light_hit(const struct tia_light *light, struct ray ray, double *t)
{
    struct oracle_vec centre = position(light->centre);
    struct hit hit;
    bool met = false;

    if (light->kind == TIA_RECTANGLE_LIGHT)
        met = rectangle_hit(light, ray, &hit);
    else if (light->kind == TIA_DISC_LIGHT && light->radius > 0)
        met = shape_disc(ray, centre, direction(light->direction), q16(light->radius), &hit);
    else if ((light->kind == TIA_POINT_LIGHT || light->kind == TIA_SPHERE_LIGHT) && light->radius > 0)
        met = shape_sphere(ray, centre, q16(light->radius), &hit);
    *t = met ? hit.t : INFINITY;
    return met;
}
