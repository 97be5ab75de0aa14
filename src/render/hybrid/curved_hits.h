/* curved_hits.h - intersections of rays with the objects that have no flat faces. */
#ifndef TIA_RENDER_HYBRID_CURVED_HITS_H
#define TIA_RENDER_HYBRID_CURVED_HITS_H

#include "flat/curved_places.h"
#include "render/trace/trace.h"

/* Replaces the ray's hit by that of the nearest curved object, if the object is nearer, or as near and of a lower
 * index. */
void curved_intersect(const struct ray_view *view, const struct ray *ray, struct hit *hit);

/* True if the ray meets no curved object at 0 <= t <= limit; curved objects are opaque here. `blocker` is as in
 * ray_transmittance. */
bool curved_passes(const struct ray_view *view, const struct ray *ray, num_length limit, uint32_t *blocker);

/* Sets `count` to 1 at the tile's pixels where a curved object may be visible. */
void curved_mark(const struct tia_curved_place *places, uint32_t place_count, const struct tia_hits *hits,
                 struct tia_tile tile, uint32_t *count);

#endif
