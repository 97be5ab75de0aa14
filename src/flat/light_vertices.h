/* light_vertices.h - light samples as vertices. */
#ifndef TIA_FLAT_LIGHT_VERTICES_H
#define TIA_FLAT_LIGHT_VERTICES_H

#include "faces.h"

/* A light sample: a point, or a direction as a vertex at infinity. */
typedef struct tia_raster_vertex tia_flat_light;

/* Returns the number of a light's samples that have shadows: 0 for ambient light. */
unsigned tia_flat_light_samples(const struct tia_light *light);

/* Gives sample i of a light that shadow.h allows and that is in reach, see tia_reach_too_far. The sample of a light
 * that counts as a direction, see tia_reach_is_direction, is the direction from the eye to the light. */
void tia_flat_light_at(const struct tia_flat_scene *flat, const struct tia_light *light, unsigned i,
                       tia_flat_light *out);

/* Gives the centre of a light, or the direction of one that counts as a direction. */
void tia_flat_light_centre(const struct tia_flat_scene *flat, const struct tia_light *light, tia_flat_light *out);

#endif
