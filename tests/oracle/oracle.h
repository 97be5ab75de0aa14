/* oracle.h - the same pictures computed a second time, to check the library against.
 *
 * Brute force in double precision: each formula of the ray tracer written down once, in the order
 * in which a textbook has it, with no thought for speed. It shares no code with the library, only
 * the public structs of a scene, whose integers it converts to double exactly.
 */
#ifndef TESTS_ORACLE_ORACLE_H
#define TESTS_ORACLE_ORACLE_H

#include "pixel.h"

/* The unit direction of the ray through the centre of pixel (x, y). */
struct oracle_vec oracle_direction(const struct tia_camera *camera, unsigned width, unsigned height, double x,
                                   double y);

/* A ray (unit direction) against a sphere; true and the distance when it hits.
 * Geometric: by the ray's point nearest to the centre; a sphere whose centre is behind is missed.
 * Analytic: the smaller root not below 0 of |O + tD - C|^2 = r^2. The two differ only for a ray
 * that starts inside and leads away from the centre. */
bool oracle_sphere_geometric(struct oracle_vec origin, struct oracle_vec direction, struct oracle_vec centre,
                             double radius, double *t);
bool oracle_sphere_analytic(struct oracle_vec origin, struct oracle_vec direction, struct oracle_vec centre,
                            double radius, double *t);

/* Row y & 7, column x & 7 of the 8x8 matrix M(8): M(1) = 0, M(2n) = [4M, 4M+2; 4M+3, 4M+1]. */
unsigned oracle_bayer(unsigned x, unsigned y);

/* What is seen through the place (x, y) of the width x height image of `scene`, where pixel (1, 2) has
 * its centre at (1, 2); without colour and margin. And these two, from the rest. */
struct oracle_pixel oracle_look(const struct tia_scene *scene, unsigned width, unsigned height, double x, double y);
tia_rgb565 oracle_pack(struct oracle_pixel *pixel, unsigned x, unsigned y, bool dither);

/* Both in one: pixel (x, y). */
struct oracle_pixel oracle_pixel(const struct tia_scene *scene, unsigned width, unsigned height, unsigned x, unsigned y,
                                 bool dither);

/* Details of a scene of spheres that other programs have otherwise; with ORACLE_BIAS and all else 0 it is the oracle.
 */
#define ORACLE_BIAS (1.0 / 8192.0)
struct oracle_variant {
    double bias;             /* from a surface along its normal to the start of its shadow rays */
    bool colour_passes;      /* a blocker lets its colour through, instead of its transmission */
    bool beyond_light;       /* spheres behind the light block it too */
    bool quadratic;          /* spheres by oracle_sphere_analytic */
    unsigned direction_bits; /* directions and normals are rounded to multiples of 2^-this; 0: not rounded */
};
struct oracle_pixel oracle_variant_pixel(const struct tia_scene *scene, struct oracle_variant variant, unsigned width,
                                         unsigned height, unsigned x, unsigned y);

/* The oracle as the library's arithmetics are: but its lights cannot be replaced. */
extern const struct tia_core oracle_core;

/* Whether the oracle itself sees another object, or other lights, when it looks `reach` pixels beside
 * the pixel's centre: its rounding errors, some 1e-12 of a pixel, decide what is there. */
bool oracle_undecided(const struct tia_scene *scene, unsigned width, unsigned height, unsigned x, unsigned y,
                      double reach);

#endif
