/* diffuse.h - colours of flat faces without gloss, many times faster than with a ray for each pixel, and bit for bit
 * the same. A colour is computed to 20 bits, with an error bound. It is used if the whole interval rounds to one level
 * of the display. whitted_light_tile draws the other pixels.
 *
 * The visible point of a pixel is at P = D r from the eye; r is linear in x and y. A light at L gives max(0, N.w/|w|),
 * where w = L - P. Positions are in units of 2^-bits, and below 2^38. Coordinates of r are below 4. Errors are up to
 * 2^-24 in a coordinate of r, 2^-20 in a coordinate of N, and 2^-29 D + 1 in D. So the error of P is up to 2^-23 D + 9.
 * If |w| is at least D/64 and 2^20, the error of N.w/|w| is below 2^-15.6, and in whitted_light_tile below 2^-30. The
 * bound is 2^-14, three times the sum of both. */
#ifndef TIA_RENDER_HYBRID_DIFFUSE_H
#define TIA_RENDER_HYBRID_DIFFUSE_H

#include "flat/world.h"
#include "render/trace/trace.h"
#include "shadow/technique.h"

#define DIFFUSE_LIGHTS 8

struct diffuse_light {
    enum tia_light_kind kind; /* point, spot, directional or ambient */
    unsigned bit;             /* the light's number in the pixels' bits and shares */
    int64_t at[3];            /* position relative to the eye; of a directional light: the direction to it, Q.30 */
    int32_t emission[3];      /* Q2.30 */
    int64_t back[3];          /* spot light: the opposite of its direction, Q.20 */
    int64_t inner, outer;     /* spot light: cosines, Q.30: above `inner` its light is certainly full, below `outer`
                               * certainly 0 */
};

/* A face, with the normal turned to the eye. */
struct diffuse_face {
    uint32_t face;
    bool fits;         /* the face can be drawn here: it is flat and without gloss */
    int64_t normal[3]; /* Q.20 */
    const struct tia_material *material;
};

struct diffuse {
    const struct ray_view *rays;
    const struct tia_flat_scene *flat;
    struct tia_world world;
    int bits;
    int64_t most; /* coordinates of P are smaller than this */
    int64_t row[3], right[3];
    int64_t row_y;
    unsigned light_count;
    struct diffuse_light lights[DIFFUSE_LIGHTS];
    struct diffuse_face face; /* face of the last pixel */
};

/* A pixel's values in the hit buffers. */
struct diffuse_pixel {
    int x, y;
    uint32_t face; /* TIA_NO_FACE: background */
    uint64_t nearness, lit;
    const tia_share *shares; /* NULL: all light arrives */
};

/* Prepares a view. Returns false if no pixel of the view can be drawn in this way. `first_bit` is as in struct
 * first_hits. */
bool diffuse_init(struct diffuse *m, const struct tia_view *view, const struct tia_shadow_view *shadow,
                  const uint8_t *first_bit);

/* Computes a pixel's colour. Returns false if it is uncertain, or if the face does not fit. */
bool diffuse_pixel(struct diffuse *m, const struct diffuse_pixel *p, num_u threshold, tia_rgb565 *out);

#endif
