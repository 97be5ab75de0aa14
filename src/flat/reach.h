/* reach.h - the range of a scene's points and lights, which decides the fraction bits of their vertices.
 *
 * A light at a point is a vertex like any other as long as it is in range. If all lights are in the range of the faces,
 * the faces alone decide the fraction bits; else the lights do. */
#ifndef TIA_FLAT_REACH_H
#define TIA_FLAT_REACH_H

#include "eye.h"
#include "scene/cancel.h"

/* The properties of a scene that limit its lights. */
struct tia_reach {
    const struct tia_eye *eye;
    unsigned width, height; /* size of the image, in pixels */
    uint32_t samples;       /* samples of a pixel */
    unsigned faces;         /* largest range of a corner, see tia_eye_range */
};

/* Returns the range of the scene's faces; undefined once cancelled. */
unsigned tia_reach_of_faces(const struct tia_scene *scene, const struct tia_eye *eye, struct cancel *cancel);

/* Returns the largest range of a corner, see raster.h. */
static inline unsigned tia_reach_most(enum tia_projection projection)
{
    return projection == TIA_ORTHOGRAPHIC ? TIA_RANGE_FLAT : TIA_RANGE_MAX;
}

/* True if a light has a direction instead of a position: a directional one; or in an orthographic view one so far away
 * that the difference moves no shadow by half a pixel, and by less than rounding the light to its vertex would. */
bool tia_reach_is_direction(const struct tia_reach *reach, const struct tia_light *light);

/* Returns the largest range of a light's point: that of raster.h; in orthographic views, which have fewer bits, the one
 * whose vertices are rounded by less than half a pixel, or that of the faces. */
unsigned tia_reach_of_lights(const struct tia_reach *reach);

/* Returns the index of the first light beyond tia_reach_of_lights, or `count`. */
uint32_t tia_reach_too_far(const struct tia_reach *reach, const struct tia_light *lights, uint32_t count);

/* Returns the range for the scene's faces with these lights, of which none is too far: the same for the scene's own
 * lights and their states after keys, up to four times as far away, so that hits stay valid; more for others. */
unsigned tia_reach_with_lights(const struct tia_reach *reach, const struct tia_scene *scene,
                               const struct tia_light *lights, uint32_t count);

#endif
