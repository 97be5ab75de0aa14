#include "crowd.h"

#include <string.h>

#include "render/span/coherence/coherence.h"
#include "render/span/span_parts.h"

bool tia_simd_is_crowded(const struct tia_view *view, uint32_t sphere)
{
    bool crowded = false;

    for (uint32_t l = 0; l < view->light_count && !crowded; l++)
        crowded = simd_lamp_of(view, sphere, l)->plain;
    return crowded;
}

/* Computes the distances of three pixels, counted from the span's first one. */
static void measure(const struct tia_view *view, struct simd_crowd *crowd, int first, int last)
{
    const struct shaded_span *span = &crowd->span;
    const int at[3] = {first, first + (last - first) / 2, last};

    for (int i = 0; i < 3; i++)
        span_distances(span_view_of(view), span->object, span->y, span->x + at[i], 1, &crowd->t[at[i]]);
}

void tia_simd_crowd(const struct tia_view *view, uint32_t sphere, int y, int first, int end, struct simd_crowd *crowd)
{
    crowd->span = (struct shaded_span){sphere, first, y, end - first, crowd->t, NULL, NULL};
    crowd->shadows.tried = crowd->shadows.divided = false;
    measure(view, crowd, 0, end - first - 1);
    for (uint32_t l = 0; l < view->light_count; l++) {
        crowd->some[l] = coherence_near(span_view_of(view), &crowd->span, l, &crowd->shadows);
        if (crowd->some[l])
            memcpy(crowd->near[l], crowd->shadows.near, sizeof crowd->near[l]);
    }
}

/* Some pixels of a sphere, and a ball around their points. */
struct piece {
    const struct tia_view *view;
    uint32_t sphere;
    bool known; /* there is a ball */
    bool whole; /* all of the span, whose near casters are already those of the ball */
    struct coarse_ball ball;
};

/* Returns what sphere j does to a light at the points of a piece. */
static enum span_part part_of(const struct piece *piece, uint32_t light, const struct span_hull *hull, uint32_t j)
{
    const struct span_view *spans = span_view_of(piece->view);

    if (!piece->known)
        return SPAN_OPEN;
    if (!piece->whole && span_hull_clears(hull, &spans->casters.coarse[j]))
        return SPAN_LIT;
    enum span_part part = span_part_of(&spans->casters, &piece->ball, light, j);
    return spans->tinted && part == SPAN_DARK ? SPAN_OPEN : part;
}

/* Adds a caster to a lamp: one of those of the sphere's lamp `from`, unless that has too many. */
static void add_caster(const struct piece *piece, const struct simd_lamp *from, uint32_t j, struct simd_lamp *lamp)
{
    if (from->plain) {
        tia_simd_add_caster(piece->view, piece->sphere, j, lamp);
        return;
    }
    for (int i = 0; i < from->casts; i++)
        if (from->cast[i].sphere == j)
            lamp->cast[lamp->casts++] = from->cast[i];
}

/* Finds the casters among `near` that may block a light at some points of a piece and not at others: up to SIMD_CASTS
 * of them. Returns their number, which may be larger; -1 if one blocks it at all points. */
static int find_casters(const struct piece *piece, uint32_t light, const uint8_t *near, uint32_t found[SIMD_CASTS])
{
    const struct span_casters *casters = &span_view_of(piece->view)->casters;
    struct span_hull hull;
    int count = 0;

    if (piece->known && !piece->whole)
        span_hull_of(&piece->ball, &casters->coarse[casters->count + light], &hull);
    for (uint32_t i = 0; i < (casters->count + 7) / 8; i++)
        for (unsigned rest = near[i]; rest; rest &= rest - 1) {
            uint32_t j = 8 * i + (uint32_t)__builtin_ctz(rest);
            enum span_part part = part_of(piece, light, &hull, j);
            if (part == SPAN_DARK)
                return -1;
            if (part == SPAN_OPEN && count < SIMD_CASTS)
                found[count] = j;
            count += part == SPAN_OPEN;
        }
    return count;
}

/* Gives the lamp of a light with its casters in a piece, which are among `near`; NULL: there are none. */
static void find_lamp(const struct piece *piece, uint32_t light, const uint8_t *near,
                      struct simd_caster cast[SIMD_CASTS], struct simd_lamp *lamp)
{
    const struct simd_lamp *from = simd_lamp_of(piece->view, piece->sphere, light);
    uint32_t found[SIMD_CASTS];
    int count = near ? find_casters(piece, light, near, found) : 0;

    *lamp = *from;
    lamp->cast = cast;
    lamp->room = SIMD_CASTS;
    lamp->casts = 0;
    lamp->shades = from->plain ? 0 : from->shades;
    lamp->plain = count > SIMD_CASTS;
    if (count < 0)
        lamp->colour[0] = lamp->colour[1] = lamp->colour[2] = 0;
    for (int i = 0; i < count && !lamp->plain && !simd_is_black(lamp->colour); i++)
        add_caster(piece, from, found[i], lamp);
    if (simd_is_black(lamp->colour))
        lamp->casts = 0;
}

bool tia_simd_crowd_lamps(const struct tia_view *view, struct simd_crowd *crowd, int first, int end)
{
    int from = first - crowd->span.x, last = end - 1 - crowd->span.x;
    struct piece piece = {.view = view, .sphere = crowd->span.object};
    bool fits = true;

    piece.whole = last - from == crowd->span.count - 1;
    if (piece.whole) {
        piece.known = crowd->shadows.known;
        piece.ball = crowd->shadows.around;
    } else {
        measure(view, crowd, from, last);
        piece.known = coherence_surround(span_view_of(view), &crowd->span, from, last, &piece.ball);
    }
    for (uint32_t l = 0; l < view->light_count && fits; l++) {
        find_lamp(&piece, l, crowd->some[l] ? crowd->near[l] : NULL, crowd->cast[l], &crowd->lamp[l]);
        fits = !crowd->lamp[l].plain;
    }
    return fits;
}
