/* shadow_rays.h - exact shadow rays from a pixel's visible point to the light, face by face, see occluder.h. */
#ifndef TIA_SHADOW_SHADOW_RAYS_H
#define TIA_SHADOW_SHADOW_RAYS_H

#include "casters.h"
#include "technique.h"

/* Does the work of `light` in struct tia_shadow_technique, by rays. */
void tia_shadow_rays_light(const struct tia_shadow_view *view, const struct tia_casters *casters,
                           struct tia_shadow_tile *tile, unsigned sample, struct cancel *cancel);

#endif
