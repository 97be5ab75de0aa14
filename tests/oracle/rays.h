/* rays.h - Whitted's rays: the oracle for the scenes that the span renderer does not draw.
 *
 * It is recursive, and tests each ray against each object, in the order of the formulas of tia/material.h. */
#ifndef TESTS_ORACLE_RAYS_H
#define TESTS_ORACLE_RAYS_H

#include <math.h>

#include "shape.h"

/* Returns the distance between a surface and the start of rays from it. */
static inline double oracle_bias(const struct tia_scene *scene)
{
    double own = scene->scale_bits < 0 ? ldexp(1.0 / 8192, scene->scale_bits) : 1.0 / 8192;

    return scene->fine || own < 1.0 / 67108864 ? 1.0 / 67108864 : own;
}

/* True if a scene needs general rays, see tia/scene.h. */
bool oracle_needs_rays(const struct tia_scene *scene);

/* Returns a pixel as oracle_look does; its object and depth are those of its first sample. */
struct oracle_pixel oracle_rays_look(const struct tia_scene *scene, unsigned width, unsigned height, double x,
                                     double y);

/* Returns the camera's ray through (x, y) of the image, whose upper left corner is (0, 0). */
struct ray oracle_camera(const struct tia_camera *camera, const struct tia_fine *fine, unsigned width, unsigned height,
                         double x, double y);

/* Computes the position of sample n relative to the upper left corner of a pixel with 1, 4 or 16 samples. */
void oracle_sample(unsigned samples, unsigned n, double *x, double *y);

/* The value of *cell if several texels are blended. */
#define ORACLE_BLENDED UINT32_MAX

/* Returns the texture's colour at the surface coordinates u, v; an opacity is a grey. *cell is the index of the texel,
 * the number of the checker's colour, or ORACLE_BLENDED. */
struct colour oracle_texture(const struct tia_texture *texture, double u, double v, uint32_t *cell);

/* Returns one octave of noise at a point in its own units. */
double oracle_octave(struct oracle_vec p, uint32_t octave);

/* Returns the value of a noise at a point of a shape's axes, not clamped. */
double oracle_noise(const struct tia_texture *texture, struct oracle_vec p);

/* Returns the opacity of the material at a hit; *cell as from oracle_texture. */
double oracle_opacity(const struct tia_scene *scene, const struct hit *hit, uint32_t *cell);

/* Returns the fraction of white light that reaches the ray's origin from `distance` along it. */
struct colour oracle_transmission(const struct tia_scene *scene, struct ray ray, double distance);

/* Returns the reflectance of unpolarised light at a boundary from index n1 to n2, for the cosine of the angle of
 * incidence; 1 in total reflection. */
double oracle_fresnel(double cosine, double n1, double n2);

/* Returns the colour along a ray of pixel (x, y); black if the ray is too faint or too deep to be traced. */
struct colour oracle_ray(const struct tia_scene *scene, struct ray ray, unsigned x, unsigned y);

#endif
