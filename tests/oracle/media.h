/* media.h - the media that contain a ray, as defined in tia/material.h. */
#ifndef TESTS_ORACLE_MEDIA_H
#define TESTS_ORACLE_MEDIA_H

#include <tia/scene.h>

/* The objects that a ray has entered, the last one at the end. */
struct media {
    unsigned count;
    uint32_t object[TIA_MEDIA_MAX];
    tia_q16 index[TIA_MEDIA_MAX];
};

/* Indices of refraction in front of a boundary and behind it. */
struct crossing {
    tia_q16 from, to;
};

/* Returns the indices at a boundary where a refracted ray meets the front or back of an object with this material.
 * `media` is updated to the media behind the boundary. */
struct crossing media_cross(const struct tia_scene *scene, struct media *media, uint32_t object, bool front,
                            const struct tia_material *material);

/* True if a ray can enter the object. */
bool media_has_inside(const struct tia_scene *scene, uint32_t object);

#endif
