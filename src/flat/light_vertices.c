#include "light_vertices.h"

#include "math/wide.h"

unsigned tia_flat_light_samples(const struct tia_light *light)
{
    if (tia_light_has(light->kind, TIA_LIGHT_EVERYWHERE))
        return 0;
    if (!tia_light_has(light->kind, TIA_LIGHT_SIDES | TIA_LIGHT_DISC))
        return 1;
    return light->samples ? light->samples : TIA_LIGHT_SAMPLES_DEFAULT;
}

/* Returns the lower eight bits of i in reverse order. */
static unsigned mirrored(unsigned i)
{
    unsigned out = 0;

    for (int bit = 0; bit < 8; bit++)
        out |= (i >> bit & 1) << (7 - bit);
    return out;
}

/* Returns numerator/n as Q.48, rounded to nearest; below 2^48 in magnitude. */
static int64_t fraction(int numerator, unsigned n)
{
    int64_t a = (int64_t)(numerator < 0 ? -numerator : numerator) * (INT64_C(2) << 48);
    int64_t q = (a / n + 1) / 2;

    return numerator < 0 ? -q : q;
}

/* Moves `at` from the centre by s side[0] + t side[1], with s = (2i + 1 - n)/n and t = 2 v - 1, v being the radical
 * inverse of i: see light.h. */
static void on_rectangle(const struct tia_light *light, unsigned i, int64_t at[3])
{
    const tia_q16 a[3] = {light->side[0].x, light->side[0].y, light->side[0].z};
    const tia_q16 b[3] = {light->side[1].x, light->side[1].y, light->side[1].z};
    unsigned n = tia_flat_light_samples(light);
    int64_t s = fraction(2 * (int)i + 1 - (int)n, n), t = ((int64_t)mirrored(i) - 128) * (INT64_C(1) << 41);

    for (int k = 0; k < 3; k++)
        at[k] += wide_round(wide_sum(wide_product(a[k], s), wide_product(b[k], t)), 32);
}

/* Moves `at` from a disc's centre by the distance radius sqrt(u), u = (2i + 1)/(2n), in the direction at the angle of v
 * full turns, v as for a rectangle. */
static void on_disc(const struct tia_light *light, unsigned i, int64_t at[3])
{
    const int64_t given[3] = {light->direction.x, light->direction.y, light->direction.z};
    int64_t normal[3], across[2][3], d[3];
    int64_t u = fraction(2 * (int)i + 1, 2 * tia_flat_light_samples(light));
    int64_t reach = wide_round(wide_product(light->radius, wide_sqrt(wide_up(wide_product(u, 1), 48))), 16);

    (void)wide_normalise(given, normal);
    tia_eye_across(normal, across);
    tia_eye_around(across[0], across[1], (tia_q16)mirrored(i) * (TIA_Q16(360) / 256), d);
    for (int k = 0; k < 3; k++)
        at[k] += wide_round(wide_product(d[k], reach), 78);
}

static void from_direction(const struct tia_flat_scene *flat, const int64_t given[3], tia_flat_light *out)
{
    int64_t d[3];

    (void)wide_normalise(given, d);
    tia_eye_direction(&flat->eye, d, flat->bits, out);
}

static void from_point(const struct tia_flat_scene *flat, const struct tia_light *light, int64_t at[3],
                       tia_flat_light *out)
{
    const struct tia_reach reach = tia_flat_reach(flat);

    if (!tia_reach_is_direction(&reach, light)) {
        tia_eye_point(&flat->eye, at, flat->grid.fraction, out);
        return;
    }
    for (int k = 0; k < 3; k++)
        at[k] -= flat->eye.origin[k];
    from_direction(flat, at, out);
}

static void centre(const struct tia_light *light, int64_t at[3])
{
    at[0] = light->centre.x * (INT64_C(1) << 16);
    at[1] = light->centre.y * (INT64_C(1) << 16);
    at[2] = light->centre.z * (INT64_C(1) << 16);
}

void tia_flat_light_centre(const struct tia_flat_scene *flat, const struct tia_light *light, tia_flat_light *out)
{
    const int64_t back[3] = {-(int64_t)light->direction.x, -(int64_t)light->direction.y, -(int64_t)light->direction.z};
    int64_t at[3];

    centre(light, at);
    if (tia_light_has(light->kind, TIA_LIGHT_FAR))
        from_direction(flat, back, out);
    else
        from_point(flat, light, at, out);
}

void tia_flat_light_at(const struct tia_flat_scene *flat, const struct tia_light *light, unsigned i,
                       tia_flat_light *out)
{
    int64_t at[3];

    if (!tia_light_has(light->kind, TIA_LIGHT_SIDES | TIA_LIGHT_DISC)) {
        tia_flat_light_centre(flat, light, out);
        return;
    }
    centre(light, at);
    if (tia_light_has(light->kind, TIA_LIGHT_SIDES))
        on_rectangle(light, i, at);
    else
        on_disc(light, i, at);
    from_point(flat, light, at, out);
}
