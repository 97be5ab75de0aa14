/* shading.h - a point on a surface, prepared for an integrator. */
#ifndef TIA_RENDER_TRACE_SHADING_H
#define TIA_RENDER_TRACE_SHADING_H

#include "media.h"

struct shading {
    const struct tia_material *material;
    uint32_t object;
    struct num_point point;
    struct num_point outside;         /* P + b G: start of reflected and shadow rays */
    struct num_dir geometric, normal; /* G and N, turned to the viewer */
    struct num_dir viewer;            /* V */
    num_unit facing;                  /* N.V */
    bool back;                        /* the ray hits the back of the surface, where it leaves the object */
    num_length colour[3];             /* the diffuse colour, with the texture */
    num_length opacity;
    uint32_t texels[2]; /* results of ray_texture for the colour and the opacity */
    bool textured[2];   /* texels[i] is to be included in a path's hash */
};

/* Prepares the shading of a ray's hit; spawned rays start `bias` off the surface. */
void shading_prepare(const struct ray_view *view, num_length bias, const struct ray *ray, const struct hit *hit,
                     struct shading *s);

/* Returns the direction of the mirrored ray. */
struct num_dir shading_mirrored(const struct shading *s);

/* Computes the direction of the refracted ray. Returns the reflectance by Fresnel's equations. In total reflection,
 * returns 1 and does not set *refracted. */
num_unit shading_refract(const struct shading *s, struct boundary between, struct num_dir *refracted);

#endif
