#include "pair.h"

#include <math.h>

#include "bound_table.h"
#include "math/wide.h"
#include "row.h"
#include "scene/colour.h"

static double length(struct num_vec a)
{
    double x = (double)a.x, y = (double)a.y, z = (double)a.z;

    return sqrt(x * x + y * y + z * z) * 0x1p-16;
}

size_t tia_simd_pairs_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    uint64_t pairs = (uint64_t)scene->sphere_count * light_capacity;
    const size_t each = sizeof(struct simd_lamp) + SIMD_CASTS_KEPT * sizeof(struct simd_caster);

    return pairs > SIZE_MAX / 2 / each ? SIZE_MAX : (size_t)pairs * each;
}

static double dot(struct num_vec a, struct num_vec b)
{
    return ((double)a.x * (double)b.x + (double)a.y * (double)b.y + (double)a.z * (double)b.z) * 0x1p-32;
}

/* Sets k's constant and the bound of its rounding. */
static void cast_power(const struct span_sphere *sphere, const struct simd_lamp *lamp, const struct span_sphere *caster,
                       struct simd_caster *cast)
{
    struct num_vec between = num_vec_sub(sphere->centre, caster->centre);
    double r = (double)sphere->radius * 0x1p-16, radius = (double)caster->radius * 0x1p-16;
    double away = dot(between, between), share = lamp->share, c = (double)caster->c * 0x1p-32;

    cast->p0 = c - (away - r * r - radius * radius - SIMD_BIAS * r) * share;
    cast->fixed = BOUND_OF(SPAN_POWER_PARTS,
                           BOUND(SPAN_PARTS) * (fabs(c) + (away + r * (r + SIMD_BIAS) + radius * radius) * share));
}

/* True if the caster is behind all points of the sphere L as seen from the light, so that it shadows nothing. With D =
 * C
 * - L, G = Q - L and P = L + r N,
 *
 *     A.w = (D - r N).(G - r N) <= D.G + r |D + G| + r^2 <= 0,
 *
 * and A'.w is less than A.w where N.w > 0. */
static bool is_behind(const struct span_sphere *sphere, const struct simd_lamp *lamp, const struct span_sphere *caster)
{
    struct num_vec d = num_vec_sub(caster->centre, sphere->centre);
    double r = (double)sphere->radius * 0x1p-16, above = r * (length(num_vec_add(d, lamp->g)) + r),
           below = dot(d, lamp->g);

    return below + above < -BOUND_OF(SPAN_BACK, BOUND(SPAN_PARTS) * (length(d) * lamp->reach + above));
}

bool tia_simd_encloses(const struct span_sphere *caster, struct num_vec light)
{
    struct num_vec d = num_vec_sub(caster->centre, light);
    int64_t from[3] = {d.x, d.y, d.z};

    return wide_sign(wide_difference(wide_dot(from, from), wide_product(caster->radius, caster->radius))) <= 0;
}

/* Returns the square of the distance of two points. */
static double square_between(struct num_vec a, struct num_vec b)
{
    struct num_vec d = num_vec_sub(a, b);

    return dot(d, d);
}

/* The caster is between the light and all points of the sphere L: each shadow ray ends in the caster, as |C - Q| + bias
 * < R, and begins outside of it, as |C - L| > R + r + bias. */
bool tia_simd_is_shade(const struct tia_view *view, uint32_t n, uint32_t j, const struct simd_lamp *lamp)
{
    const struct span_sphere *sphere = &span_view_of(view)->spheres[n], *caster = &span_view_of(view)->spheres[j];
    double r = (double)sphere->radius * 0x1p-16, radius = (double)caster->radius * 0x1p-16;

    if (square_between(caster->centre, lamp->light) >= radius * radius)
        return false;
    double in = length(num_vec_sub(caster->centre, lamp->light)) + SIMD_BIAS;
    double out = length(num_vec_sub(caster->centre, sphere->centre)) - SIMD_BIAS;
    double off = BOUND_OF(SPAN_SHADE, BOUND(SPAN_PARTS) * (out + radius + r));
    return in < radius - off && out > radius + r + off;
}

void tia_simd_caster(const struct tia_view *view, uint32_t n, uint32_t j, const struct simd_lamp *lamp,
                     struct simd_caster *cast)
{
    const struct span_sphere *sphere = &span_view_of(view)->spheres[n], *caster = &span_view_of(view)->spheres[j];
    const struct tia_rgb *through = &view->scene->materials[view->scene->spheres[j].material].transmission;

