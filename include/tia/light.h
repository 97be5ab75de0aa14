/* light.h - light sources.
 *
 * Except for ambient lights, a light reaches a point at the distance d with the attenuation
 * 1/(constant + linear d + quadratic d^2), as in OpenGL, and casts shadows; d is in the file's units, see scene.h. When
 * all three factors are 0, and for directional lights, there is no attenuation; where the sum is 2^17 or more, no light
 * arrives.
 *
 * An ambient light with a radius is occluded by objects within it: its light is multiplied by what TIA_OCCLUSION of
 * integrator.h would show up to that distance, the mean of `samples` rays.
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

enum tia_light_kind {
    TIA_POINT_LIGHT,       /* shines from its centre; looks like a sphere of its radius */
    TIA_DIRECTIONAL_LIGHT, /* infinitely far away, shines along `direction` */
    TIA_AMBIENT_LIGHT,     /* the same everywhere, from all directions, without shadows */
    TIA_SPOT_LIGHT,        /* from its centre, along `direction`: full inside the inner cone, none outside
                              the outer cone, between them (cos a - cos outer)/(cos inner - cos outer) */
    TIA_RECTANGLE_LIGHT,   /* samples the points centre + s side[0] + t side[1], |s|, |t| <= 1 */
    TIA_DISC_LIGHT,        /* samples the disc around its centre with its normal along `direction` */
    TIA_SPHERE_LIGHT       /* samples the disc through the centre that faces the lit point */
};

#define TIA_LIGHT_SAMPLES 16 /* the default for area lights */
#define TIA_LIGHT_SAMPLES_MAX 256

struct tia_light {
    struct tia_vec3 centre;
    tia_q16 radius; /* point, disc and sphere lights: 0 (invisible), or TIA_RADIUS_MIN or more; ambient lights: 0, or
                       the distance up to which objects occlude them, see above */
    struct tia_rgb emission; /* each channel in [0, 2) */
    enum tia_light_kind kind;
    struct tia_dir3 direction;           /* of a length in 0.5..1.5; it is normalised */
    tia_q16 inner, outer;                /* degrees from the axis: 0 <= inner <= outer <= 90, outer >= 1 */
    struct tia_vec3 side[2];             /* half the sides of a rectangle: both 0, or not parallel */
    tia_q16 constant, linear, quadratic; /* attenuation, each 0..TIA_Q16(32767) */
    uint16_t samples;                    /* area lights, ambient ones with a radius: 1..TIA_LIGHT_SAMPLES_MAX; 0 means
                                            TIA_LIGHT_SAMPLES */
    uint8_t emission_bits; /* of TIA_PATHS: emission is 2^emission_bits times as large, 0..TIA_EMISSION_BITS_MAX */
    int8_t unit_bits;      /* attenuation is in 2^unit_bits units of the file; with the scene's scale_bits 0..30 */
};

/* The sample points of an area light with n samples are fixed, so that every machine draws the same picture.
 * They differ between neighbouring pixels, which turns banding into fine noise: pixel (x, y) has the offset
 * b = bayer[y mod 4][x mod 4] from the 4 x 4 Bayer matrix 0 8 2 10 / 12 4 14 6 / 3 11 1 9 / 15 7 13 5.
 * With r the base-2 radical inverse (0, 1/2, 1/4, 3/4, ...), sample i is
 *
 *     u = frac((i + 1/2)/n + b/16),   v = frac(r(i) + r(b)).
 *
 * On a rectangle s = 2u - 1 and t = 2v - 1. On a disc of radius R it is the point at the distance R sqrt(u)
 * and the angle 2 pi v, measured from A towards B, where with the disc's normal N
 *
 *     A = normalise(e x N), B = N x A, e the unit vector of N's smallest coordinate in size (the first of equals). */

#ifdef __cplusplus
}
#endif

#endif
