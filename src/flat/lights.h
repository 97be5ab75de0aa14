/* lights.h - the points that lights shine from, as vertices. */
#ifndef TIA_FLAT_LIGHTS_H
#define TIA_FLAT_LIGHTS_H

#include "faces.h"

/* Where light comes from: a point, or a direction as a vertex at infinity. */
typedef struct tia_raster_vertex tia_flat_light;

/* How many samples with shadows a light has: none if it is ambient. */
unsigned tia_flat_light_samples(const struct tia_light *light);

/* Sample i of a light that shadow.h allows and that is in reach, see tia_reach_too_far: of the place of a light that is
 * so far away that it counts as a direction there, this direction from the eye. */
void tia_flat_light_at(const struct tia_flat_scene *flat, const struct tia_light *light, unsigned i,
                       tia_flat_light *out);

/* The centre of any light, or its direction. */
void tia_flat_light_centre(const struct tia_flat_scene *flat, const struct tia_light *light, tia_flat_light *out);

#endif
