/* bound_cache.c - cached bounds. row.c and bounds.c derive bounds from a run's limits alone, so the bounds hold for
 * every run whose limits are no larger. As limits change little from row to row, bounds are derived from limits that
 * are a tenth larger than the run's own, and reused until a run exceeds one of these limits. */
#include "bound_cache.h"

#include <math.h>

#include "bound_table.h"

#define WIDER (1 + BOUND(SPAN_KEPT))

enum { B_MOST, B_LEAST, SIZE, LEAST, SQUARE_MOST, SQUARE_LEAST, V_MOST, FORMS };
#define FORMS_MOST (FORMS + SIMD_LIGHTS * (2 + 2 * SIMD_CASTS))

static double size_of(const double form[2], const struct simd_place *place)
{
    return fabs(form[0]) + fabs(form[1]) * place->reach;
}

/* Gives a run's limits in the order of the enumeration, then the sizes of its forms. Returns the number of limits,
 * sizes included. */
static int limits_of(const struct simd_fine *fine, double limit[FORMS_MOST])
{
    const struct simd_place *place = &fine->place;
    int n = FORMS;

    limit[B_MOST] = fine->seen.b_most;
    limit[B_LEAST] = -fine->seen.b_least;
    limit[SIZE] = fine->seen.size;
    limit[LEAST] = -fine->seen.least;
    limit[SQUARE_MOST] = place->square_most;
    limit[SQUARE_LEAST] = -place->square_least;
    limit[V_MOST] = place->v_most;
    for (int l = 0; l < fine->lights; l++) {
        const struct simd_fine_light *light = &fine->light[l];
        limit[n++] = size_of(light->g, place);
        limit[n++] = size_of(light->q, place);
        for (int j = 0; j < light->lamp->casts; j++) {
            limit[n++] = size_of(light->cast[j].a + 1, place);
            limit[n++] = size_of(light->cast[j].k + 1, place);
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

/* Bounds one light; `limit` points to the sizes of its forms. Returns a pointer to the sizes of the next light's forms,
 * or NULL if the bounds are too large. */
static const double *light_bounds(struct simd_fine *fine, struct simd_fine_light *light, const struct simd_place *place,
                                  const double *limit)
{
    const struct simd_lamp *lamp = light->lamp;

    tia_simd_bound_light(lamp, place, &fine->depth, SIMD_FLOAT, limit[0], limit[1], &light->bounds);
    if (!(light->bounds.lambert < BOUND(SPAN_COSINE_KNOWN)))
        return NULL;
    limit += 2;
    for (int j = 0; j < lamp->casts; j++, limit += 2) {
        struct simd_fine_cast *cast = &light->cast[j];
        tia_simd_bound_cast(lamp, &lamp->cast[j], place, &fine->depth, &light->bounds, SIMD_FLOAT, limit[0], limit[1],
                            &cast->bounds);
    }
    return limit;
}

static bool derive(struct simd_fine *fine, const double *limit)
{
    double off[3] = {0, 0, 0}, step = BOUND(SPAN_COLOUR) * SIMD_FLOAT;
    struct simd_place place = fine->place;
    struct simd_seen seen = fine->seen;

    take_limits(limit, &place, &seen);
    tia_simd_depth(fine->row, &place, simd_sphere_of(fine), &seen, SIMD_FLOAT, SIMD_FLOAT_CUT, &fine->depth);
    if (!(seen.b_least > 0 && fine->depth.es + fine->depth.et < BOUND(SPAN_KNOWN)))
        return false;
    limit += FORMS;
    for (int l = 0; l < fine->lights; l++) {
        struct simd_fine_light *light = &fine->light[l];
        limit = light_bounds(fine, light, &place, limit);
        if (!limit)
            return false;
        for (int c = 0; c < 3; c++)
            off[c] += BOUND_OF(SPAN_COLOURS,
                               light->lamp->colour[c] * (light->bounds.lambert + BOUND(SPAN_LINE) * SIMD_FLOAT) +
                                   step * (1 + light->lamp->casts));
    }
    double side = off[0] > off[2] ? off[0] : off[2], green = fine->grey ? off[0] : off[1];

    fine->near31 = tia_simd_bound_level(31, side, SIMD_FLOAT);
    fine->near63 = tia_simd_bound_level(63, green, SIMD_FLOAT);
    return fine->near31 > BOUND(SPAN_LEVEL_LEAST) && fine->near63 > BOUND(SPAN_LEVEL_LEAST);
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
            cache->cast[n++] = fine->light[l].cast[j].bounds;
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
            fine->light[l].cast[j].bounds = cache->cast[n++];
    }
}

/* Gives the bounds for the widened limits or, if these bounds are too large, for the run's own limits. The latter are
 * not cached. */
bool tia_simd_fine_bounds(struct simd_fine *fine, struct simd_bound_cache *cache)
{
    double limit[FORMS_MOST];
    int limits = limits_of(fine, limit);

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
