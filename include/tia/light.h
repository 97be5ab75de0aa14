/* light.h - light sources.
 *
 * Except for ambient lights, a light reaches a point at the distance d with the attenuation
 * 1/(constant + linear d + quadratic d^2), as in OpenGL, and casts shadows; d is in the file's units, see scene.h. When
 * all three factors are 0, and for directional lights, there is no attenuation; where the sum is 2^17 or more, no light
 * arrives.
 *
 * An ambient light with a radius is occluded by objects within that distance of the lit point: it is multiplied by the
 * point's openness, see TIA_OCCLUSION in integrator.h, estimated by `samples` rays.
 *
 * A light whose radius or sides are not 0 is visible from all sides as a surface that shows its emission.
 * Shadow rays pass through it. An area light's contribution is the mean over its samples, each of which
 * lights like a point light.
 */
#ifndef TIA_LIGHT_H
#define TIA_LIGHT_H

#include <tia/vec.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Traits of a kind of light: its place, its fields in struct tia_light, its surface, and the renderers that draw it. */
enum tia_light_trait {
    TIA_LIGHT_FAR = 1,             /* infinitely far away, along `direction` */
    TIA_LIGHT_EVERYWHERE = 1 << 1, /* shines equally on every point, without shadows; other kinds shine along rays */
    TIA_LIGHT_DIRECTION = 1 << 2,  /* has `direction` */
    TIA_LIGHT_CONE = 1 << 3,       /* has `inner` and `outer` */
    TIA_LIGHT_RADIUS = 1 << 4,     /* has `radius` */
    TIA_LIGHT_SIDES = 1 << 5,      /* has `side`: the surface is a parallelogram with these half sides */
    TIA_LIGHT_SAMPLED = 1 << 6,    /* has `samples` */
    TIA_LIGHT_AREA = 1 << 7,       /* its samples are points of an area; other kinds have one sample, their centre */
    TIA_LIGHT_BALL = 1 << 8,       /* its surface is a sphere; its area, if any, is the disc that faces the lit point */
    TIA_LIGHT_DISC = 1 << 9,       /* its surface is a disc, with its normal along `direction` */
    TIA_LIGHT_PATHS = 1 << 10,     /* sampled by TIA_PATHS */
    TIA_LIGHT_TECHNIQUES =
        1 << 11,               /* supported by the techniques for shadows, see shadow.h; TIA_FILTER_PCSS supports all */
    TIA_LIGHT_SPANS = 1 << 12, /* drawn by the span renderer */
    TIA_LIGHT_SIMD = 1 << 13   /* drawn by vector units; scenes with other kinds take the fixed-point path */
};

/* Lights without a position, and so without attenuation. */
#define TIA_LIGHT_PLACELESS (TIA_LIGHT_FAR | TIA_LIGHT_EVERYWHERE)

/* Lights with a surface. */
#define TIA_LIGHT_SURFACE (TIA_LIGHT_SIDES | TIA_LIGHT_BALL | TIA_LIGHT_DISC)

/* Every kind of light: its name, its word in scene files, its name in messages, and its traits. All tables of kinds are
 * generated from this list. A new kind is appended to it, see docs/architecture.md.
 *
 *     point        shines from its centre; looks like a sphere of its radius
 *     directional  infinitely far away, shines along `direction`
 *     ambient      the same everywhere, from all directions, without shadows
 *     spot         from its centre, along `direction`: full inside the inner cone, none outside the outer cone; between
 *                  them times (cos a - cos outer)/(cos inner - cos outer) at the angle a from the axis
 *     rectangle    sampled at the points centre + s side[0] + t side[1], |s|, |t| <= 1
 *     disc         sampled on the disc around its centre whose normal is along `direction`
 *     sphere       sampled on the disc through its centre that faces the lit point */
