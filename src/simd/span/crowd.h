/* crowd.h - spheres with more casters for a light than a lamp takes: the lamps of a few pixels, with the casters near
 * these. */
#ifndef TIA_SIMD_SPAN_CROWD_H
#define TIA_SIMD_SPAN_CROWD_H

#include "pair.h"
#include "render/span/span_shade.h"

#define SIMD_CROWD 1024 /* largest number of pixels whose casters are found at once */

struct simd_crowd {
    struct shaded_span span; /* of one sphere, in a row */
    num_u t[SIMD_CROWD];     /* its distances, as far as they are needed */
    struct span_shadows shadows;
    bool some[SIMD_LIGHTS];
    uint8_t near[SIMD_LIGHTS][(TIA_SPAN_SPHERES + 7) / 8]; /* the spheres that may block a light at some pixel */
    struct simd_lamp lamp[SIMD_LIGHTS];                    /* of the last piece */
    struct simd_caster cast[SIMD_LIGHTS][SIMD_CASTS];
};

/* True if some light has too many casters for a sphere's own lamps. */
bool tia_simd_is_crowded(const struct tia_view *view, uint32_t sphere);

/* Finds the casters near pixels first..end-1 of row y, at most SIMD_CROWD, which show a sphere. The view has at most
 * SIMD_LIGHTS lights. */
void tia_simd_crowd(const struct tia_view *view, uint32_t sphere, int y, int first, int end, struct simd_crowd *crowd);

/* Gives the lamps of pixels first..end-1 among these; false if some light has too many casters near them. */
bool tia_simd_crowd_lamps(const struct tia_view *view, struct simd_crowd *crowd, int first, int end);

#endif
