/* oracle.h - the same pictures computed a second time, to check the library against.
 *
 * Brute force in double precision: each formula of the ray tracer written down once, in the order
 * in which a textbook has it, with no thought for speed. It shares no code with the library, only
 * the public structs of a scene, whose integers it converts to double exactly. */
#ifndef TESTS_ORACLE_ORACLE_H
#define TESTS_ORACLE_ORACLE_H

#include "pixel.h"

/* Returns the unit direction of the ray through the centre of pixel (x, y). */
struct oracle_vec oracle_direction(const struct tia_camera *camera, unsigned width, unsigned height, double x,
                                   double y);

/* Intersects a ray (unit direction) with a sphere by the ray's point nearest to the centre. Returns true for a hit,
 * with the distance in *t. A sphere whose centre is behind the origin is missed. */
bool oracle_sphere_geometric(struct oracle_vec origin, struct oracle_vec direction, struct oracle_vec centre,
                             double radius, double *t);

/* Intersects a ray with a sphere by the smaller root not below 0 of |O + tD - C|^2 = r^2. The result differs from
 * oracle_sphere_geometric only for a ray that starts inside and leads away from the centre. */
bool oracle_sphere_analytic(struct oracle_vec origin, struct oracle_vec direction, struct oracle_vec centre,
                            double radius, double *t);

/* Returns the element in row y & 7, column x & 7 of the 8x8 matrix M(8): M(1) = 0, M(2n) = [4M, 4M+2; 4M+3, 4M+1]. */
unsigned oracle_bayer(unsigned x, unsigned y);

/* Returns the pixel at (x, y) of the width x height image of `scene`, without its colour and margin; the centre of
 * pixel (1, 2) is at (1, 2). */
struct oracle_pixel oracle_look(const struct tia_scene *scene, unsigned width, unsigned height, double x, double y);

/* Sets the colour, from `linear`, and the margin of a pixel; returns the colour. */
tia_rgb565 oracle_pack(struct oracle_pixel *pixel, unsigned x, unsigned y, bool dither);

/* Returns pixel (x, y) with all fields. */
struct oracle_pixel oracle_pixel(const struct tia_scene *scene, unsigned width, unsigned height, unsigned x, unsigned y,
                                 bool dither);

/* The oracle's bias. A variant with this bias, and 0 in all other fields, gives the same pixels as oracle_pixel. */
#define ORACLE_BIAS (1.0 / 8192.0)

/* Details in which other programs differ, for scenes of spheres. */
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

/* True if the oracle finds a different object or different lights `reach` pixels beside the pixel's centre. There its
 * rounding errors, about 1e-12 of a pixel, may decide the result. */
bool oracle_undecided(const struct tia_scene *scene, unsigned width, unsigned height, unsigned x, unsigned y,
                      double reach);

#endif
