/* light.h - lights as sources and as visible surfaces. */
#ifndef TESTS_ORACLE_LIGHT_H
#define TESTS_ORACLE_LIGHT_H

#include "shape.h"

/* Light that arrives at a point. */
struct beam {
    struct oracle_vec direction; /* direction to the light, of length 1 */
    struct oracle_vec source;    /* the light's point; undefined for a directional light */
    double distance;             /* distance to `source`; infinite for a directional light */
    double strength;             /* product of attenuation, spot falloff and the sample's share */
};

/* Returns the number of samples of a light; 1 for all but area lights. */
unsigned light_samples(const struct tia_light *light);

/* Computes sample i of a light that is not ambient, for the point p and a pixel of class 0..15. Returns false if the
 * sample is at p. `unit` is the unit of length of attenuations. */
bool light_beam(const struct tia_light *light, double unit, struct oracle_vec p, unsigned pixel_class, unsigned i,
                struct beam *beam);

/* Returns the class of pixel (x, y), 0..15. */
unsigned light_class(unsigned x, unsigned y);

/* Computes point i of n in the unit square, for pixels of a class. */
void light_pattern(unsigned pixel_class, unsigned i, unsigned n, double *u, double *v);

/* Intersects a ray with the surface of the light itself. *t is the parameter of the hit. */
bool light_hit(const struct tia_light *light, struct ray ray, double *t);

#endif
