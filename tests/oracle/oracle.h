/* oracle.h - the same pictures computed a second time, to check the library against.
 *
 * Brute force in double precision: each formula of the ray tracer written down once, in the order
 * in which a textbook has it, with no thought for speed. It shares no code with the library, only
 * the public structs of a scene, whose integers it converts to double exactly.
 */
#ifndef TESTS_ORACLE_ORACLE_H
#define TESTS_ORACLE_ORACLE_H

#include "pixel.h"

/* Returns the unit direction of the ray through the centre of pixel (x, y). */
struct oracle_vec oracle_direction(const struct tia_camera *camera, unsigned width, unsigned height, double x,
                                   double y);

/* Intersect a ray (unit direction) with a sphere; true and the distance when it hits. Geometric: by the ray's point
 * nearest to the centre; a sphere whose centre is behind is missed. Analytic: the smaller root not below 0 of |O + tD -
 * C|^2 = r^2. The two differ only for a ray that starts inside and leads away from the centre. */
bool oracle_sphere_geometric(struct oracle_vec origin, struct oracle_vec direction, struct oracle_vec centre,
                             double radius, double *t);
bool oracle_sphere_analytic(struct oracle_vec origin, struct oracle_vec direction, struct oracle_vec centre,
                            double radius, double *t);

/* Returns row y & 7, column x & 7 of the 8x8 matrix M(8): M(1) = 0, M(2n) = [4M, 4M+2; 4M+3, 4M+1]. */
unsigned oracle_bayer(unsigned x, unsigned y);

/* Returns the pixel at (x, y) of the width x height image of `scene`, where pixel (1, 2) has its centre at (1, 2); its
 * colour and margin are not set. */
struct oracle_pixel oracle_look(const struct tia_scene *scene, unsigned width, unsigned height, double x, double y);
tia_rgb565 oracle_pack(struct oracle_pixel *pixel, unsigned x, unsigned y, bool dither);

/* Returns pixel (x, y) with all fields. */
struct oracle_pixel oracle_pixel(const struct tia_scene *scene, unsigned width, unsigned height, unsigned x, unsigned y,
                                 bool dither);

/* Details of a scene of spheres in which other programs differ; with ORACLE_BIAS and all else 0 it is the oracle. */
#define ORACLE_BIAS (1.0 / 8192.0)
struct oracle_variant {
    double bias;        /* distance from a surface along its normal to the start of its shadow rays */
    bool colour_passes; /* a blocker transmits its colour instead of its transmission */
    bool beyond_light;  /* spheres behind the light block it too */
    bool quadratic;     /* spheres are intersected by oracle_sphere_analytic */
    /* directions and normals are rounded to multiples of 2^-direction_bits; 0: not rounded */
    unsigned direction_bits;
};
struct oracle_pixel oracle_variant_pixel(const struct tia_scene *scene, struct oracle_variant variant, unsigned width,
                                         unsigned height, unsigned x, unsigned y);

/* The oracle as one of the library's arithmetics; its lights cannot be replaced. */
extern const struct tia_core oracle_core;

/* True if the oracle itself finds a different object, or different lights, `reach` pixels beside the pixel's centre:
 * its rounding errors, some 1e-12 of a pixel, decide there. */
bool oracle_undecided(const struct tia_scene *scene, unsigned width, unsigned height, unsigned x, unsigned y,
                      double reach);

#endif
