/* bound_cache.c - cached bounds. row.c and bounds.c derive bounds from a run's limits alone, so the bounds hold for
 * every run whose limits are no larger. As limits change little from row to row, bounds are derived from limits that
 * are a tenth larger than the run's own, and reused until a run exceeds one of these limits. */
#include "bound_cache.h"

#include <math.h>

#include "bound_table.h"

#define WIDER (1 + BOUND(SPAN_KEPT))

enum { B_MOST, B_LEAST, SIZE, LEAST, SQUARE_MOST, SQUARE_LEAST, V_MOST, FORMS };
#define FORMS_MOST (2 * SIMD_LIGHTS + 2 * SIMD_CASTS)

static double size_of(const double form[2], const struct simd_place *place)
{
    return fabs(form[0]) + fabs(form[1]) * place->reach;
}

/* Gives the limits of a run's place and sphere in the order of the enumeration. */
static void limits_of(const struct simd_fine *fine, double limit[FORMS])
{
    const struct simd_place *place = &fine->place;

    limit[B_MOST] = fine->seen.b_most;
    limit[B_LEAST] = -fine->seen.b_least;
    limit[SIZE] = fine->seen.size;
    limit[LEAST] = -fine->seen.least;
    limit[SQUARE_MOST] = place->square_most;
    limit[SQUARE_LEAST] = -place->square_least;
    limit[V_MOST] = place->v_most;
}

/* Gives the sizes of the forms of a run's lights. Returns their number. */
static int sizes_of(const struct simd_fine *fine, double size[FORMS_MOST])
{
    const struct simd_place *place = &fine->place;
    int n = 0;

    for (int l = 0; l < fine->lights; l++) {
        const struct simd_fine_light *light = &fine->light[l];
        size[n++] = size_of(light->g, place);
        size[n++] = size_of(light->q, place);
        for (int j = 0; j < light->lamp->casts; j++) {
            const struct simd_fine_cast *cast = &fine->cast[light->first + j];
            size[n++] = size_of(cast->a + 1, place);
            size[n++] = size_of(cast->k + 1, place);
        }
    }
    return n;
}

/* Replaces values of the place and of the sphere by the limits. */
static void take_limits(const double limit[], struct simd_place *place, struct simd_seen *seen)
{
    seen->b_most = limit[B_MOST];
    seen->b_least = -limit[B_LEAST];
    seen->size = limit[SIZE];
    seen->least = -limit[LEAST];
    place->square_most = limit[SQUARE_MOST];
    place->square_least = -limit[SQUARE_LEAST];
    place->v_most = limit[V_MOST];
}

/* Bounds one light; `size` points to the sizes of its forms. Returns a pointer to the sizes of the next light's forms,
 * or NULL if the bounds are too large. */
static const double *light_bounds(struct simd_fine *fine, struct simd_fine_light *light, const struct simd_place *place,
                                  const double *size)
{
    const struct simd_lamp *lamp = light->lamp;

    tia_simd_bound_light(lamp, place, &fine->depth, SIMD_FLOAT, size[0], size[1], &light->bounds);
    if (!(light->bounds.lambert < BOUND(SPAN_COSINE_KNOWN)))
        return NULL;
    size += 2;
    for (int j = 0; j < lamp->casts; j++, size += 2)
        tia_simd_bound_cast(lamp, &lamp->cast[j], place, &fine->depth, &light->bounds, SIMD_FLOAT, size[0], size[1],
                            &fine->cast[light->first + j].bounds);
    return size;
}

/* Bounds the lights for a place, and adds the errors of their colours to `off`. */
static bool derive_lights(struct simd_fine *fine, const struct simd_place *place, const double *size, double off[3])
{
    for (int l = 0; l < fine->lights && size; l++) {
        struct simd_fine_light *light = &fine->light[l];
        double rounded = BOUND(SPAN_LINE) + BOUND(SPAN_COLOUR) * (1 + light->lamp->casts);
        size = light_bounds(fine, light, place, size);
        for (int c = 0; size && c < 3; c++)
            off[c] += BOUND_OF(SPAN_COLOURS, light->lamp->colour[c] * (light->bounds.lambert + rounded * SIMD_FLOAT) +
                                                 BOUND(SPAN_COLOUR_SUM) * SIMD_FLOAT);
    }
    return size != NULL;
}

