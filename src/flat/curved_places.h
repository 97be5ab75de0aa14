/* curved_places.h - the parts of the image that may show objects without flat faces; rays are traced there. */
#ifndef TIA_FLAT_CURVED_PLACES_H
#define TIA_FLAT_CURVED_PLACES_H

#include "faces.h"

/* The pixels that may show an object: x0 <= x < x1, y0 <= y < y1. */
struct tia_curved_place {
    uint32_t object;
    uint16_t x0, y0, x1, y1;
};

/* Returns the number of a scene's objects that are neither flat nor empty, see source.h. */
uint32_t tia_curved_count(const struct tia_scene *scene);

/* Gives the place of each object counted by tia_curved_count. */
void tia_curved_find(struct tia_curved_place *places, const struct tia_scene *scene, const struct tia_eye *eye,
                     unsigned width, unsigned height);

#endif
