/* volume_casters.h - the faces of a scene that cast a shadow volume, for the passes over them. */
#ifndef TIA_SHADOW_VOLUME_CASTERS_H
#define TIA_SHADOW_VOLUME_CASTERS_H

#include "scene/cancel.h"
#include "sides.h"

/* Sets the role of each face of the scene, a byte: on which side of it the light is, and which of its sides are part of
 * an object's silhouette. Returns TIA_OK, or TIA_STOPPED when cancelled. */
int tia_shadow_keep_roles(uint8_t *roles, const struct tia_flat_scene *flat, const tia_flat_light *light,
                          struct cancel *cancel);

/* A light sample. `roles`: as tia_shadow_keep_roles() sets them, or NULL: each pass finds them. */
struct tia_shadow_light {
    const tia_flat_light *at;
    const uint8_t *roles;
};

/* Returns tia_flat_side() of face number `face`. */
int tia_shadow_side(const struct tia_flat_scene *flat, uint32_t face, struct tia_shadow_light light);

/* A face that casts a shadow. Seen from the light, its corners run counterclockwise. */
struct tia_volume_caster {
    const struct tia_flat_face *face;
    uint32_t part; /* the part of the object: no face of it has an edge in another part */
    bool closed;   /* the object's silhouette suffices */
    bool turned;   /* the caster's corners run in the reverse order of the face's */
    unsigned sides;
    unsigned silhouette; /* bit k: side k, from corner k to the next, is part of the silhouette */
};

typedef int tia_caster_function(void *ctx, const struct tia_volume_caster *caster, uint32_t face);

/* Calls the function for each face that casts a shadow; of closed objects only for those with sides in the silhouette,
 * if `silhouettes` is set. Returns TIA_OK, TIA_STOPPED or the function's error. */
int tia_volume_casters(const struct tia_flat_scene *flat, struct tia_shadow_light light, bool silhouettes,
                       tia_caster_function *call, void *ctx, struct cancel *cancel);

#endif
