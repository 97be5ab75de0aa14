/* crowd.h - spheres with many lights, or many casters for a light: pixels of a row with the casters near them, light by
 * light. */
#ifndef TIA_SIMD_SPAN_CROWD_H
#define TIA_SIMD_SPAN_CROWD_H

#include "pair.h"
#include "render/span/span_shade.h"

#define SIMD_CROWD_LISTS                                                                                               \
    64 /* lights whose lists are stored; those of more are made again when they are needed again                       \
        */

/* A bit for each sphere. */
#define SIMD_LIST ((TIA_SPAN_SPHERES + 7) / 8)

enum simd_known { SIMD_UNKNOWN, SIMD_NONE, SIMD_SOME };

struct simd_crowd {
    struct shaded_span span; /* the pixels */
    num_u t[SIMD_BLOCK];     /* their distances, as far as they are needed */
    struct span_shadows shadows;
    uint8_t known[SIMD_CROWD_LISTS]; /* enum simd_known */
    uint8_t list[SIMD_CROWD_LISTS][SIMD_LIST], last[SIMD_LIST];
    struct simd_lamp lamp; /* of the last light, with its casters */
    struct simd_caster cast[SIMD_CASTS];
};

/* True if a sphere has more lights, or more casters for some light, than are drawn at once. */
bool tia_simd_is_crowded(const struct tia_view *view, uint32_t sphere);

/* Begins with pixels first..end-1 of row y, at most SIMD_BLOCK, which show a sphere. */
void tia_simd_crowd(const struct tia_view *view, uint32_t sphere, int y, int first, int end, struct simd_crowd *crowd);

/* Returns the list of the spheres that may block a light at some of these pixels and not at others, a bit for each;
 * NULL if the light certainly reaches none of them. The list is valid until the next call. */
const uint8_t *tia_simd_crowd_list(const struct tia_view *view, struct simd_crowd *crowd, uint32_t light);

/* Returns the lamp of a light, with its casters; NULL if the light certainly reaches no pixel. */
const struct simd_lamp *tia_simd_crowd_lamp(const struct tia_view *view, struct simd_crowd *crowd, uint32_t light);

#endif
