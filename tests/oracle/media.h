/* media.h - the media that a ray is inside of, as tia/material.h defines them. */
#ifndef TESTS_ORACLE_MEDIA_H
#define TESTS_ORACLE_MEDIA_H

#include <tia/scene.h>

/* The objects that a ray has entered, the last one at the end. */
struct media {
    unsigned count;
    uint32_t object[TIA_MEDIA_MAX];
    tia_q16 index[TIA_MEDIA_MAX];
};

/* The two indices of refraction at a boundary. */
struct crossing {
    tia_q16 from, to;
};

/* Returns the boundary where a refracted ray meets the front or back of an object, which has that material there;
 * `media` become those behind it. */
struct crossing media_cross(const struct tia_scene *scene, struct media *media, uint32_t object, bool front,
                            const struct tia_material *material);

/* True if the object can be entered. */
bool media_has_inside(const struct tia_scene *scene, uint32_t object);

#endif
