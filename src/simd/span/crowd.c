#include "crowd.h"

#include <math.h>
#include <string.h>

#include "bound_table.h"
#include "render/span/coherence/coherence.h"
#include "render/span/span_parts.h"

bool tia_simd_is_crowded(const struct tia_view *view, uint32_t sphere)
{
    bool crowded = view->light_count > SIMD_LIGHTS;

    for (uint32_t l = 0; l < view->light_count && !crowded; l++) {
        const struct simd_lamp *lamp = simd_lamp_of(view, sphere, l);
        crowded = lamp->plain || lamp->casts > SIMD_CASTS_FEW;
    }
    return crowded;
}

void tia_simd_crowd(const struct tia_view *view, uint32_t sphere, int y, int first, int end, struct simd_crowd *crowd)
{
    const int last = end - first - 1, at[3] = {0, last / 2, last};

    crowd->span = (struct shaded_span){sphere, first, y, end - first, crowd->t, NULL, NULL};
    crowd->shadows.tried = crowd->shadows.divided = false;
    crowd->shadows.doubt = 0;
    for (int i = 0; i < 3; i++)
        span_distances(span_view_of(view), sphere, y, first + at[i], 1, &crowd->t[at[i]]);
    (void)coherence_around(span_view_of(view), &crowd->span, &crowd->shadows);
    memset(crowd->known, SIMD_UNKNOWN, sizeof crowd->known);
}

/* ---- lists ---- */

/* True if no point of the sphere L in the span's ball, around p, faces the light: with G = Q - L and P = L + r N,
 *
 *     r N.(Q - P) = (P - L).G - r^2. */
static bool is_away(const struct tia_view *view, const struct simd_crowd *crowd, const struct simd_lamp *lamp)
{
    const struct span_sphere *sphere = &span_view_of(view)->spheres[crowd->span.object];
    const struct coarse_ball *ball = &crowd->shadows.around;

    if (!crowd->shadows.known)
        return false;
    const struct num_vec p = {4 * (num_wide)ball->x, 4 * (num_wide)ball->y, 4 * (num_wide)ball->z};
    struct num_vec d = num_vec_sub(p, sphere->centre);
    double x = (double)d.x * 0x1p-16, y = (double)d.y * 0x1p-16, z = (double)d.z * 0x1p-16;
    double toward = (x * (double)lamp->g.x + y * (double)lamp->g.y + z * (double)lamp->g.z) * 0x1p-16;
    double reach = (double)(4 * (num_wide)ball->radius) * 0x1p-16 * lamp->reach, r = (double)sphere->radius * 0x1p-16;
    double size = (fabs(x) + fabs(y) + fabs(z)) * lamp->reach + reach + r * r;

    return toward + reach < r * r - BOUND_OF(SPAN_AWAY, BOUND(SPAN_PARTS) * size);
}

static void remove_from(uint8_t list[SIMD_LIST], uint32_t sphere)
{
    list[sphere >> 3] = (uint8_t)(list[sphere >> 3] & ~(1u << (sphere & 7)));
}

/* Removes the shades of a lamp, whose colour has their transmissions. */
static void remove_shades(const struct tia_view *view, uint32_t sphere, const struct simd_lamp *lamp,
                          uint8_t list[SIMD_LIST])
{
    const struct span_casters *casters = &span_view_of(view)->casters;

    for (uint32_t j = 0; lamp->shades && (j = span_next_in(casters, list, j)) < casters->count; j++)
        if (tia_simd_is_shade(view, sphere, j, lamp))
            remove_from(list, j);
}

/* Pixels whose ball is so small that it is worth while to try each sphere on it, but not to look for spheres among
 * those that are kept. */
#define SHORT 64

/* Spheres of a scene whose lists take longer to look through than that. */
#define MANY 64

/* Removes the spheres that block the light nowhere; false if one blocks it everywhere. */
static bool try_ball(const struct span_view *spans, const struct coarse_ball *ball, uint32_t light,
                     uint8_t list[SIMD_LIST])
{
    const struct span_casters *casters = &spans->casters;

    for (uint32_t j = 0; (j = span_next_in(casters, list, j)) < casters->count; j++) {
        enum span_part part = span_part_of(casters, ball, light, j);
        if (part == SPAN_DARK && !spans->tinted)
            return false;
        if (part == SPAN_LIT)
            remove_from(list, j);
    }
    return true;
}

/* Makes a light's list; false if the light reaches no pixel. */
static bool make_list(const struct tia_view *view, struct simd_crowd *crowd, uint32_t light, uint8_t list[SIMD_LIST])
{
    const struct span_view *spans = span_view_of(view);
    const struct shaded_span *span = &crowd->span;
    const struct simd_lamp *lamp = simd_lamp_of(view, span->object, light);
    const struct coarse_ball *ball = &crowd->shadows.around;

    memset(list, 0, SIMD_LIST);
    if (!coherence_near(spans, span, light, &crowd->shadows))
        return true;
    memcpy(list, crowd->shadows.near, (spans->casters.count + 7) / 8);
    remove_shades(view, span->object, lamp, list);
    return !crowd->shadows.known || span->count > SHORT || try_ball(spans, ball, light, list);
}

const uint8_t *tia_simd_crowd_list(const struct tia_view *view, struct simd_crowd *crowd, uint32_t light)
{
    if (light >= SIMD_CROWD_LISTS)
        return make_list(view, crowd, light, crowd->last) ? crowd->last : NULL;
    if (crowd->known[light] == SIMD_UNKNOWN)
        crowd->known[light] = make_list(view, crowd, light, crowd->list[light]) ? SIMD_SOME : SIMD_NONE;
    return crowd->known[light] == SIMD_SOME ? crowd->list[light] : NULL;
}

const struct simd_lamp *tia_simd_crowd_lamp(const struct tia_view *view, struct simd_crowd *crowd, uint32_t light)
{
    const struct span_casters *casters = &span_view_of(view)->casters;
    uint32_t sphere = crowd->span.object;
    const struct simd_lamp *from = simd_lamp_of(view, sphere, light);

    if (simd_is_black(from->colour) || is_away(view, crowd, from))
        return NULL;
    if (!from->plain &&
        (from->casts <= SIMD_CASTS_FEW || (crowd->span.count <= SHORT && view->scene->sphere_count >= MANY)))
        return from;
    const uint8_t *list = tia_simd_crowd_list(view, crowd, light);
    if (!list)
        return NULL;
    crowd->lamp = *from;
    crowd->lamp.plain = false;
    crowd->lamp.cast = crowd->cast;
    crowd->lamp.casts = 0;
    for (uint32_t j = 0; (j = span_next_in(casters, list, j)) < casters->count; j++)
        tia_simd_caster(view, sphere, j, from, &crowd->cast[crowd->lamp.casts++]);
    return &crowd->lamp;
}
