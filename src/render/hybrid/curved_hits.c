#include "curved_hits.h"

#include "flat/faces.h"
#include "render/geometry/walk.h"

/* Returns the next curved object that the ray may meet at 0 <= t <= limit, or TIA_NO_OBJECT. Flat candidates are
 * skipped; their faces are not tested. */
static uint32_t next(const struct ray_view *view, struct candidates *candidates, num_length limit,
                     struct cancel *cancel)
{
    uint32_t object = candidates_next(candidates, limit);

    while (object != TIA_NO_OBJECT && tia_flat_takes(view->scene, object))
        object = cancelled(cancel, 1) ? TIA_NO_OBJECT : candidates_next(candidates, limit);
    return cancelled(cancel, 1) ? TIA_NO_OBJECT : object;
}

void curved_intersect(const struct ray_view *view, const struct ray *ray, struct hit *hit)
{
    struct candidates candidates;
    struct cancel cancel = view_cancel(view->view);
    uint32_t object;

    candidates_start(&candidates, view->scene, ray);
    while ((object = next(view, &candidates, hit->t, &cancel)) != TIA_NO_OBJECT) {
        struct hit met;
        if (ray_meets(view, ray, object, hit->t, &met) && (met.t < hit->t || object < hit->object))
            *hit = met;
    }
}

bool curved_passes(const struct ray_view *view, const struct ray *ray, num_length limit, uint32_t *blocker)
{
    struct candidates candidates;
    struct cancel cancel = view_cancel(view->view);
    uint32_t object;

    if (*blocker != TIA_NO_OBJECT && !tia_flat_takes(view->scene, *blocker) &&
        ray_occluded_by(view, ray, *blocker, limit, NULL))
        return false;
    candidates_start(&candidates, view->scene, ray);
    while ((object = next(view, &candidates, limit, &cancel)) != TIA_NO_OBJECT)
        if (ray_occluded_by(view, ray, object, limit, NULL)) {
            *blocker = object;
            return false;
        }
    return true;
}

static uint32_t higher(uint32_t a, uint32_t b)
{
    return a > b ? a : b;
}

static uint32_t lower(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

void curved_mark(const struct tia_curved_place *places, uint32_t place_count, const struct tia_hits *hits,
                 struct tia_tile tile, uint32_t *count)
{
    for (uint32_t i = 0; i < place_count; i++) {
        const struct tia_curved_place *place = &places[i];
        uint32_t right = lower(place->x1, (uint32_t)tile_right(tile));
        uint32_t bottom = lower(place->y1, (uint32_t)tile_bottom(tile));

        for (uint32_t y = higher(place->y0, tile.y); y < bottom; y++)
            for (uint32_t x = higher(place->x0, tile.x); x < right; x++)
                count[hits_index(hits, (unsigned)x, (unsigned)y)] = 1;
    }
}
