/* diffuse.h - colours of flat faces without gloss, many times as fast as by a ray for each pixel and with the same
 * bits: they are computed to 20 bits with an error bound, and used where the whole interval rounds to one level of the
 * display. Other pixels are left to whitted_light_tile.
 *
 * The visible point of a pixel is at P = D r from the eye, r linear in x and y; a light at L gives max(0, N.w/|w|), w =
 * L - P. Positions are in units of 2^-bits, at most 2^38 of them. With r within 2^-25, D within 2^-29 and 1, and N
 * within 2^-20, P is within 2^-23.8 D + 4; where |w| is at least D/64 and 2^20, N.w/|w| errs by less than 2^-16, and
 * that of whitted_light_tile by less than 2^-30. The bound is four times that. */
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
    int64_t inner, outer;     /* spot light: the cosines, Q.30, beyond which it is certainly full or dark */
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
    int64_t most; /* largest coordinate of P */
    int64_t row[3], right[3];
    int64_t row_y;
    unsigned light_count;
    struct diffuse_light lights[DIFFUSE_LIGHTS];
    struct diffuse_face face; /* the last face */
};

/* A pixel's buffers. */
struct diffuse_pixel {
    int x, y;
    uint32_t face; /* TIA_NO_FACE: background */
    uint64_t nearness, lit;
    const tia_share *shares; /* NULL: all light arrives */
};

/* Prepares a view; false when none of its pixels can be drawn in this way. `first_bit` as in struct first_hits. */
bool diffuse_init(struct diffuse *m, const struct tia_view *view, const struct tia_shadow_view *shadow,
                  const uint8_t *first_bit);

/* Draws a pixel; false when it is uncertain. */
bool diffuse_pixel(struct diffuse *m, const struct diffuse_pixel *p, num_u threshold, tia_rgb565 *out);

#endif
