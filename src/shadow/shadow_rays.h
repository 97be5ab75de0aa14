/* shadow_rays.h - exact shadow rays from a pixel's visible point to the light, face by face, see occluder.h. */
#ifndef TIA_SHADOW_SHADOW_RAYS_H
#define TIA_SHADOW_SHADOW_RAYS_H

#include "casters.h"
#include "technique.h"

#define TIA_OCCLUDERS 16

/* Data shared between neighbouring pixels, which mostly have the same occluder. */
struct tia_shadow_rays {
    const struct tia_flat_scene *flat;
    const struct tia_casters *casters;
    const tia_flat_light *light;
    struct tia_shadow_tile *tile;
    unsigned sample;
    struct cancel *cancel;
    struct tia_seen_face of;
    bool turned;
    uint32_t last;                               /* last face that hid the light */
    struct tia_occluder occluder[TIA_OCCLUDERS]; /* a cache: face f has its occluder at f mod TIA_OCCLUDERS */
};

/* Lights pixel (x, y). */
void tia_shadow_rays_pixel(struct tia_shadow_rays *rays, int x, int y);

/* True if a face hides the light from pixel (x, y), whose face must be turned to the light. */
bool tia_shadow_rays_hides(struct tia_shadow_rays *rays, uint32_t face, int x, int y);

/* Does the work of `light` in struct tia_shadow_technique, by rays. */
void tia_shadow_rays_light(const struct tia_shadow_view *view, const struct tia_casters *casters,
                           struct tia_shadow_tile *tile, unsigned sample, struct cancel *cancel);

#endif