    cast->sphere = (uint8_t)j;
    cast->size = length(caster->centre);
    cast->aq = (double)num_dot(caster->centre, lamp->light) * 0x1p-32 - lamp->swell * lamp->k;
    cast->radius = (double)caster->radius * 0x1p-16;
    cast->apart = length(num_vec_sub(caster->centre, lamp->light));
    cast_power(sphere, lamp, caster, cast);
    cast->clear = !colour_is_black(through);
    cast->encloses = cast->apart < 2 * cast->radius && tia_simd_encloses(caster, lamp->light);
}

static void light_constants(const struct span_sphere *sphere, struct num_vec light, struct simd_lamp *lamp)
{
    double r = (double)sphere->radius * 0x1p-16;

    lamp->light = light;
    lamp->g = num_vec_sub(light, sphere->centre);
    lamp->k = (double)(sphere->c - num_dot(sphere->centre, light)) * 0x1p-32;
    lamp->qq = (double)num_dot(light, light) * 0x1p-32;
    lamp->size = sqrt(lamp->qq);
    lamp->reach = length(lamp->g);
    lamp->gap = fabs(lamp->reach - r) - (lamp->reach + r) * BOUND(SPAN_GAP);
    lamp->per_r = 1 / r;
    lamp->swell = SIMD_BIAS / r;
    lamp->share = SIMD_BIAS / (r + SIMD_BIAS);
}

/* Adds a sphere to the casters or to the shades. One more caster than are kept makes the lamp `plain`. */
static void add_caster(const struct tia_view *view, uint32_t n, uint32_t j, struct simd_lamp *lamp)
{
    const struct span_sphere *spheres = span_view_of(view)->spheres;

    if (tia_simd_is_shade(view, n, j, lamp)) {
        double left[3];
        simd_channels(&view->scene->materials[view->scene->spheres[j].material].transmission, left);
        for (int c = 0; c < 3; c++)
            lamp->colour[c] *= left[c];
        lamp->shades++;
    } else if (!lamp->plain && !is_behind(&spheres[n], lamp, &spheres[j])) {
        lamp->plain = lamp->casts == SIMD_CASTS_KEPT;
        if (!lamp->plain)
            tia_simd_caster(view, n, j, lamp, &lamp->cast[lamp->casts++]);
    }
}

static void prepare_lamp(const struct tia_view *view, uint32_t n, uint32_t l, struct simd_lamp *lamp)
{
    const struct span_sphere *sphere = &span_view_of(view)->spheres[n];
    const struct span_lit lit = {.casters = &span_view_of(view)->casters, .object = n};
    double emission[3], colour[3];

    lamp->casts = lamp->shades = 0;
    lamp->plain = sphere->radius == 0 || sphere->c <= 0;
    if (lamp->plain)
        return;
    light_constants(sphere, num_vec_between(view->scene->camera.eye, view->lights[l].centre), lamp);
    simd_channels(&view->scene->materials[view->scene->spheres[n].material].colour, colour);
    simd_channels(&view->lights[l].emission, emission);
    for (int c = 0; c < 3; c++)
        lamp->colour[c] = colour[c] * emission[c];
    for (uint32_t j = span_next_caster(&lit, l, 0); j < view->scene->sphere_count && !simd_is_black(lamp->colour);
         j = span_next_caster(&lit, l, j + 1))
        add_caster(view, n, j, lamp);
    if (simd_is_black(lamp->colour)) {
        lamp->casts = 0;
        lamp->plain = false;
    }
}

void tia_simd_prepare(struct tia_view *view)
{
    struct simd_lamp *lamps = view->simd_memory;
    size_t pairs = (size_t)view->scene->sphere_count * view->light_capacity;
    struct simd_caster *casters = (struct simd_caster *)(void *)(lamps + pairs);

    for (uint32_t n = 0; n < view->scene->sphere_count; n++)
        for (uint32_t l = 0; l < view->light_count; l++) {
            size_t i = (size_t)n * view->light_capacity + l;
            lamps[i].cast = casters + i * SIMD_CASTS_KEPT;
            prepare_lamp(view, n, l, &lamps[i]);
        }
}
