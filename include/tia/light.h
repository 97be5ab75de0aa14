/* light.h - what shines.
 *
 * Every light but the ambient one lights by L, the direction from the lit point to it, over the
 * distance d, with the attenuation 1/(constant + linear d + quadratic d^2) - none when all three are 0,
 * and none from a directional light; nothing is left when the sum is 2^17 or more - and casts shadows.
 * Lights themselves cast none. Those with a shape and a radius or sides that are not 0 are seen by all but
 * shadow rays, from all sides, as a surface of their emission. An area light is the mean of its samples,
 * each of which lights like a point.
 */
#ifndef TIA_LIGHT_H
#define TIA_LIGHT_H

#include <tia/vec.h>

enum tia_light_kind {
    TIA_POINT_LIGHT,       /* lights from its centre; seen as a sphere of its radius: the thesis's light */
    TIA_DIRECTIONAL_LIGHT, /* from infinitely far away, along `direction` */
    TIA_AMBIENT_LIGHT,     /* everywhere, from everywhere, without shadow */
    TIA_SPOT_LIGHT,        /* from its centre, along `direction`: full within the inner cone, none outside
                              the outer one, between them (cos a - cos outer)/(cos inner - cos outer) */
    TIA_RECTANGLE_LIGHT,   /* from samples of the points centre + s side[0] + t side[1], |s|, |t| <= 1 */
    TIA_DISC_LIGHT,        /* from samples of the disc around the centre, its normal along `direction` */
    TIA_SPHERE_LIGHT       /* from samples of the disc that the sphere turns to the lit point */
};

#define TIA_LIGHT_SAMPLES 16 /* of an area light that names no other number */
#define TIA_LIGHT_SAMPLES_MAX 256

struct tia_light {
    struct tia_vec3 centre;
    tia_q16 radius;          /* 0 (not seen), or TIA_RADIUS_MIN or more; of point, disc and sphere lights */
    struct tia_rgb emission; /* each channel in [0, 2) */
    enum tia_light_kind kind;
    struct tia_dir3 direction;           /* its length in 0.5..1.5: it is normalised */
    tia_q16 inner, outer;                /* degrees from the axis: 0 <= inner <= outer <= 90, outer >= 1 */
    struct tia_vec3 side[2];             /* half the sides of a rectangle: both 0, or not on one line */
    tia_q16 constant, linear, quadratic; /* each 0..TIA_Q16(32767) */
    uint16_t samples;                    /* of an area light, 1..TIA_LIGHT_SAMPLES_MAX; 0: TIA_LIGHT_SAMPLES */
};

/* The samples of an area light with n of them, the same everywhere. Pixel (x, y) belongs to the class
 * b = bayer[y mod 4][x mod 4] of the 4 x 4 Bayer matrix 0 8 2 10 / 12 4 14 6 / 3 11 1 9 / 15 7 13 5;
 * with r the base-2 radical inverse (0, 1/2, 1/4, 3/4, ...), point i is
 *
 *     u = frac((i + 1/2)/n + b/16),   v = frac(r(i) + r(b)).
 *
 * On a rectangle s = 2u - 1, t = 2v - 1; on a disc of radius R the point at the distance R sqrt(u) and
 * the angle 2 pi v from the first of two axes, which with the disc's normal N are
 *
 *     A = normalise(e x N), B = N x A, e the unit vector of N's coordinate nearest to 0 (a tie: the first). */

#endif
