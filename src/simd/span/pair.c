#include "pair.h"

#include <math.h>

#include "bound_table.h"
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

    return pairs > SIZE_MAX / 2 / sizeof(struct simd_lamp) ? SIZE_MAX : (size_t)pairs * sizeof(struct simd_lamp);
}

static void channels(const struct tia_rgb *colour, double out[3])
{
    out[0] = (double)colour->r * 0x1p-30;
    out[1] = (double)colour->g * 0x1p-30;
    out[2] = (double)colour->b * 0x1p-30;
}

static void cast_power(const struct span_sphere *sphere, const struct span_sphere *caster, struct simd_caster *cast)
{
    double r = (double)sphere->radius * 0x1p-16, radius = (double)caster->radius * 0x1p-16;
    double away = length(num_vec_sub(sphere->centre, caster->centre)), share = SIMD_BIAS / (r + SIMD_BIAS);
    double apart = away * away - r * r - radius * radius - SIMD_BIAS * r;

    cast->p0 = (double)caster->c * 0x1p-32 - apart * share;
    cast->fixed = (BOUND(SPAN_SWELL) * (away * away + r * r + radius * radius) + BOUND(SPAN_SWELL_UNITS)) * share;
}

static void add_cast(const struct tia_view *view, const struct light_source *source, uint32_t j, struct simd_lamp *lamp)
{
    const struct span_view *spans = view->prepared;
    const struct span_sphere *caster = &spans->spheres[j];
    const struct tia_rgb *through = &view->scene->materials[view->scene->spheres[j].material].transmission;
    struct shadow_line line;

    if (lamp->plain || !shadow_line_prepare(&spans->primary, source, caster, 0, 0, &line))
        return;
    lamp->plain = lamp->casts == SIMD_CASTS || line.enclosed;
    if (lamp->plain)
        return;
    struct simd_caster *cast = &lamp->cast[lamp->casts++];
    int e_a = 43 + (source->exponent >> 1) - line.bias_shift, e_k = 2 * e_a - source->exponent - line.exponent;

    cast->sphere = j;
    cast->sum = num_vec_add(caster->centre, source->light);
    cast->size = length(caster->centre);
    cast->aq = (double)num_dot(caster->centre, source->light) * 0x1p-32 - lamp->swell * lamp->k;
    cast->ua = simd_power(-e_a);
    cast->uk = simd_power(-e_k);
    cast->radius = (double)caster->radius * 0x1p-16;
    cast->apart = length(num_vec_sub(caster->centre, source->light));
    cast_power(source->sphere, caster, cast);
    cast->clear = !colour_is_black(through);
    channels(through, cast->through);
}

static void light_constants(const struct span_sphere *sphere, const struct light_source *source, int scale,
                            struct simd_lamp *lamp)
{
    double r = (double)sphere->radius * 0x1p-16;

    lamp->light = source->light;
    lamp->g = num_vec_sub(source->light, sphere->centre);
    lamp->k = (double)(sphere->c - num_dot(sphere->centre, source->light)) * 0x1p-32;
    lamp->qq = (double)num_dot(source->light, source->light) * 0x1p-32;
    lamp->size = sqrt(lamp->qq);
    lamp->gap = fabs(length(lamp->g) - r) - (length(lamp->g) + r) * BOUND(SPAN_GAP);
    lamp->per_r = 1 / r;
    lamp->swell = SIMD_BIAS / r;
    lamp->ud = simd_power(-source->exponent);
    lamp->up = simd_power(-source->reach_exponent);
    lamp->us = simd_power(-(15 - sphere->radius_bits - scale + (source->exponent >> 1)));
}

static void prepare_lamp(const struct tia_view *view, uint32_t n, uint32_t l, struct simd_lamp *lamp)
{
    const struct span_view *spans = view->prepared;
    const struct span_sphere *sphere = &spans->spheres[n];
    struct light_source source = {.sphere = sphere,
                                  .light = num_vec_between(view->scene->camera.eye, view->lights[l].centre)};
    struct light_line line;
    double emission[3];

    lamp->casts = 0;
    lamp->plain = sphere->radius == 0 || sphere->c <= 0;
    if (lamp->plain)
        return;
    light_line_prepare(&spans->primary, &source, 0, 0, &line);
    light_constants(sphere, &source, line.scale, lamp);
    channels(&view->scene->materials[view->scene->spheres[n].material].colour, lamp->colour);
    channels(&view->lights[l].emission, emission);
    for (int c = 0; c < 3; c++)
        lamp->colour[c] *= emission[c];
    for (uint32_t j = 0; j < view->scene->sphere_count; j++)
        if (j != n)
            add_cast(view, &source, j, lamp);
}

void tia_simd_prepare(struct tia_view *view)
{
    struct simd_lamp *lamps = view->simd_memory;

    for (uint32_t n = 0; n < view->scene->sphere_count; n++)
        for (uint32_t l = 0; l < view->light_count; l++)
            prepare_lamp(view, n, l, &lamps[(size_t)n * view->light_capacity + l]);
}
