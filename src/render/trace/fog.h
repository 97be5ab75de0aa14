/* fog.h - fog along a ray, see struct tia_fog. */
#ifndef TIA_RENDER_TRACE_FOG_H
#define TIA_RENDER_TRACE_FOG_H

#include "trace.h"

/* Returns the share of the light from the hit, perhaps of a light or of nothing, that passes the fog along the ray. */
num_unit ray_fog_share(const struct tia_fog *fog, const struct ray *ray, const struct hit *hit);

/* Reduces the throughput to what passes the scene's fog, and adds the fog's own part to the colour. */
void ray_fog_veil(const struct tia_fog *fog, const struct ray *ray, const struct hit *hit, num_length throughput[3],
                  num_length colour[3]);

#endif
