/* rays.h - Whitted's rays: the oracle for the scenes that spans do not draw.
 *
 * Recursive, each ray against each object, in the order of the formulas of tia/material.h. */
#ifndef TESTS_ORACLE_RAYS_H
#define TESTS_ORACLE_RAYS_H

#include <math.h>

#include "shape.h"

/* Between a surface and the rays that start there. */
static inline double oracle_bias(const struct tia_scene *scene)
{
    double own = scene->scale_bits < 0 ? ldexp(1.0 / 8192, scene->scale_bits) : 1.0 / 8192;

    return scene->fine || own < 1.0 / 67108864 ? 1.0 / 67108864 : own;
}

/* Whether a scene asks for general rays, see tia/scene.h. */
bool oracle_needs_rays(const struct tia_scene *scene);

/* As oracle_look. The pixel's object and depth are those of its first sample. */
struct oracle_pixel oracle_rays_look(const struct tia_scene *scene, unsigned width, unsigned height, double x,
                                     double y);

/* The camera's ray through the place (x, y) of the image, its upper left corner being (0, 0). */
struct ray oracle_camera(const struct tia_camera *camera, const struct tia_fine *fine, unsigned width, unsigned height,
                         double x, double y);

/* Sample n of a pixel whose upper left corner is (0, 0), of samples a pixel, 1, 4 or 16. */
void oracle_sample(unsigned samples, unsigned n, double *x, double *y);

/* The texture at surface coordinates u, v, an opacity as a grey; *cell is the texel, the checker's colour, or
 * ORACLE_BLENDED. */
#define ORACLE_BLENDED UINT32_MAX
struct colour oracle_texture(const struct tia_texture *texture, double u, double v, uint32_t *cell);

/* The opacity of a hit's material; *cell as above. */
double oracle_opacity(const struct tia_scene *scene, const struct hit *hit, uint32_t *cell);

/* What is left of white light on its way to the ray's origin from `distance` along it. */
struct colour oracle_transmission(const struct tia_scene *scene, struct ray ray, double distance);

/* The part of unpolarised light that is reflected where it passes, at an angle of that cosine, from index n1
 * to n2; 1 when it cannot pass. */
double oracle_fresnel(double cosine, double n1, double n2);

/* What a ray that leads to the pixel (x, y) sees, black when it is no longer traced. */
struct colour oracle_ray(const struct tia_scene *scene, struct ray ray, unsigned x, unsigned y);

#endif
