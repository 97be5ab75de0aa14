/* reach.h - how far away a scene's points and lights are, which decides how many fraction bits their vertices have.
 *
 * A light at a point is a vertex like any other as long as it is in range. The faces alone decide the fraction bits
 * where the lights are in range then; else the lights do. */
#ifndef TIA_FLAT_REACH_H
#define TIA_FLAT_REACH_H

#include "eye.h"
#include "scene/cancel.h"

/* What lights need to know of a scene. */
struct tia_reach {
    const struct tia_eye *eye;
    unsigned width, height; /* of the image */
    uint32_t samples;       /* of a pixel */
    unsigned faces;         /* the largest range of a corner, see tia_eye_range */
};

/* That of the scene's faces. Once cancelled, it means nothing. */
unsigned tia_reach_of_faces(const struct tia_scene *scene, const struct tia_eye *eye, struct cancel *cancel);

/* The largest range of a corner, see raster.h. */
static inline unsigned tia_reach_most(enum tia_projection projection)
{
    return projection == TIA_ORTHOGRAPHIC ? TIA_RANGE_FLAT : TIA_RANGE_MAX;
}

/* Whether a light has a direction instead of a place: a directional one; and in an orthographic view one so far away
 * that this moves no shadow by half a pixel, and by less than rounding the light to its vertex would. */
bool tia_reach_is_direction(const struct tia_reach *reach, const struct tia_light *light);

/* The largest range of a light's point: that of raster.h, and in orthographic views, with fewer bits, the one whose
 * vertices are rounded by less than half a pixel, or that of the faces. */
unsigned tia_reach_of_lights(const struct tia_reach *reach);

/* The index of the first light beyond it, or `count`. */
uint32_t tia_reach_too_far(const struct tia_reach *reach, const struct tia_light *lights, uint32_t count);

/* The range for the scene's faces with these lights, of which none is too far: the same for the scene's own lights and
 * what keys make of them, up to four times as far away, so that hits stay valid; more for others. */
unsigned tia_reach_with_lights(const struct tia_reach *reach, const struct tia_scene *scene,
                               const struct tia_light *lights, uint32_t count);

#endif
