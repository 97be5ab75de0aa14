/* curved.h - the objects without flat faces, by rays that leave out all others. */
#ifndef TIA_RENDER_HYBRID_CURVED_H
#define TIA_RENDER_HYBRID_CURVED_H

#include "flat/curved.h"
#include "render/trace/trace.h"

/* Puts the nearest curved object in place of what the ray hits if it is nearer, or as near with a lower index. */
void curved_intersect(const struct ray_view *view, const struct ray *ray, struct hit *hit);

/* Whether no curved object is met at 0 <= t <= limit. They are opaque. `blocker` as of ray_transmittance. */
bool curved_passes(const struct ray_view *view, const struct ray *ray, num_length limit, uint32_t *blocker);

/* Sets the count where a curved object may be seen. */
void curved_mark(const struct tia_curved_place *places, uint32_t place_count, const struct tia_hits *hits,
                 struct tia_tile tile, uint32_t *count);

#endif