bool tia_simd_fine_levels(struct simd_fine *fine, const double off[3])
{
    double side = off[0] > off[2] ? off[0] : off[2], green = fine->grey ? off[0] : off[1];

    fine->near31 = tia_simd_bound_level(31, side, SIMD_FLOAT);
    fine->near63 = tia_simd_bound_level(63, green, SIMD_FLOAT);
    return fine->near31 > BOUND(SPAN_LEVEL_LEAST) && fine->near63 > BOUND(SPAN_LEVEL_LEAST);
}

static bool derive_depth(struct simd_fine *fine, const struct simd_place *place, const struct simd_seen *seen)
{
    tia_simd_depth(fine->row, place, simd_sphere_of(fine), seen, SIMD_FLOAT, SIMD_FLOAT_CUT, &fine->depth);
    return seen->b_least > 0 && fine->depth.es + fine->depth.et < BOUND(SPAN_KNOWN);
}

bool tia_simd_fine_depth(struct simd_fine *fine)
{
    return derive_depth(fine, &fine->place, &fine->seen);
}

bool tia_simd_fine_lights(struct simd_fine *fine, double off[3])
{
    double size[FORMS_MOST];

    (void)sizes_of(fine, size);
    return derive_lights(fine, &fine->place, size, off);
}

static bool derive(struct simd_fine *fine, const double *limit)
{
    double off[3] = {0, 0, 0};
    struct simd_place place = fine->place;
    struct simd_seen seen = fine->seen;

    take_limits(limit, &place, &seen);
    return derive_depth(fine, &place, &seen) && derive_lights(fine, &place, limit + FORMS, off) &&
           tia_simd_fine_levels(fine, off);
}

/* ---- the cache ---- */

static bool suffices(const struct simd_bound_cache *cache, uint32_t sphere, const double *limit, int limits)
{
    bool good = cache->known && cache->sphere == sphere && cache->limits == limits;

    for (int i = 0; good && i < limits; i++)
        good = limit[i] <= cache->limit[i];
    return good;
}

static void keep(const struct simd_fine *fine, struct simd_bound_cache *cache)
{
    int n = 0;

    cache->depth = fine->depth;
    cache->near31 = fine->near31;
    cache->near63 = fine->near63;
    for (int l = 0; l < fine->lights; l++) {
        cache->light[l] = fine->light[l].bounds;
        for (int j = 0; j < fine->light[l].lamp->casts; j++)
            cache->cast[n++] = fine->cast[fine->light[l].first + j].bounds;
    }
}

static void take_cached(const struct simd_bound_cache *cache, struct simd_fine *fine)
{
    int n = 0;

    fine->depth = cache->depth;
    fine->near31 = cache->near31;
    fine->near63 = cache->near63;
    for (int l = 0; l < fine->lights; l++) {
        fine->light[l].bounds = cache->light[l];
        for (int j = 0; j < fine->light[l].lamp->casts; j++)
            fine->cast[fine->light[l].first + j].bounds = cache->cast[n++];
    }
}

/* Gives the bounds for the widened limits or, if these bounds are too large, for the run's own limits. The latter are
 * not cached. */
bool tia_simd_fine_bounds(struct simd_fine *fine, struct simd_bound_cache *cache)
{
    double limit[FORMS + FORMS_MOST];
    int limits = FORMS + sizes_of(fine, limit + FORMS);

    limits_of(fine, limit);
    if (!cache || limits > SIMD_LIMITS)
        return derive(fine, limit);
    if (suffices(cache, fine->sphere, limit, limits)) {
        take_cached(cache, fine);
        return true;
    }
    cache->sphere = fine->sphere;
    cache->limits = limits;
    for (int i = 0; i < limits; i++)
        cache->limit[i] = limit[i] > 0 ? limit[i] * WIDER : limit[i] / WIDER;
    cache->known = derive(fine, cache->limit);
    if (!cache->known)
        return derive(fine, limit);
    keep(fine, cache);
    return true;
}