#define TIA_LIGHTS(LIGHT)                                                                                              \
    LIGHT(TIA_POINT_LIGHT, point, "a point light",                                                                     \
          TIA_LIGHT_RADIUS | TIA_LIGHT_BALL | TIA_LIGHT_PATHS | TIA_LIGHT_TECHNIQUES | TIA_LIGHT_SPANS |               \
              TIA_LIGHT_SIMD)                                                                                          \
    LIGHT(TIA_DIRECTIONAL_LIGHT, directional, "a directional light",                                                   \
          TIA_LIGHT_FAR | TIA_LIGHT_DIRECTION | TIA_LIGHT_PATHS | TIA_LIGHT_TECHNIQUES | TIA_LIGHT_SIMD)               \
    LIGHT(TIA_AMBIENT_LIGHT, ambient, "an ambient light",                                                              \
          TIA_LIGHT_EVERYWHERE | TIA_LIGHT_RADIUS | TIA_LIGHT_SAMPLED | TIA_LIGHT_TECHNIQUES | TIA_LIGHT_SIMD)         \
    LIGHT(TIA_SPOT_LIGHT, spot, "a spot light",                                                                        \
          TIA_LIGHT_DIRECTION | TIA_LIGHT_CONE | TIA_LIGHT_PATHS | TIA_LIGHT_TECHNIQUES | TIA_LIGHT_SIMD)              \
    LIGHT(TIA_RECTANGLE_LIGHT, rectangle, "a rectangle light",                                                         \
          TIA_LIGHT_SIDES | TIA_LIGHT_SAMPLED | TIA_LIGHT_AREA | TIA_LIGHT_PATHS | TIA_LIGHT_TECHNIQUES |              \
              TIA_LIGHT_SIMD)                                                                                          \
    LIGHT(TIA_DISC_LIGHT, disc, "a disc light",                                                                        \
          TIA_LIGHT_DIRECTION | TIA_LIGHT_RADIUS | TIA_LIGHT_SAMPLED | TIA_LIGHT_AREA | TIA_LIGHT_DISC |               \
              TIA_LIGHT_PATHS | TIA_LIGHT_TECHNIQUES | TIA_LIGHT_SIMD)                                                 \
    LIGHT(TIA_SPHERE_LIGHT, sphere, "a sphere light",                                                                  \
          TIA_LIGHT_RADIUS | TIA_LIGHT_SAMPLED | TIA_LIGHT_AREA | TIA_LIGHT_BALL | TIA_LIGHT_PATHS | TIA_LIGHT_SIMD)

#define TIA_LIGHT_KIND(KIND, name, what, traits) KIND,
enum tia_light_kind { TIA_LIGHTS(TIA_LIGHT_KIND) };
#undef TIA_LIGHT_KIND

#define TIA_LIGHT_ONE(KIND, name, what, traits) +1
enum { TIA_LIGHT_KINDS = TIA_LIGHTS(TIA_LIGHT_ONE) };
#undef TIA_LIGHT_ONE

/* Inlined even with -Os: a call takes more code than the comparisons that remain for constant traits. */
#ifdef __GNUC__
#define TIA_LIGHT_INLINE static inline __attribute__((always_inline))
#else
#define TIA_LIGHT_INLINE static inline
#endif

/* True if the kind has one of these traits; false for a number that is no kind. */
TIA_LIGHT_INLINE bool tia_light_has(enum tia_light_kind kind, unsigned traits)
{
#define TIA_LIGHT_HAS(KIND, name, what, has) || (kind == KIND && (traits & (has)))
    return false TIA_LIGHTS(TIA_LIGHT_HAS);
#undef TIA_LIGHT_HAS
}

#define TIA_LIGHT_SAMPLES_DEFAULT 16 /* samples of an area light */
#define TIA_LIGHT_SAMPLES_MAX 256

struct tia_light {
    struct tia_vec3 centre;
    tia_q16 radius; /* point, disc and sphere lights: 0 (invisible), or TIA_RADIUS_MIN or more; ambient lights: 0, or
                       the distance up to which objects occlude them, see above */
    struct tia_rgb emission; /* each channel in [0, 2) */
    enum tia_light_kind kind;
    struct tia_dir3 direction;           /* length 0.5..1.5; it is normalised */
    tia_q16 inner, outer;                /* degrees from the axis: 0 <= inner <= outer <= 90, outer >= 1 */
    struct tia_vec3 side[2];             /* half of each side of a rectangle: both 0, or not parallel */
    tia_q16 constant, linear, quadratic; /* attenuation, each 0..TIA_Q16(32767) */
    uint16_t samples;                    /* area lights, ambient lights with a radius: 1..TIA_LIGHT_SAMPLES_MAX; 0 is
                                            TIA_LIGHT_SAMPLES_DEFAULT */
    uint8_t emission_bits; /* TIA_PATHS: emission is 2^emission_bits times as large, 0..TIA_EMISSION_BITS_MAX */
    int8_t unit_bits;      /* the attenuation's unit of length is 2^unit_bits units of the file; unit_bits + the scene's
                              scale_bits is 0..30 */
};

/* The sample points of an area light with n samples are fixed, so that every machine draws the same picture.
 * They differ between neighbouring pixels, which turns banding into fine noise: pixel (x, y) has the offset
 * b = bayer[y mod 4][x mod 4] from the 4 x 4 Bayer matrix 0 8 2 10 / 12 4 14 6 / 3 11 1 9 / 15 7 13 5.
 * With r the base-2 radical inverse (0, 1/2, 1/4, 3/4, ...), sample i is
 *
 *     u = frac((i + 1/2)/n + b/16),   v = frac(r(i) + r(b)).
 *
 * On a rectangle s = 2u - 1 and t = 2v - 1. On a disc of radius R, sample i is at the distance R sqrt(u) from the
 * centre and at the angle 2 pi v from A towards B, where with the disc's normal N
 *
 *     A = normalise(e x N), B = N x A,
 *
 * and e is the unit vector along the axis of N's smallest coordinate in magnitude (the first of equals). */

#ifdef __cplusplus
}
#endif

#endif
