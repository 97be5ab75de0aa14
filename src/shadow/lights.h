/* lights.h - the points that lights shine from, as vertices. */
#ifndef TIA_SHADOW_LIGHTS_H
#define TIA_SHADOW_LIGHTS_H

#include "faces.h"

/* Where light comes from: a point, or a direction as a vertex at infinity. */
typedef struct tia_raster_vertex tia_flat_light;

/* How many samples with shadows a light has: none if it is ambient. */
unsigned tia_flat_light_samples(const struct tia_light *light);

/* Sample i of a light that shadow.h allows. A point beyond tia_flat_light_range becomes a direction, as seen from the
 * eye: in orthographic views a light more than 2^TIA_FLAT_LIGHT_BITS times as far as the scene reaches, else one more
 * than 2^15 times as far, beyond 2^20, or moved to more than four times its distance. */
void tia_flat_light_at(const struct tia_flat_scene *flat, const struct tia_light *light, unsigned i,
                       tia_flat_light *out);

/* The centre of any light, or its direction. */
void tia_flat_light_centre(const struct tia_flat_scene *flat, const struct tia_light *light, tia_flat_light *out);

#endif
