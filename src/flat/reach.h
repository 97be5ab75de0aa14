/* reach.h - the range of a scene's points and lights, which decides the fraction bits of their vertices.
 *
 * A light with a position is a vertex like any other if it is in range. The faces determine the fraction bits if all
 * lights are in the faces' range; otherwise the lights do. */
#ifndef TIA_FLAT_REACH_H
#define TIA_FLAT_REACH_H

#include "eye.h"
#include "scene/cancel.h"

/* The properties of a scene that limit its lights. */
struct tia_reach {
    const struct tia_eye *eye;
    unsigned width, height; /* size of the image, in pixels */
    uint32_t samples;       /* number of samples of a pixel */
    unsigned faces;         /* largest range of a corner, see tia_eye_range */
};

/* Returns the range of the scene's faces; undefined once cancelled. */
unsigned tia_reach_of_faces(const struct tia_scene *scene, const struct tia_eye *eye, struct cancel *cancel);

/* Returns the largest range of a corner, see raster.h. */
static inline unsigned tia_reach_most(enum tia_projection projection)
{
    return projection == TIA_ORTHOGRAPHIC ? TIA_RANGE_FLAT : TIA_RANGE_MAX;
}

/* True if a light counts as a direction: a directional light, and in orthographic views a light so far away that the
 * difference moves shadows by less than half a pixel, and by no more than rounding the light's vertex would. */
bool tia_reach_is_direction(const struct tia_reach *reach, const struct tia_light *light);

/* Returns the largest range of a light's point: that of raster.h; in orthographic views, which have fewer bits, the
 * largest one for which vertices are rounded by less than half a pixel, but at least that of the faces. */
unsigned tia_reach_of_lights(const struct tia_reach *reach);

/* Returns the index of the first light beyond tia_reach_of_lights, or `count`. */
uint32_t tia_reach_too_far(const struct tia_reach *reach, const struct tia_light *lights, uint32_t count);

/* Returns the range for the scene's faces with these lights, none of which is too far. So that hits stay valid, the
 * range is the same for the scene's own lights, for the lights that keys set, and for these at up to four times their
 * distance; it is larger for lights farther away. */
unsigned tia_reach_with_lights(const struct tia_reach *reach, const struct tia_scene *scene,
                               const struct tia_light *lights, uint32_t count);

#endif
